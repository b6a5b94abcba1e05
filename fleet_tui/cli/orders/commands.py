"""Commands to robots on the command line."""

import sys
from collections.abc import Callable, Sequence
from functools import wraps
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import click

from fleet_tui.cli.offers import places, robots
from fleet_tui.cli.options import FileName, NearestGroup, NumberRange, fleet, merged
from fleet_tui.config.log_file import log_to_file
from fleet_tui.config.schema import Config
from fleet_tui.model.set_up.commands import MOST_SETTLES

F = TypeVar("F", bound=Callable[..., Any])

NEGATIVE = {"ignore_unknown_options": True}
"""A negative number is no option."""
TIMEOUT = 15.0
DRIVE_TIMEOUT = 3600.0
WAITS = {
    "order": f"{TIMEOUT:.0f} by default, {DRIVE_TIMEOUT:.0f} with --until-done",
    "run": f"{TIMEOUT:.0f} for each line by default",
}
"""The usual time limits of commands whose limit is not the usual one of all."""
ALL = "all"


@click.group(cls=NearestGroup)
def orders() -> None:
    """Group of the commands, which the command line lists as its own."""


class OrderOptions(NamedTuple):
    """The options of every command here."""

    config_file: str | None
    url: str | None
    debug: bool
    as_json: bool
    yes: bool
    timeout: float | None

    def start(self) -> Config:
        """Load the configuration, and log to the file."""
        from fleet_tui.cli.chosen import chosen_to_command

        log_to_file(self.debug)
        return chosen_to_command(self.config_file, self.url)


def _takes_options(command: Callable[..., None]) -> Callable[..., None]:
    """Add the options that all commands to robots share, passed as one argument `options`."""

    @wraps(command)
    def run_with_options(**given: Any) -> None:
        options = OrderOptions(**{name: given.pop(name) for name in OrderOptions._fields})
        command(**given, options=options)

    return _options(fleet(merged(run_with_options)), WAITS.get(command.__name__, f"{TIMEOUT:.0f} by default"))


def _options(command: F, usual: str) -> F:
    limits = NumberRange(0.1, 86400)
    text = f"Maximum seconds to wait: {usual}."
    schema = "Print JSON; schema in `fleet-tui docs commands`."
    command = click.option("--timeout", type=limits, metavar="SECONDS", help=text)(command)
    command = click.option("--yes", is_flag=True, help="Send in spite of warnings.")(command)
    return click.option("--json", "as_json", is_flag=True, help=schema)(command)


def _give(words: Sequence[str], options: OrderOptions, until_done: bool = False) -> None:
    from fleet_tui.cli.orders.giving import command, how

    config = options.start()
    seconds = options.timeout or (DRIVE_TIMEOUT if until_done else TIMEOUT)
    sys.exit(
        command(config, words, how(config, seconds, options.yes, until_done), options.as_json, click.echo)
    )


@orders.command()
@click.argument("robot", shell_complete=robots)
@click.argument("places", nargs=-1, required=True, metavar="FROM TO [TO ...]", shell_complete=places)
@click.option("--until-done", is_flag=True, help="Wait until the order is done, not only queued.")
@_takes_options
def order(robot: str, places: tuple[str, ...], until_done: bool, options: OrderOptions) -> None:
    """Place an order and wait until it is in the queue. A B means A -> B; TO alone starts at the robot's
    position. A B C means A -> B and B -> C, or one order with three stops if the robot supports that. A place
    is a label or a vertex id (id=7 is always an id)."""
    _give(["order", robot, *places], options, until_done)


@orders.command()
@click.argument("robot", shell_complete=robots)
@click.argument("id", metavar="ID")
@_takes_options
def cancel(robot: str, id: str, options: OrderOptions) -> None:
    """Cancel one order of a robot. `goal` as the ID cancels a goal beside its queue."""
    _give(["cancel", robot, id], options)


@orders.command()
@click.argument("robot", shell_complete=robots)
@_takes_options
def clear(robot: str, options: OrderOptions) -> None:
    """Clear all orders of a robot."""
    _give(["clear", robot], options)


@orders.command(context_settings=NEGATIVE)
@click.argument("robot", shell_complete=robots)
@click.argument("place", nargs=-1, required=True, metavar="PLACE | X Y [YAW]", shell_complete=places)
@_takes_options
def goto(robot: str, place: tuple[str, ...], options: OrderOptions) -> None:
    """Send a robot without orders to a place or a pose. A place is a label or a vertex id; a pose is in
    metres and degrees counter-clockwise. Refused on occupied and unknown ground."""
    _give(["goto", robot, *place], options)


