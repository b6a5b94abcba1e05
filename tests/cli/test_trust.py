"""A configuration of another user at the command line: what it names does not run until a person says so."""

from pathlib import Path

from tests.support.cli import run
from tests.support.users import give, two_users

pytestmark = two_users
SITE = """
[[floors]]
name = "floor_0"
[[robots]]
name = "robot_0"
[[programs]]
name = "bridge"
start = ["true"]
stop = ["true"]
status = ["touch", "RAN"]
"""


def config(folder: Path) -> tuple[Path, Path]:
    """Return a configuration of another user, and the file that its program makes."""
    path, ran = folder / "config.toml", folder / "ran"
    path.write_text(SITE.replace("RAN", str(ran)))
    give(path)
    return path, ran


async def test_no_program_of_it_runs_and_the_line_says_why(tmp_path: Path) -> None:
    path, ran = config(tmp_path)
    ended = await run(tmp_path, "programs")
    assert ended.code == 2 and not ran.exists()
    assert f"{path} is not owned by root: chown root {path}; or --trust-config trusts what" in ended.err
    ended = await run(tmp_path, "--trust-config", "programs")
    assert ended.code == 0 and ran.exists() and ended.err == ""
    ran.unlink()
    assert (await run(tmp_path, "programs")).code == 0 and ran.exists()  # it is remembered
    ran.unlink()
    path.write_text(path.read_text() + "# changed\n")
    assert (await run(tmp_path, "programs")).code == 2 and not ran.exists()


async def test_check_says_it_and_routines_are_refused(tmp_path: Path) -> None:
    path, _ = config(tmp_path)
    (tmp_path / "routines").mkdir()
    (tmp_path / "routines" / "day.routine").write_text("robot_0: Base\n")
    ended = await run(tmp_path, "check")
    assert ended.code == 0 and f"credentials: {path} is not owned by root" in ended.err
    ended = await run(tmp_path, "routine", "run", "day")
    assert ended.code == 2 and "is not owned by root" in ended.err
    ended = await run(tmp_path, "routine", "check", "day", "--trust-config", "--timeout", "0.1")
    assert "is not owned" not in ended.err


async def test_the_option_works_before_and_after_the_command(tmp_path: Path) -> None:
    path, _ = config(tmp_path)
    assert (await run(tmp_path, "check", "--trust-config", str(path))).err == ""
