"""Fixtures of the command line's tests."""

from pathlib import Path

import pytest

from fleet_tui.simulator.server import RosbridgeServer
from tests.headless.running import config_file


@pytest.fixture
def folder(server: RosbridgeServer, tmp_path: Path) -> Path:
    """A config for two robots on two floors, in which what is not answered or seen ends soon."""
    text = "[alarms]\nno_answer_after = 1.0\nnot_confirmed_after = 1.0\n"
    path = config_file(tmp_path, server.url, 2, 2)
    path.write_text(text + path.read_text())
    return tmp_path
