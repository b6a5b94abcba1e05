"""The command that serves the console: what it refuses before it serves."""

import os
import socket
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from fleet_tui.config import rights
from fleet_tui.features.serve.cli import serve
from fleet_tui.text.errors import NoConfigError
from tests.support.cli import config_file, run


async def test_a_taken_port_is_said(tmp_path: Path) -> None:
    config_file(tmp_path, "ws://127.0.0.1:1")
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        ended = await run(tmp_path, "serve", "--port", str(port))
    assert ended.code == 1
    assert f"127.0.0.1 port {port}" in ended.err and "--port 0" in ended.err


async def test_what_is_wrong_with_the_config_is_said_before_anything_is_served(tmp_path: Path) -> None:
    config_file(tmp_path, "ws://127.0.0.1:1").write_text("[rosbridge]\nur = 3\n")
    ended = await run(tmp_path, "serve", "--port", "0")
    assert ended.code == 2 and "did you mean" in ended.err and not ended.out


async def test_what_is_wrong_with_an_address_is_said_before_a_tab_is_open(tmp_path: Path) -> None:
    dead = await run(tmp_path, "serve", "--port", "0", "--url", "ws://127.0.0.1:9")
    assert (dead.code, dead.out) == (3, "") and "connection refused" in dead.err


def served(monkeypatch: pytest.MonkeyPatch, *args: str) -> tuple[list[str], str]:
    """The command that each tab would run, and what is said before."""
    told: list[list[str]] = []
    monkeypatch.setattr("fleet_tui.features.serve.run.run", lambda command, *_: told.append(command))
    found = CliRunner().invoke(serve, args)
    assert found.exit_code == 0, found.output
    (command,) = told
    assert command[:4] == [sys.executable, "-P", "-m", "fleet_tui"]
    return command[4:], found.stderr


def test_a_tab_watches_unless_commands_are_allowed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = str(config_file(tmp_path, "ws://127.0.0.1:1"))
    command, said = served(monkeypatch, "--config", path)
    assert command == ["--config", path, "--read-only"] and said.startswith("read-only")
    command, said = served(monkeypatch, "--config", path, "--allow-commands", "--drawing", "ascii", "--debug")
    assert command == ["--config", path, "--debug", "--drawing", "ascii"]
    assert said == "Commands allowed: every tab can command the robots.\n"


def test_who_may_only_view_is_told_that_no_tab_commands(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tmp_path.chmod(0o755)
    rights_file = tmp_path / "rights.toml"
    rights_file.write_text('[dispatch]\nusers = ["nobody else"]\n')
    rights_file.chmod(0o644)
    monkeypatch.setattr(rights, "FILE", rights_file)
    monkeypatch.setattr(rights, "OWNER", os.getuid())
    path = str(config_file(tmp_path, "ws://127.0.0.1:1"))
    said = served(monkeypatch, "--config", path, "--allow-commands")[1]
    assert said == "not allowed: dispatch: no tab can command the robots.\n"


def test_a_demo_needs_no_configuration(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.delenv("FLEET_TUI_CONFIG", raising=False)
    assert served(monkeypatch, "--demo")[0] == ["demo", "--read-only"]
    assert isinstance(CliRunner().invoke(serve, []).exception, NoConfigError)


@pytest.mark.parametrize("other", [["--demo"], ["--config", "x.toml"]])
def test_an_address_is_a_fleet_of_its_own(other: list[str]) -> None:
    found = CliRunner().invoke(serve, ["--url", "ws://a:1", *other])
    assert found.exit_code == 2 and f"{other[0]} and --url exclude each other" in found.stderr