@orders.command("set-pose", context_settings=NEGATIVE)
@click.argument("robot", shell_complete=robots)
@click.argument("x")
@click.argument("y")
@click.argument("yaw")
@_takes_options
def set_pose(robot: str, x: str, y: str, yaw: str, options: OrderOptions) -> None:
    """Tell a standing robot its pose on the map. X and Y in metres, YAW in degrees counter-clockwise. Sent
    with --yes, or after a question."""
    _give(["set-pose", robot, x, y, yaw], options)


@orders.command()
@click.argument("robot", shell_complete=robots)
@_takes_options
def localise(robot: str, options: OrderOptions) -> None:
    """Let a standing robot search its pose on the whole map. Sent with --yes, or after a question."""
    _give(["localise", robot], options)


@orders.command()
@click.argument("robot", shell_complete=robots)
@click.argument("calls", type=click.IntRange(1, MOST_SETTLES), default=MOST_SETTLES)
@_takes_options
def settle(robot: str, calls: int, options: OrderOptions) -> None:
    """Let a robot refine its pose without moving. Up to 5 CALLS, until it no longer changes."""
    _give(["settle", robot, str(calls)], options)


@orders.command()
@click.argument("robot", shell_complete=robots)
@click.argument("mode", type=click.Choice(["on", "off"]))
@_takes_options
def mapping(robot: str, mode: str, options: OrderOptions) -> None:
    """Switch the mapping mode of a robot. Sent with --yes, or after a question."""
    _give(["mapping", robot, mode], options)


@orders.command("store-map")
@click.argument("robot", shell_complete=robots)
@click.argument("name")
@_takes_options
def store_map(robot: str, name: str, options: OrderOptions) -> None:
    """Let a robot save its map as NAME on its own disk. Sent with --yes, or after a question."""
    _give(["store-map", robot, name], options)


@orders.command("store-pose-graph")
@click.argument("robot", shell_complete=robots)
@click.argument("name")
@_takes_options
def store_pose_graph(robot: str, name: str, options: OrderOptions) -> None:
    """Let a robot save the pose graph of its map as NAME. Sent with --yes, or after a question."""
    _give(["store-pose-graph", robot, name], options)


def _which(robot: str | None, every: bool) -> str:
    if every is (robot is not None):
        both = "give the robot's name or --all, not both"
        raise click.UsageError(both if every else "missing robot: give its name, or --all")
    return robot or ALL


def _fleet(command: F) -> F:
    """Add `ROBOT` and `--all`."""
    command = click.option("--all", "every", is_flag=True, help="Address all robots.")(command)
    return click.argument("robot", required=False, shell_complete=robots)(command)


@orders.command()
@_fleet
@_takes_options
def pause(robot: str | None, every: bool, options: OrderOptions) -> None:
    """Pause a robot, or all robots with --all. Not a safety device."""
    from fleet_tui.cli.orders.giving import how
    from fleet_tui.cli.orders.giving import pause as run

    name, config = _which(robot, every), options.start()
    sys.exit(
        run(config, name, how(config, options.timeout or TIMEOUT, options.yes), options.as_json, click.echo)
    )


@orders.command()
@_fleet
@_takes_options
def resume(robot: str | None, every: bool, options: OrderOptions) -> None:
    """Resume a robot, or all robots with --all."""
    _give(["resume", _which(robot, every)], options)


@orders.command()
@click.argument("file", type=FileName(allow_dash=True))
@click.option("--dry-run", is_flag=True, help="Show the commands without sending them.")
@click.option("--keep-going", is_flag=True, help="Continue after a failed command.")
@_takes_options
def run(file: str, dry_run: bool, keep_going: bool, options: OrderOptions) -> None:
    """Send the commands of a file, one after the other. One per line, as typed in the console's palette
    (robot_0 Base > Store, cancel robot_0 12, pause all). If FILE is -, read standard input. A line that
    begins with # is a comment. If a line is invalid, nothing is sent."""
    from fleet_tui.cli.orders.batch import lines_of, run_batch
    from fleet_tui.cli.orders.giving import how

    config, lines = options.start(), lines_of(_text(file))
    limits = how(config, options.timeout or TIMEOUT, options.yes)
    sys.exit(run_batch(config, lines, limits, dry_run, keep_going, options.as_json, click.echo))


def _text(file: str) -> str:
    """Return the text of a file. Raises click's UsageError if it can't be read."""
    try:
        data = sys.stdin.buffer.read() if file == "-" else Path(file).read_bytes()
        return data.decode()
    except OSError as problem:
        raise click.UsageError(f"{file}: {problem.strerror}") from None
    except UnicodeDecodeError:
        raise click.UsageError(f"{file}: not UTF-8 text") from None
