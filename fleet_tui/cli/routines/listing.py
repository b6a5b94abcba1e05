"""`fleet-tui routine list`: the routines with their states."""

import json
from datetime import UTC, datetime

from msgspec import Struct

from fleet_tui.cli.orders.outcome import DONE, NOT_DONE
from fleet_tui.cli.routines.reading import Say
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.errors import RoutineError
from fleet_tui.log_file import state_folder
from fleet_tui.routines.files import RoutineFile, folder_of, read_routine, routine_names
from fleet_tui.routines.owner import owner_of
from fleet_tui.routines.progress import load_progress, progress_path
from fleet_tui.rules.routines.checking import robots_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import counted
from fleet_tui.view.routines.lines import summary_word

VERSION = 1


class RoutineRow(Struct, frozen=True):
    """A routine in the list; `last`: ISO 8601 time of its last change, empty if it never ran; `owner`: who
    leads its robots now."""

    name: str
    times: list[str] = []
    robots: list[str] = []
    state: str = ""
    last: str = ""
    owner: str = ""
    problem: str = ""


def list_routines(config: Config, as_json: bool, say: Say) -> int:
    """Print the routines; return the exit code."""
    folder = folder_of(config)
    rows = [routine_row(config, name) for name in routine_names(folder)]
    if as_json:
        fields = ("name", "times", "robots", "state", "last", "owner", "problem")
        shown = [{field: getattr(row, field) for field in fields} for row in rows]
        say(json.dumps({"version": VERSION, "folder": str(folder), "routines": shown}))
    elif not rows:
        say(sanitize(f"no routine in {folder}: create NAME.routine there, see docs/routines.md"))
    else:
        width = max(len(row.name) for row in rows)
        for row in rows:
            parts = (", ".join(row.times) or "no time", ", ".join(row.robots), _state(row), row.problem)
            say(sanitize(f"{row.name:<{width}}  " + "; ".join(part for part in parts if part)))
    return NOT_DONE if any(row.problem for row in rows) else DONE


def _state(row: RoutineRow) -> str:
    if not row.state:
        return "never run"
    when = datetime.fromisoformat(row.last).astimezone()
    return f"{row.state} {when:%m-%d %H:%M}" + (f" by {row.owner}" if row.owner else "")


def routine_row(config: Config, name: str) -> RoutineRow:
    """Return a routine as far as it can be read, with its saved progress."""
    try:
        file = read_routine(folder_of(config), name)
    except RoutineError as unreadable:
        return RoutineRow(name, problem=str(unreadable))
    robots = robots_of(initial_state(config, 0.0), file.parsed.routine)
    found = file.parsed.problems
    problem = f"line {found[0].line}: {found[0].text}" if found else ""
    if len(found) > 1:
        problem += f", and {counted(len(found) - 1, 'more problem')}"
    times = [schedule.text for schedule in file.parsed.routine.schedules]
    return _with_progress(config, file, RoutineRow(name, times, robots, problem=problem))


def _with_progress(config: Config, file: RoutineFile, row: RoutineRow) -> RoutineRow:
    folder = state_folder() / "routines"
    progress = load_progress(progress_path(folder, file.path))
    if progress is None:
        return row
    urls = bridge_urls(config)
    owners = (owner_of(folder, lane.robot, urls.get(lane.robot, "")) for lane in progress.lanes)
    owner = "" if progress.is_over else next((one for one in owners if one), "")
    state = summary_word(progress.lanes)
    if not owner and not progress.is_over:
        state = "held"  # the process that led it has ended
    last = datetime.fromtimestamp(progress.at, UTC).isoformat(timespec="seconds")
    return RoutineRow(row.name, row.times, row.robots, state, last, owner, row.problem)


def bridge_urls(config: Config) -> dict[str, str]:
    """Return the URL of each robot's bridge."""
    return {robot.name: config.bridges[robot.link].shown for robot in config.robots}
