"""Units of systemd: written to the user's folder, with nothing that systemd reads in another way."""

from pathlib import Path

import msgspec
import pytest

from fleet_tui.features.routines.files import RoutineFile, read_routine
from fleet_tui.features.routines.units import install, unit_files
from fleet_tui.text.errors import RoutineError
from tests.support.routines import MORNING


def named(folder: Path, text: str) -> RoutineFile:
    (folder / "morning.routine").write_text(text)
    return read_routine(folder, "morning")


def test_the_units_name_the_program_the_configuration_and_the_times(tmp_path: Path) -> None:
    text = "every day 05:00\nevery sunday 7:05\n" + MORNING
    units = unit_files(named(tmp_path, text), Path("/site a/50% $x.toml"))
    assert list(units) == ["fleet-tui-routine-morning.service", "fleet-tui-routine-morning.timer"]
    service, timer = units.values()
    (command,) = [line for line in service.splitlines() if line.startswith("ExecStart=")]
    assert command.startswith('ExecStart="/')
    assert command.endswith('"--config" "/site a/50%% $$x.toml" "routine" "run" "morning"')
    assert [line for line in timer.splitlines() if line.startswith("OnCalendar=")] == [
        "OnCalendar=*-*-* 05:00:00",
        "OnCalendar=Sun *-*-* 07:05:00",
        "OnCalendar=Mon..Fri *-*-* 06:30:00",
    ]


def test_they_are_written_to_the_users_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    units = unit_files(named(tmp_path, MORNING), tmp_path / "config.toml")
    paths = install(units)
    assert [path.parent for path in paths] == [tmp_path / "config/systemd/user"] * 2
    assert {path.name: path.read_text() for path in paths} == units


def test_what_cannot_be_installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = named(tmp_path, MORNING)
    without = msgspec.structs.replace(file.parsed.routine, schedules=())
    parsed = msgspec.structs.replace(file.parsed, routine=without)
    with pytest.raises(RoutineError, match="has no time: begin the file with"):
        unit_files(msgspec.structs.replace(file, parsed=parsed), tmp_path / "config.toml")
    with pytest.raises(RoutineError, match="a unit can't hold this path"):
        unit_files(file, Path("/a\nb/config.toml"))
    (tmp_path / "taken").write_text("")
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "taken"))
    with pytest.raises(RoutineError, match="use --print"):
        install(unit_files(file, tmp_path / "config.toml"))
