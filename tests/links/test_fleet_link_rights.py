"""The last gate: a user without the right sends nothing, whatever asks for it."""

import os
from pathlib import Path

import pytest

from fleet_tui.config import rights
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.geometry import Pose
from fleet_tui.model.set_up.commands import SetPose
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.errors import CommandError
from tests.support.links import finished, linked, ready
from tests.support.watched_store import config_of


def allow(file: Path, table: str) -> None:
    file.write_text(f'[{table}]\nusers = ["{rights.own_user()}"]\n')


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the file of rights in this test, which names nobody."""
    tmp_path.chmod(0o755)
    monkeypatch.setattr(rights, "FILE", tmp_path / "rights.toml")
    monkeypatch.setattr(rights, "OWNER", os.getuid())
    (tmp_path / "rights.toml").touch(0o644)
    return tmp_path / "rights.toml"


async def test_without_the_right_not_even_a_pause_leaves(server: RosbridgeServer, file: Path) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, PauseRobot("robot_0"))
        assert (record.stage, record.detail) == (Stage.NOT_SENT, "not allowed: dispatch")
        with pytest.raises(CommandError, match="not allowed: setup"):
            link.drive("robot_0")
    assert server.bridge.services.calls == []


async def test_who_dispatches_does_not_set_up(server: RosbridgeServer, file: Path) -> None:
    allow(file, "dispatch")
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        record = await finished(link, store, SetPose("robot_0", "floor_0", Pose(0.0, 0.0)))
        assert (record.stage, record.detail) == (Stage.NOT_SENT, "not allowed: setup")
