"""`fleet-tui programs` on the command line."""

from pathlib import Path

from tests.support.command_line import run

FLEET = '[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n'
PROGRAM = '[[programs]]\nname = "nav"\n'
PROGRAM += 'start = ["touch", "runs"]\nstop = ["rm", "runs"]\nstatus = ["test", "-e", "runs"]\n'


def test_list_start_log_and_stop(tmp_path: Path) -> None:
    (tmp_path / "config.toml").write_text(
        FLEET + PROGRAM + 'log = ["printf", "\\\\033]0;x\\\\007line\\\\n"]\n'
    )
    assert run("programs", cwd=tmp_path).returncode == 0
    assert run("programs", "start", "nav", "--yes", cwd=tmp_path).stdout == "nav: start confirmed\n"
    assert "running" in run("programs", "--json", cwd=tmp_path).stdout
    assert run("programs", "log", "nav", cwd=tmp_path).stdout == "␛]0;x␇line\n"
    assert run("programs", "stop", "nav", "--yes", cwd=tmp_path).returncode == 0
    assert not (tmp_path / "runs").exists()


def test_mistakes_are_usage(tmp_path: Path) -> None:
    (tmp_path / "config.toml").write_text(FLEET + PROGRAM)
    ended = run("programs", "start", "nva", "--yes", cwd=tmp_path)
    assert ended.returncode == 2 and "unknown program 'nva', did you mean nav?" in ended.stderr
    assert run("programs", "start", "nav", cwd=tmp_path).returncode == 2
    ended = run("programs", "--json", "start", "nav", cwd=tmp_path)
    assert ended.returncode == 2 and "put options after programs start" in ended.stderr


def test_a_configuration_without_programs_says_where_to_read(tmp_path: Path) -> None:
    (tmp_path / "config.toml").write_text(FLEET)
    ended = run("programs", cwd=tmp_path)
    assert ended.returncode == 2 and "no [[programs]], see: fleet-tui docs programs" in ended.stderr
    (tmp_path / "other.toml").write_text(FLEET + PROGRAM)
    for args in (("--config", "other.toml", "programs"), ("programs", "--config", "other.toml")):
        assert run(*args, cwd=tmp_path).returncode == 0
