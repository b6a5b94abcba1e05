"""`fleet-tui routine`: its commands and options."""

from pathlib import Path

from tests.support.command_line import run


def test_help_and_unknown_commands(tmp_path: Path) -> None:
    shown = run("routine", "--help", cwd=tmp_path)
    assert shown.returncode == 0
    assert all(f"\n  {name} " in shown.stdout for name in ("check", "install", "list", "run"))
    wrong = run("routine", "chek", "day", cwd=tmp_path)
    assert wrong.returncode == 2 and "did you mean check?" in wrong.stderr


def test_without_a_configuration_it_names_the_places(tmp_path: Path) -> None:
    done = run("routine", "list", cwd=tmp_path)
    assert done.returncode == 2 and "no configuration found" in done.stderr
