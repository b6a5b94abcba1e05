"""A pipe or a device where a file belongs is refused in words: opening it could keep a thread for ever."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.access import access_problems
from fleet_tui.config.load import load
from fleet_tui.config.schema import LINK_FILES, Link
from fleet_tui.links.transports.tls import tls_context
from fleet_tui.maps.images import load_floor_map
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.text.errors import ConfigError, LinkError
from fleet_tui.ui.themes import load_themes
from tests.support.watched_store import config_of

WORDS = "not a regular file"
Make = Callable[[Path], None]


def device(path: Path) -> None:
    path.symlink_to("/dev/zero")


pytestmark = [pytest.mark.parametrize("make", [os.mkfifo, device])]


def test_config(tmp_path: Path, make: Make) -> None:
    make(tmp_path / "config.toml")
    with pytest.raises(ConfigError, match=WORDS):
        load(tmp_path / "config.toml")


def test_theme(tmp_path: Path, make: Make) -> None:
    make(tmp_path / "mine.toml")
    assert [WORDS in problem for problem in load_themes(tmp_path)[1]] == [True]


def test_map(tmp_path: Path, make: Make) -> None:
    make(tmp_path / "m.png")
    make(tmp_path / "pipe.yaml")
    (tmp_path / "m.yaml").write_text("image: m.png\nresolution: 0.05\norigin: [0, 0, 0]\n")
    for name in ("m.png", "pipe.yaml", "m.yaml"):
        assert WORDS in load_floor_map("f", tmp_path / name, False).problem


@pytest.mark.parametrize("key", LINK_FILES)
def test_secrets_and_certificates_at_the_start(tmp_path: Path, make: Make, key: str) -> None:
    make(tmp_path / "file")
    link = replace(Link("wss://a"), **{key: str(tmp_path / "file")})
    assert access_problems(replace(config_of("wss://a"), rosbridge=link)) == [f"rosbridge.{key}: not a file"]


@pytest.mark.parametrize("key", ["ca_file", "client_cert", "client_key"])
def test_certificates_at_a_later_connection(tmp_path: Path, make: Make, key: str) -> None:
    make(tmp_path / "file")
    with pytest.raises(LinkError, match=f"{key}: .*{WORDS}"):
        tls_context(replace(Link("wss://a"), **{key: str(tmp_path / "file")}))


def test_audit_log(tmp_path: Path, make: Make) -> None:
    make(tmp_path / "audit.jsonl")
    with pytest.raises(OSError, match=WORDS):
        list(AuditReader(tmp_path / "audit.jsonl").newest_first())


def test_log(tmp_path: Path, make: Make) -> None:
    (tmp_path / "fleet-tui").mkdir()
    make(tmp_path / "fleet-tui" / "fleet-tui.log")
    code = "from fleet_tui.config.log_file import log_to_file; print(log_to_file(False))"
    env = {**os.environ, "XDG_STATE_HOME": str(tmp_path)}
    assert subprocess.check_output([sys.executable, "-c", code], env=env, timeout=8) == b"None\n"
