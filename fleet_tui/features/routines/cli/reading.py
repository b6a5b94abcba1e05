"""A routine named on the command line, with its problems."""

from collections.abc import Callable

import click

from fleet_tui.cli.orders.giving import await_reports
from fleet_tui.cli.orders.sending import Sending
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.schema import Config
from fleet_tui.features.routines.files import RoutineFile
from fleet_tui.features.routines.folder import RoutinePlace
from fleet_tui.features.routines.rules.checking import robots_of
from fleet_tui.text.errors import RoutineError
from fleet_tui.text.sanitize import sanitize

Say = Callable[..., None]


def place_of(config: Config) -> RoutinePlace:
    """Return the folders of the routines of a configuration."""
    return RoutinePlace(config.routine_folder, state_folder() / "routines", config.doubt)


def named_routine(config: Config, name: str) -> RoutineFile:
    """Return the file of a routine. Raises click's UsageError if it can't be read."""
    try:
        return place_of(config).read(name)
    except RoutineError as problem:
        raise click.UsageError(sanitize(str(problem))) from None


def await_robots(given: Sending, file: RoutineFile, asks: bool = True) -> list[str]:
    """Wait for the reports of a routine's robots, which they are asked for where these come seldom (`asks`),
    and return their names."""
    robots = robots_of(given.state, file.parsed.routine)
    await_reports(given, robots, bool(robots), asks)
    return robots
