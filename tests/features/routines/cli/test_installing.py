"""`fleet-tui routine install`: units in the user's folder, enabled by the user."""

from pathlib import Path

from tests.support.command_line import run
from tests.support.routine_files import ONE_ROBOT, routine


def test_it_writes_units_and_says_how_to_enable_them(tmp_path: Path) -> None:
    (tmp_path / "config.toml").write_text(ONE_ROBOT)
    routine(tmp_path, "every weekday 06:30\nfor robot_0\nwait 1 s\nend\n", "morning")
    shown = run("routine", "install", "morning", "--print", cwd=tmp_path)
    assert shown.returncode == 0 and "OnCalendar=Mon..Fri *-*-* 06:30:00" in shown.stdout
    units = tmp_path / "systemd" / "user"
    assert not units.exists()
    done = run("routine", "install", "morning", cwd=tmp_path)
    assert (
        done.returncode == 0
        and "systemctl --user enable --now fleet-tui-routine-morning.timer" in done.stdout
    )
    assert "loginctl enable-linger" in done.stdout
    service = (units / "fleet-tui-routine-morning.service").read_text()
    assert f'"{tmp_path / "config.toml"}" "routine" "run" "morning"' in service
    assert (units / "fleet-tui-routine-morning.timer").is_file()


def test_what_cannot_be_installed(tmp_path: Path) -> None:
    (tmp_path / "config.toml").write_text(ONE_ROBOT)
    routine(tmp_path, "for robot_0\nwait 1 s\nend\n", "morning")
    done = run("routine", "install", "morning", cwd=tmp_path)
    assert done.returncode == 2 and "morning has no time" in done.stderr
    routine(tmp_path, "every day 25:00\n", "bad")
    assert run("routine", "install", "bad", cwd=tmp_path).returncode == 1
