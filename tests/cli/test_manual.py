"""The manual page: complete, and read by man and mandoc without a warning."""

import re
import shutil
import subprocess
from pathlib import Path

import click
import pytest

from fleet_tui.cli.manual import manual
from fleet_tui.main import commands
from tests.support.command_line import run

ROOT = click.Context(commands, info_name="fleet-tui")


def shown(page: str) -> str:
    """The page as a reader sees it, each run of blanks as one."""
    if shutil.which("man") is None:
        pytest.skip("man is not installed")
    read = subprocess.run(["man", "-l", "-"], input=page, capture_output=True, text=True, check=True)
    assert read.stderr == ""
    return " ".join(re.sub(r"\S\x08|\x1b\[[0-9;]*m", "", read.stdout).split())


def test_every_command_with_every_option_is_on_it(tmp_path: Path) -> None:
    page = shown(run("man", cwd=tmp_path).stdout)
    for command in ("graph lint", "order", "config init", "routine run", "set-pose"):
        assert f" {command} [OPTIONS]" in page
    for option in ("--until-done", "--vehicle-type NAME", "--rotate-mb N", "--drawing [auto|braille|"):
        assert option in page
    assert "robot_0" in page
    assert page.count("Show tracebacks and log everything.") == 1


def test_it_has_examples_exit_codes_and_variables(tmp_path: Path) -> None:
    page = shown(run("man", cwd=tmp_path).stdout)
    examples, _, rest = page.partition("EXAMPLES")[2].partition("EXIT STATUS")
    assert "fleet-tui order robot_0 Base Store from Base to Store" in examples
    assert "1 the command or check failed, or something needs attention" in rest
    assert "FLEET_TUI_CONFIG the configuration" in rest.partition("ENVIRONMENT")[2]


def test_mandoc_finds_nothing_to_complain_about() -> None:
    if shutil.which("mandoc") is None:
        pytest.skip("mandoc is not installed")
    found = subprocess.run(
        ["mandoc", "-Tlint"], input=manual(ROOT), capture_output=True, text=True, check=False
    )
    assert found.stdout == ""


def test_text_that_roff_would_obey_is_printed() -> None:
    @click.command(help='.SH a line\n\n\'quoted \\fB -x "y"')
    def odd() -> None: ...

    page = shown(manual(click.Context(odd, info_name="odd")))
    assert '.SH a line \'quoted \\fB -x "y"' in page
