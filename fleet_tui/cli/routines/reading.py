"""A routine named on the command line, with its problems."""

from collections.abc import Callable
from functools import partial

import click

from fleet_tui.cli.orders.giving import await_reports
from fleet_tui.cli.orders.sending import Sending
from fleet_tui.config.schema import Config
from fleet_tui.errors import RoutineError
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.routines.blocks import RoutineProblem
from fleet_tui.routines.files import RoutineFile, folder_of, read_routine
from fleet_tui.routines.programs import program_problem
from fleet_tui.rules.routines.checking import check_routine, robots_of
from fleet_tui.text.sanitize import sanitize

Say = Callable[..., None]


def named_routine(config: Config, name: str) -> RoutineFile:
    """Return the file of a routine. Raises click's UsageError if it can't be read."""
    try:
        return read_routine(folder_of(config), name)
    except RoutineError as problem:
        raise click.UsageError(sanitize(str(problem))) from None


def await_robots(given: Sending, file: RoutineFile) -> list[str]:
    """Wait for the reports of a routine's robots, and return their names."""
    robots = robots_of(given.state, file.parsed.routine)
    await_reports(given, robots, bool(robots))
    return robots


def problems_of(state: FleetState, file: RoutineFile) -> list[RoutineProblem]:
    """Return every problem of a routine: those of its text, else those against the fleet."""
    if file.parsed.problems:
        return list(file.parsed.problems)
    return check_routine(state, file.parsed.routine, partial(program_problem, file.path.parent))
