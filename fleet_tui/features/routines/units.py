"""Units of the user's systemd that start a routine at its times."""

import shutil
import sys
from pathlib import Path

import platformdirs

from fleet_tui.features.routines.blocks import DAYS, Schedule
from fleet_tui.features.routines.files import RoutineFile
from fleet_tui.storage.whole_file import write_whole
from fleet_tui.text.errors import RoutineError
from fleet_tui.text.language import Message

SERVICE = """\
[Unit]
Description=fleet-tui routine {name}

[Service]
Type=oneshot
ExecStart={command}
"""
TIMER = """\
[Unit]
Description=Times of the fleet-tui routine {name}

[Timer]
{times}
# A start that was missed is not made up for: nothing is sent late.
Persistent=false

[Install]
WantedBy=timers.target
"""


def unit_files(file: RoutineFile, config: Path) -> dict[str, str]:
    """Return the texts of the service and the timer by file name. Raises RoutineError."""
    schedules = file.parsed.routine.schedules
    if not schedules:
        raise RoutineError(
            Message("{name} has no time: begin the file with e.g. every weekday 06:30", name=file.name)
        )
    words = [*_program(), "--config", str(config.absolute()), "routine", "run", file.name]
    if any(not word.isprintable() for word in words):
        raise RoutineError(
            Message("{config}: a unit can't hold this path: move it to one of plain letters", config=config)
        )
    unit, times = (
        f"fleet-tui-routine-{file.name}",
        "\n".join(f"OnCalendar={_calendar(one)}" for one in schedules),
    )
    return {
        f"{unit}.service": SERVICE.format(name=file.name, command=" ".join(map(_quoted, words))),
        f"{unit}.timer": TIMER.format(name=file.name, times=times),
    }


def install(units: dict[str, str]) -> list[Path]:
    """Write the units to the user's folder, and return their paths. Raises RoutineError."""
    folder = platformdirs.user_config_path("systemd") / "user"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in units.items():
            write_whole(folder / name, text.encode(), is_shared=True)
    except OSError as problem:
        raise RoutineError(
            Message(
                "{folder}: {strerror}: make it writable, or use --print",
                folder=folder,
                strerror=problem.strerror,
            )
        ) from None
    return [folder / name for name in units]


def _program() -> list[str]:
    """Return the absolute path of this program, not that of a service's PATH."""
    beside = Path(sys.executable).with_name("fleet-tui")
    found = str(beside) if beside.is_file() else shutil.which("fleet-tui")
    return [str(Path(found).absolute())] if found else [sys.executable, "-P", "-m", "fleet_tui"]


def _quoted(word: str) -> str:
    """Return a word as systemd reads it in a command: % and $ have meanings there."""
    for letter, written in (("\\", "\\\\"), ('"', '\\"'), ("%", "%%"), ("$", "$$")):
        word = word.replace(letter, written)
    return f'"{word}"'


def _calendar(schedule: Schedule) -> str:
    days = {tuple(range(7)): "", tuple(range(5)): "Mon..Fri "}
    day = days.get(schedule.days, f"{DAYS[schedule.days[0]][:3].capitalize()} ")
    return f"{day}*-*-* {schedule.at.text}:00"
