"""The examination of a routine before it starts."""

from functools import partial
from time import time

from msgspec import Struct

from fleet_tui.features.routines.blocks import RoutineProblem
from fleet_tui.features.routines.clock import next_time
from fleet_tui.features.routines.files import RoutineFile
from fleet_tui.features.routines.folder import RoutinePlace, plans_of
from fleet_tui.features.routines.lines import problem_line, timeline_lines, timeline_totals
from fleet_tui.features.routines.programs import program_problem
from fleet_tui.features.routines.rules.checking import check_routine
from fleet_tui.features.routines.rules.timeline import TimelineEntry, timeline
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.errors import RoutineError
from fleet_tui.text.language import Message, joined
from fleet_tui.text.limits import some
from fleet_tui.text.sanitize import sanitize

SHOWN = 8
"""Robots in the question."""


class Examined(Struct, frozen=True):
    """A routine with its problems, else with its timeline and a line for each robot; `file` is None if it
    can't be read."""

    file: RoutineFile | None
    robots: tuple[str, ...] = ()
    problems: tuple[str, ...] = ()
    timeline: tuple[str, ...] = ()
    totals: tuple[str, ...] = ()

    def question(self, is_left: bool) -> Message:
        """Return the question before it starts, or continues where it left off."""
        assert self.file is not None
        robots = sanitize(Message("{name} with {some}", name=self.file.name, some=some(self.robots)))
        if is_left:
            return Message(
                "Continue {robots}? It is held until it is resumed; orders that still run are followed.",
                robots=robots,
            )
        more = (
            [Message("and {count} more robots", count=len(self.totals) - SHOWN)]
            if len(self.totals) > SHOWN
            else []
        )
        return joined("\n", [Message("Start {robots}?", robots=robots), *self.totals[:SHOWN], *more])


def problems_of(state: FleetState, file: RoutineFile) -> list[RoutineProblem]:
    """Return every problem of a routine: those of its text, else those against the fleet."""
    if file.parsed.problems:
        return list(file.parsed.problems)
    return check_routine(state, file.parsed.routine, partial(program_problem, file.path.parent))


def timeline_of(state: FleetState, file: RoutineFile) -> list[TimelineEntry]:
    """Return the timelines of all robots, if they start now."""
    now, plans = time(), plans_of(state, file)
    found = [timeline(state.robots[name], plan, now, next_time) for name, plan in plans.items()]
    return [entry for entries in found for entry in entries]


def examine(place: RoutinePlace, state: FleetState, name: str) -> Examined:
    """Read and check a routine."""
    try:
        file = place.read(name)
    except RoutineError as problem:
        return Examined(None, problems=(sanitize(str(problem)),))
    robots = tuple(plans_of(state, file))
    if found := problems_of(state, file):
        return Examined(file, robots, tuple(problem_line(name, problem) for problem in found))
    entries = timeline_of(state, file)
    return Examined(file, robots, (), tuple(timeline_lines(entries)), tuple(timeline_totals(entries)))
