"""Options of all commands: before and after a command's name, and never empty."""

from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from fleet_tui.cli.options import NearestGroup, NumberRange, fleet, with_url
from tests.support.command_line import run

GOOD = '[[floors]]\nname = "floor_0"\n[[robots]]\nname = "robot_0"\n'


@pytest.mark.parametrize(
    "args", [("--config", "mine.toml", "check"), ("check", "--config", "mine.toml"), ("check", "mine.toml")]
)
def test_the_config_is_taken_before_and_after_the_command(tmp_path: Path, args: tuple[str, ...]) -> None:
    (tmp_path / "mine.toml").write_text(GOOD)
    done = run(*args, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (0, "mine.toml: valid: 1 robot, 1 floor\n")


@pytest.mark.parametrize(
    "args", [["record"], ["replay"], ["run"], ["check"], ["--config"], ["status", "--config"]]
)
def test_what_an_unset_variable_leaves_is_no_file(tmp_path: Path, args: list[str]) -> None:
    done = run(*args, "", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "") and "empty file name" in done.stderr


@pytest.mark.parametrize("words", ["sim", "map place", "map info", "graph lint", "kinds", "audit"])
def test_where_a_configuration_has_no_effect_it_is_not_offered(tmp_path: Path, words: str) -> None:
    """It is accepted there all the same: scripts give it to every command."""
    done = run(*words.split(), "--config", "mine.toml", "--help", cwd=tmp_path)
    assert done.returncode == 0 and "--config" not in done.stdout


def test_each_command_tells_its_own_time_limit(tmp_path: Path) -> None:
    said = {
        name: " ".join(run(name, "--help", cwd=tmp_path).stdout.split()) for name in ("order", "goto", "run")
    }
    assert "15 by default, 3600 with --until-done." in said["order"]
    assert "15 by default." in said["goto"] and "3600" not in said["goto"]
    assert "15 for each line by default." in said["run"]


@pytest.mark.parametrize("group", ["graph", "map", "routine", "config"])
def test_a_group_without_a_command_prints_its_help_alone(tmp_path: Path, group: str) -> None:
    done = run(group, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == run(group, "--help", cwd=tmp_path).stdout


def test_an_option_that_a_command_would_ignore_is_refused(tmp_path: Path) -> None:
    done = run("--read-only", "check", cwd=tmp_path)
    assert done.returncode == 2
    assert "--read-only is not an option of check" in done.stderr


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        (["ws://a:9090"], ["--url=ws://a:9090"]),
        (["--read-only", "ws://a:9090", "status"], ["--read-only", "--url=ws://a:9090", "status"]),
        (["--drawing", "ascii", "ws://a"], ["--drawing", "ascii", "--url=ws://a"]),
        (["--config", "ws://a"], ["--config", "ws://a"]),
        (["--config=x", "ws://a"], ["--config=x", "--url=ws://a"]),
        (["status", "ws://a"], ["status", "ws://a"]),
        (["10.0.0.7"], ["--url=10.0.0.7"]),
        (["robot-server"], ["robot-server"]),
        ([], []),
    ],
)
def test_an_address_in_place_of_a_command_is_an_option(typed: list[str], meant: list[str]) -> None:
    assert with_url(typed) == meant


@pytest.mark.parametrize("address", ["", "  "])
def test_an_empty_address_is_named_as_such(address: str) -> None:
    @click.command()
    @fleet
    def command(config_file: str | None, url: str | None, debug: bool) -> None:
        raise AssertionError(url)

    found = CliRunner().invoke(command, ["--url", address])
    assert found.exit_code == 2 and "empty address: check that the shell variable is set" in found.stderr


def test_an_unknown_command_of_a_group_is_answered_with_the_nearest() -> None:
    @click.group(cls=NearestGroup)
    def group() -> None: ...

    group.add_command(click.Command("show"))
    found = CliRunner().invoke(group, ["shwo"])
    assert found.exit_code == 2 and "unknown command 'shwo', did you mean show?" in found.stderr


@pytest.mark.parametrize("typed", ["nan", "inf", "-1"])
def test_what_is_no_number_within_the_limits_is_refused(typed: str) -> None:
    with pytest.raises(click.BadParameter):
        NumberRange(0.0).convert(typed, None, None)
    assert NumberRange(0.0).convert("0.5", None, None) == 0.5
