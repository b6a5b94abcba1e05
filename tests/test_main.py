"""The command line: exit codes, messages with remedies, no tracebacks."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.command_line import run

BAD = """
[rosbridge]
url = "http://x"
[[floors]]
name = "floor_0"
mpa = "x"
[[robots]]
name = "robot_0"
floors = ["flor_0"]
[keys]
ordr = "ctrl+o"
cancel = "o"
[ui]
theme = "drak"
"""
RECORD = (
    '{"version":1,"time":"2026-11-21T09:23:29.649+00:00","operator":"ana","console":"vm:1","run":"1",'
    '"kind":"console","what":"console","change":"opened"}\n'
)
GOOD = '[[floors]]\nname = "floor_0"\n[[robots]]\nname = "robot_0"\n'


def test_every_problem_at_once_with_the_nearest_name(tmp_path: Path) -> None:
    (tmp_path / "bad.toml").write_text(BAD)
    done = run("check", "bad.toml", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stdout == ""
    for line in (
        "bad.toml: rosbridge.url: 'http://x'",
        "bad.toml: floors[0].mpa: unknown key, did you mean map?",
        "bad.toml: robots[0].floors: unknown floor 'flor_0', did you mean floor_0?",
        "bad.toml: keys.ordr: unknown key id, did you mean order?",
        "'o' is already used by order",
    ):
        assert line in done.stderr
    assert "Traceback" not in done.stderr


def test_a_graph_file_that_is_none(tmp_path: Path) -> None:
    (tmp_path / "g.json").write_text('{"layouts": []}')
    text = GOOD.replace('"floor_0"\n[[', '"floor_0"\ngraph = "g.json"\n[[')
    (tmp_path / "config.toml").write_text(text)
    done = run("check", cwd=tmp_path)
    assert done.returncode == 2
    assert (
        "config.toml: floors[0].graph: graph g.json: has the floors none: none is called floor_0"
        in done.stderr
    )


def test_a_theme_and_a_map_that_are_not_there(tmp_path: Path) -> None:
    text = GOOD.replace('"floor_0"\n[[', '"floor_0"\nmap = "no.yaml"\n[[') + '[ui]\ntheme = "drak"\n'
    (tmp_path / "config.toml").write_text(text)
    done = run("check", cwd=tmp_path)
    assert done.returncode == 2
    assert "floors[0].map: file not found: no.yaml" in done.stderr
    assert "did you mean dark?" in done.stderr


def test_the_config_is_found_in_order(tmp_path: Path) -> None:
    (tmp_path / "fleet-tui").mkdir()
    (tmp_path / "fleet-tui" / "config.toml").write_text(GOOD)
    assert "fleet-tui/config.toml: valid" in run("check", cwd=tmp_path).stdout
    (tmp_path / "config.toml").write_text(GOOD)
    assert run("check", cwd=tmp_path).stdout.startswith("config.toml: valid")
    (tmp_path / "other.toml").write_text(GOOD)
    assert "other.toml: valid" in run("check", cwd=tmp_path, FLEET_TUI_CONFIG="other.toml").stdout


@pytest.mark.parametrize(
    ("args", "words"),
    [
        (("chekc",), "did you mean check?"),
        (("check", "no.toml"), "no such file"),
        (("demo", "--robots", "0"), "--robots"),
        (("demo", "--robot", "3"), "--robots"),
        (("sim", "--port", "99999"), "--port"),
        (("sim", "--fault", "obstcle"), "did you mean obstacle?"),
        (("demo", "--fault", "stuck:robot_9"), "did you mean robot_2?"),
    ],
)
def test_usage_errors_end_with_2_and_a_remedy(tmp_path: Path, args: tuple[str, ...], words: str) -> None:
    done = run(*args, cwd=tmp_path)
    assert done.returncode == 2
    assert words in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(
    ("line", "command"),
    [("graph lint", "fleet-tui graph lint"), ("order robot_0", "fleet-tui order"), ("--nope", "fleet-tui")],
)
def test_a_usage_error_names_the_help_of_its_command(tmp_path: Path, line: str, command: str) -> None:
    assert run(*line.split(), cwd=tmp_path).stderr.endswith(f"\nRun {command} --help for usage.\n")


def test_a_missing_argument_is_told_with_its_place(tmp_path: Path) -> None:
    usage = "Usage: fleet-tui order [OPTIONS] ROBOT FROM TO [TO ...]"
    assert usage in run("order", cwd=tmp_path).stderr.splitlines()
    assert usage not in run("order", "--nope", cwd=tmp_path).stderr


def test_the_console_without_a_terminal_says_so(tmp_path: Path) -> None:
    done = run(cwd=tmp_path)
    assert done.returncode == 1
    assert "needs a terminal" in done.stderr


@pytest.mark.parametrize("line", [["check"], ["config", "show"], ["audit"], ["doctor", "--timeout", "1"]])
def test_an_output_that_takes_nothing_is_named(tmp_path: Path, line: list[str]) -> None:
    (tmp_path / "config.toml").write_text(GOOD)
    (tmp_path / "fleet-tui").mkdir()
    (tmp_path / "fleet-tui" / "audit.jsonl").write_text(RECORD)
    command = [sys.executable, "-m", "fleet_tui", *line]
    place = {**os.environ, "XDG_STATE_HOME": str(tmp_path)}
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            command, cwd=tmp_path, env=place, stdout=full, stderr=subprocess.PIPE, text=True
        )
    assert done.returncode == 1
    assert done.stderr == "fleet-tui: cannot write the output: No space left on device\n"
    closed = ["/bin/sh", "-c", '"$@" <&- >&- 2>err', "-", *command]
    assert subprocess.run(closed, cwd=tmp_path, env=place).returncode == (3 if "doctor" in line else 0)
    assert "error" not in (tmp_path / "err").read_text()
