"""Looks at the routines of a folder: their files, and their last or present runs."""

from collections.abc import Iterable
from pathlib import Path

from msgspec import Struct

from fleet_tui.commands.language.words import find_robot
from fleet_tui.features.routines.blocks import LanePlan
from fleet_tui.features.routines.files import RoutineFile, read_routine, routine_names
from fleet_tui.features.routines.owner import owner_of
from fleet_tui.features.routines.progress import RoutineProgress, load_progress, progress_path
from fleet_tui.features.routines.row import RoutineRow
from fleet_tui.features.routines.rules.positions import fits
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.errors import CommandError, RoutineError
from fleet_tui.text.language import EMPTY, Message, counted, message_of, verbatim


class RoutinePlace(Struct, frozen=True):
    """The folders of the routines and of their progress, and the reason that none may run."""

    folder: Path
    state: Path
    refusal: Message = EMPTY

    def read(self, name: str) -> RoutineFile:
        """Return a routine by its name. Raises RoutineError."""
        if self.refusal:
            raise RoutineError(self.refusal)
        return read_routine(self.folder, name)


def look_at_all(place: RoutinePlace, state: FleetState) -> list[RoutineRow]:
    """Return every routine, as far as it can be read."""
    return [_row(place, state, name) for name in routine_names(place.folder)]


def plans_of(state: FleetState, file: RoutineFile) -> dict[str, LanePlan]:
    """Return the plan of each robot that exists, by its name."""
    found = dict[str, LanePlan]()
    for lane in file.parsed.routine.lanes:
        try:
            found.setdefault(find_robot(lane.robot, state).name, lane)
        except CommandError:
            continue
    return found


def bridge_urls(state: FleetState, robots: Iterable[str]) -> dict[str, str]:
    """Return the URL of each robot's bridge, without secrets."""
    return {robot: state.links[state.robots[robot].link].url for robot in robots}


def _row(place: RoutinePlace, state: FleetState, name: str) -> RoutineRow:
    try:
        file = place.read(name)
    except RoutineError as problem:
        return RoutineRow(name, problem=message_of(problem))
    plans, progress = plans_of(state, file), load_progress(progress_path(place.state, file.path))
    lanes = progress.lanes if progress is not None and progress.digest == file.digest else ()
    return RoutineRow(
        name,
        tuple(schedule.text for schedule in file.parsed.routine.schedules),
        plans,
        tuple(lane for lane in lanes if lane.robot in plans and fits(plans[lane.robot], lane)),
        progress.at if progress is not None else 0.0,
        _owner(place, state, progress),
        _problem(file),
    )


def _problem(file: RoutineFile) -> Message:
    found = file.parsed.problems
    more = counted(", and {count} more problem", ", and {count} more problems", len(found) - 1)
    return (
        Message(
            "line {line}: {text}{more}",
            line=found[0].line,
            text=found[0].text,
            more=more if found[1:] else "",
        )
        if found
        else EMPTY
    )


def _owner(place: RoutinePlace, state: FleetState, progress: RoutineProgress | None) -> Message:
    """Return the process that leads the robots of an open run, empty if it has ended."""
    if progress is None or progress.is_over:
        return EMPTY
    urls = bridge_urls(state, (lane.robot for lane in progress.lanes if lane.robot in state.robots))
    owners = (owner_of(place.state, robot, url) for robot, url in urls.items())
    return verbatim(next((owner for owner in owners if owner), ""))
