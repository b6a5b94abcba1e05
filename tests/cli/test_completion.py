"""Completion in real shells: the printed script asks a real `fleet-tui`."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.in_pty import Terminal

pytestmark = pytest.mark.nightly

CONFIG = '[[floors]]\nname = "floor_0"\n[[robots]]\nname = "robot_7"\n'
BASH = """
source {script}
compopt() {{ COMPREPLY+=("$2"); }}
COMP_WORDS=({words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); COMPREPLY=()
"$(complete -p fleet-tui | sed 's/.*-F \\([^ ]*\\).*/\\1/')" fleet-tui
printf '%s\\n' "${{COMPREPLY[@]}}"
"""
LINES = [
    ('fleet-tui gr""', {"graph"}),
    ('fleet-tui graph ""', {"lint", "diff", "convert", "show"}),
    ('fleet-tui graph convert --t""', {"--to"}),
    ('fleet-tui graph convert --to rmf""', {"rmf"}),
    ('fleet-tui demo --kind ""', {"oh_ressources", "nav2", "move_base", "rmf", "vda5050", "mixed"}),
    ('fleet-tui docs status""', {"status-json"}),
    ('fleet-tui completion ""', {"bash", "zsh", "fish"}),
    ('fleet-tui pause ""', {"robot_7"}),
    ('fleet-tui nothing ""', None),
]
"""Words of a line up to the cursor, and what is offered; None: anything, but without an error."""


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a configuration, and this console as `fleet-tui` on the PATH."""
    (tmp_path / "config.toml").write_text(CONFIG)
    program = tmp_path / "bin" / "fleet-tui"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m fleet_tui "$@"\n')
    program.chmod(0o755)
    root = Path(__file__).parents[2]
    monkeypatch.setenv("PATH", f"{program.parent}:{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", str(root))
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.delenv("FLEET_TUI_CONFIG", raising=False)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def script_for(shell: str, place: Path) -> Path:
    """Write the script of a shell; skip where that shell is missing."""
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    path = place / f"script.{shell}"
    with path.open("w") as file:
        subprocess.run(["fleet-tui", "completion", shell], stdout=file, check=True)
    return path


def said(*command: str) -> list[str]:
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stderr == ""
    return done.stdout.splitlines()


@pytest.mark.parametrize(("words", "offered"), LINES)
def test_bash_offers_what_the_command_takes(place: Path, words: str, offered: set[str] | None) -> None:
    script = script_for("bash", place)
    found = said("bash", "--norc", "-c", BASH.format(script=script, words=words))
    assert offered is None or set(found) == offered


def test_bash_completes_files_and_values_behind_an_equals_sign(place: Path) -> None:
    script = script_for("bash", place)

    def offered(words: str) -> list[str]:
        return said("bash", "--norc", "-c", BASH.format(script=script, words=words))

    assert offered('fleet-tui graph lint ""') == ["default"]
    assert offered("fleet-tui graph convert --to '=' geo") == ["geojson"]
    assert offered("fleet-tui graph convert --to '='") == offered('fleet-tui graph convert --to ""')


@pytest.mark.parametrize(("words", "offered"), LINES)
def test_fish_offers_what_the_command_takes(place: Path, words: str, offered: set[str] | None) -> None:
    script = script_for("fish", place)
    line = words.replace('""', "")
    found = said("fish", "--no-config", "-c", f"source {script}; complete -C '{line}'")
    assert offered is None or {one.partition("\t")[0] for one in found} == offered


def test_zsh_completes_a_typed_line(place: Path) -> None:
    script = script_for("zsh", place)
    terminal = Terminal(["zsh", "-f"], place)
    try:
        terminal.press(f"autoload -U compinit && compinit -u && source {script} && echo re''ady\n")
        terminal.wait_for("ready")
        terminal.press("fleet-tui graph con\t")
        terminal.wait_for("fleet-tui graph convert ")
        terminal.press("--to geo\t")
        terminal.wait_for("--to geojson")
        terminal.press("\x15fleet-tui pause ro\t")
        terminal.wait_for("pause robot_7")
        terminal.press("\x15exit\n")
    finally:
        terminal.close("\x04")


def test_without_a_shell_it_asks_which(place: Path) -> None:
    done = subprocess.run(["fleet-tui", "completion"], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.startswith("fleet-tui: which shell? fleet-tui completion bash, zsh or fish\n")


def test_another_shell_is_refused_by_name(place: Path) -> None:
    done = subprocess.run(["fleet-tui", "completion", "tcsh"], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "'tcsh' is not one of 'bash', 'zsh', 'fish'" in done.stderr
