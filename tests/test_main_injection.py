"""Echoes of command lines and files: control characters appear as visible text."""

import os
import subprocess
import sys
import tomllib
import unicodedata
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.hostile_fleet import ROBOTS
from tests.support.in_pty import serving

pytestmark = pytest.mark.nightly

ESC = "\x1b]52;c;eA==\x07\x9b31m\u202e"
IN_TOML = ESC.encode("unicode_escape").decode().replace("\\x", "\\u00")
FLOOR_AND_ROBOT = '[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n'
FINE = "fine\x1b[2J.toml"


def harmless(output: bytes) -> bool:
    letters = set(output.decode().replace("\n", ""))
    return not {unicodedata.category(letter) for letter in letters} & {"Cc", "Cf", "Cs", "Co", "Cn"}


def run(folder: Path, *args: str | bytes) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-m", "fleet_tui", *args],
        cwd=folder,
        env={**os.environ, "XDG_CONFIG_HOME": str(folder), "XDG_STATE_HOME": str(folder), "PYTHONUTF8": "1"},
        capture_output=True,
        stdin=subprocess.DEVNULL,
        timeout=40,
        check=False,
    )


@pytest.mark.parametrize(
    "args",
    [
        ("--config", ESC),
        (ESC,),
        (f"--{ESC}",),
        (b"\xff\xfe\x1b[2J",),
        ("--config", b"\xff\x1b[2J"),
        ("--drawing", ESC),
        ("demo", "--robots", ESC),
        ("demo", ESC),
        ("sim", "--fault", ESC),
        ("sim", "--fault", f"stuck:{ESC}"),
        ("check", ESC),
        ("check", "evil.toml"),
        ("check", "cut.toml"),
        ("check", FINE),
        ("status", "--timeout", ESC),
        ("audit", "--since", ESC),
        ("config", "show", "--config", "hostile.toml"),
        ("config", "show", "--origin", "--config", "hostile.toml"),
        ("config", "show", "--config", ESC),
        ("config", "init", "--from-live", ESC),
        ("doctor", "--config", ESC),
        ("audit", ESC),
    ],
    ids=ascii,
)
def test_what_was_given_comes_back_visible(tmp_path: Path, args: tuple[str | bytes, ...]) -> None:
    tables = "".join(
        f'[{table}]\n{key} = "{IN_TOML}"\n' for table, key in (("ui", "theme"), ("profile", "name"))
    )
    (tmp_path / "evil.toml").write_text(f'"{IN_TOML}" = 1\n{tables}')
    (tmp_path / "hostile.toml").write_text(f'[operator]\nname = "{IN_TOML}"\n{FLOOR_AND_ROBOT}')
    (tmp_path / "cut.toml").write_text(f"{ESC} = \n")
    (tmp_path / FINE).write_text(FLOOR_AND_ROBOT)
    done = run(tmp_path, *args)
    said = done.stdout + done.stderr
    assert harmless(said), said
    assert b"Traceback" not in said and said.strip()
    assert done.returncode in (0, 2, 3)


FAILS = """
import sys
import fleet_tui.config.load as load
from fleet_tui.__main__ import main

def find(given):
    raise RuntimeError("\x1b]52;c;eA==\x07 first\\n\x9b31m second")

load.find = find
sys.argv = ["fleet-tui", "--debug"]
main()
"""


def test_a_traceback_that_was_asked_for_is_visible_text(tmp_path: Path) -> None:
    env = {**os.environ, "XDG_STATE_HOME": str(tmp_path), "PYTHONUTF8": "1"}
    done = subprocess.run([sys.executable, "-c", FAILS], capture_output=True, env=env, check=False)
    assert done.returncode == 1 and done.stderr.startswith(b"Traceback") and b" second\n" in done.stderr
    assert harmless(done.stdout + done.stderr)


@pytest.fixture
def hostile(tmp_path: Path) -> Iterator[Path]:
    robots = "".join(f'[[robots]]\nname = "robot_{n}"\n' for n in range(ROBOTS))
    with serving("tests.support.hostile_fleet") as (url, _):
        floors = '[[floors]]\nname = "floor_0"\n[[floors]]\nname = "floor_1"\n'
        (tmp_path / "config.toml").write_text(f'[rosbridge]\nurl = "{url}"\n{floors}{robots}')
        yield tmp_path


@pytest.mark.parametrize("option", [(), ("--oneline",), ("--json",)], ids=str)
def test_status_of_a_hostile_fleet(hostile: Path, option: tuple[str, ...]) -> None:
    done = run(hostile, "status", "--timeout", "2", *option)
    assert done.returncode == 1 and done.stderr == b""
    assert harmless(done.stdout) and b"bad data" in done.stdout
    assert all(len(line) < 2000 for line in done.stdout.splitlines()) or "--json" in option


def test_a_configuration_made_of_what_a_hostile_bridge_has(hostile: Path) -> None:
    url = (hostile / "config.toml").read_text().split('"')[1]
    done = run(hostile, "config", "init", "--from-live", url)
    assert done.returncode == 0 and harmless(done.stdout + done.stderr)
    assert tomllib.loads(done.stdout.decode())["robots"]


def test_doctor_on_a_hostile_fleet(hostile: Path) -> None:
    done = run(hostile, "doctor")
    assert done.returncode == 1 and harmless(done.stdout + done.stderr)
    assert b"Traceback" not in done.stderr
