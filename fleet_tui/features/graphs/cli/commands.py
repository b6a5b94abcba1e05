"""The `graph` commands' options. Exit codes 0: fine, 1: findings or a difference, 2: unreadable."""

import sys
from collections.abc import Callable
from functools import wraps
from typing import Any

import click

from fleet_tui.cli.offers import one_of
from fleet_tui.cli.options import FileName, NearestGroup, NumberRange, merged, without_config
from fleet_tui.text.errors import GraphError, MapError
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

FORMATS = ("native", "oh", "rmf", "rmf-building", "rmf-site", "geojson", "lif", "opentcs")
WRITABLE = ("native", "oh", "rmf", "geojson", "lif")
REFUSED = 2

_READING = (
    click.option("--angles", type=click.Choice(["rad", "deg"]), help="Unit of a LIF file's angles."),
    click.option("--lengths", type=click.Choice(["m", "mm"]), help="Unit of a LIF file's lengths."),
    click.option("--vehicle-type", metavar="NAME", help="Vehicle type of a LIF file."),
    click.option(
        "--building-graph",
        type=click.IntRange(0, 8),
        metavar="N",
        help="Graph of an RMF building with several.",
    ),
    click.option(
        "--floor", metavar="NAME", help="Take one floor; the floor's name where the format has none."
    ),
)


@click.group(cls=NearestGroup)
def graph() -> None:
    """Check, compare, convert and show route graphs. Recognises eight formats of files."""


def reading(command: Callable[..., int]) -> Callable[..., None]:
    """Add the options that say how a file is read; the command's answers are made of them."""

    @wraps(command)
    def run(config_file: str | None, debug: bool, **options: Any) -> None:
        from fleet_tui.features.graphs.cli.answers import GraphAnswers, is_terminal

        given = {name: options.pop(name) for name in ("floor", "vehicle_type", "lengths", "angles")}
        texts = {name: value or "" for name, value in given.items()}
        answers = GraphAnswers(
            **texts, building_graph=options.pop("building_graph"), is_terminal=is_terminal()
        )
        try:
            code = command(answers=answers, **options)
        except (GraphError, MapError) as problem:
            click.echo(sanitize(f"fleet-tui: {truncate(str(problem))}"), err=True)
            code = REFUSED
        sys.exit(code)

    decorated: Callable[..., None] = without_config(merged(run))
    for option in _READING:
        decorated = option(decorated)
    return decorated


def from_format(command: Callable[..., None]) -> Callable[..., None]:
    return click.option(
        "--from", "wanted", type=click.Choice(FORMATS), help="Format of the file; else recognised by content."
    )(command)


@graph.command()
@click.argument("file", type=FileName())
@click.option("--map", "map_file", type=FileName(), help="Also check against this map image.")
@click.option(
    "--width",
    type=NumberRange(0.0, 100.0),
    default=0.6,
    show_default=True,
    metavar="METRES",
    help="Width of the robot, for --map.",
)
@from_format
@reading
def lint(**options: Any) -> int:
    """List errors and warnings of a graph file, then their numbers. Exit code 0: none, 1: findings, 2:
    unreadable."""
    from fleet_tui.features.graphs.cli.lint import lint as run

    return run(click.echo, **options)


@graph.command()
@click.argument("before", metavar="A", type=FileName())
@click.argument("after", metavar="B", type=FileName())
@reading
def diff(**options: Any) -> int:
    """List the changes from graph file A to B, by id. Exit code 0: none, 1: a difference, 2: unreadable."""
    from fleet_tui.features.graphs.cli.lint import diff as run

    return run(click.echo, **options)


@graph.command()
@click.argument("source", metavar="IN", type=FileName())
@click.argument("target", metavar="OUT", type=FileName())
@click.option(
    "--to",
    type=click.Choice(FORMATS),  # the answer to the others says that they can only be read
    metavar=f"[{'|'.join(WRITABLE)}]",
    shell_complete=one_of(WRITABLE),
    help="Format to write; else by OUT.",
)
@from_format
@reading
def convert(**options: Any) -> int:
    """Write a graph file in another format. Its losses are listed on stderr first. An existing OUT is kept as
    OUT.bak. Exit code 0: written, 1: the format refuses the graph, 2: unreadable."""
    from fleet_tui.features.graphs.cli.convert import convert as run

    return run(click.echo, **options)


@graph.command()
@click.argument("file", type=FileName())
@click.option("--map", "map_file", type=FileName(), help="Draw over this map image.")
@from_format
@reading
def show(**options: Any) -> int:
    """Print the graph in braille. Exit code 0: printed, 2: unreadable."""
    from fleet_tui.features.graphs.cli.show import show as run

    return run(click.echo, **options)
