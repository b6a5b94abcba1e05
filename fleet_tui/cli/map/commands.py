"""`fleet-tui map info|show|save|place`. The command line imports this module when one of them is used."""

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from fleet_tui.cli.offers import files
from fleet_tui.cli.options import NearestGroup, NumberRange, merged, timeout, without_config
from fleet_tui.config.log_file import log_to_file
from fleet_tui.text.sanitize import sanitize

if TYPE_CHECKING:  # numpy
    from fleet_tui.model.grid import OccupancyGrid

VERSION = 1
WITHIN = 10.0


@click.group("map", cls=NearestGroup)
def map_group() -> None:
    """Show, save or make maps. Reads files (map_server YAML, PGM, PNG) and live maps."""


def _source(command: Callable[..., None]) -> Callable[..., None]:
    """Add `FILE|URL` and its options."""
    text = "Floor of the live map, if the bridge has several."
    command = click.option("--floor", default="", metavar="NAME", help=text)(command)
    return click.argument("source", metavar="FILE|URL", shell_complete=files)(
        timeout(WITHIN)(without_config(merged(command)))
    )


@map_group.command()
@click.option("--json", "as_json", is_flag=True, help="Print JSON; schema in `fleet-tui docs setting-up`.")
@_source
def info(
    source: str, floor: str, timeout: float, as_json: bool, config_file: str | None, debug: bool
) -> None:
    """Print size, resolution, origin and known area of a map."""
    from fleet_tui.cli.map.source import map_from
    from fleet_tui.model.set_up.survey import survey

    log_to_file(debug)
    grid, name = map_from(source, floor, timeout)
    found = survey(grid)
    x, y, yaw = found.origin
    if as_json:
        areas = {"free_m2": found.free, "occupied_m2": found.occupied, "known_m2": found.known}
        size = {"columns": found.columns, "rows": found.rows, "resolution": found.resolution}
        click.echo(json.dumps({"version": VERSION, "name": name, **size, "origin": [x, y, yaw], **areas}))
        return
    click.echo(sanitize(f"{name}: {found.text}"))
    click.echo(f"origin {x:.3f}, {y:.3f} m, {yaw:.4f} rad; free {found.free:.1f} m2")


@map_group.command()
@_source
@click.option(
    "--part",
    nargs=4,
    type=NumberRange(0.0),
    metavar="COLUMN ROW WIDTH HEIGHT",
    help="Show these pixels, from the upper left corner, with their numbers beside them.",
)
def show(
    source: str,
    floor: str,
    timeout: float,
    part: tuple[float, float, float, float] | None,
    config_file: str | None,
    debug: bool,
) -> None:
    """Print a map in braille. In ASCII where the output has no UTF-8; 80x24 without a terminal."""
    from fleet_tui.cli.map.picture import map_text, numbered_text, output_drawing, output_size
    from fleet_tui.cli.map.source import is_picture, map_file, map_from
    from fleet_tui.model.set_up.survey import survey

    log_to_file(debug)
    if is_picture(source):
        grid, name = map_file(Path(source)), Path(source).name
        size = f"{grid.frame.width} x {grid.frame.height} px, without a scale"
    else:
        grid, name = map_from(source, floor, timeout)
        size = survey(grid).text
    width, height = output_size()
    if part is None:
        text = map_text(grid, width, height - 1, output_drawing())
    else:
        text = numbered_text(grid, part, width, height - 1, output_drawing())
    click.echo(sanitize(f"{name}: {size}")[:width])
    click.echo(text)


@map_group.command()
@_source
@click.argument("out", type=click.Path(dir_okay=False, path_type=Path))
@click.option("--yes", is_flag=True, help="Replace an existing map, which stays as .bak.")
def save(
    source: str, out: Path, floor: str, yes: bool, timeout: float, config_file: str | None, debug: bool
) -> None:
    """Save a map as OUT.yaml and OUT.pgm. At full precision; the files are read back and compared."""
    from fleet_tui.cli.map.source import map_from

    log_to_file(debug)
    if not yes:
        _ask_to_replace(out)
    grid, _ = map_from(source, floor, timeout)
    _save(grid, out)


@map_group.command()
@click.argument("picture", metavar="PICTURE", type=click.Path(dir_okay=False, path_type=Path))
@click.argument("out", type=click.Path(dir_okay=False, path_type=Path))
@click.option(
    "--points",
    nargs=4,
    type=float,
    required=True,
    metavar="COLUMN ROW COLUMN ROW",
    help="Two points of the picture in pixels, from its upper left corner.",
)
@click.option("--distance", type=float, required=True, metavar="METRES", help="Between these points.")
@click.option("--at", nargs=2, type=float, metavar="X Y", help="Place of the first point in metres.")
@click.option(
    "--heading", type=float, metavar="DEGREES", help="Direction from the first point to the second."
)
@click.option("--yes", is_flag=True, help="Replace an existing map, which stays as .bak.")
@without_config
def place(
    picture: Path,
    out: Path,
    points: tuple[float, float, float, float],
    distance: float,
    at: tuple[float, float] | None,
    heading: float | None,
    yes: bool,
    config_file: str | None,
    debug: bool,
) -> None:
    """Make a map of a picture by two points of known distance.

    Without --at its lower left corner is at (0, 0), without --heading it is not turned.
    """
    from fleet_tui.cli.map.source import map_file
    from fleet_tui.maps.placing import placed
    from fleet_tui.model.grid import OccupancyGrid

    log_to_file(debug)
    if not yes:
        _ask_to_replace(out)
    grid = map_file(picture)
    column, row, to_column, to_row = points
    frame = placed(grid.frame, ((column, row), (to_column, to_row)), distance, at, heading)
    _save(OccupancyGrid(frame, grid.levels), out)


def _ask_to_replace(out: Path) -> None:
    from fleet_tui.maps.saving import map_files

    existing = [path for path in map_files(out) if path.exists()]
    if not existing:
        return
    if not sys.stdin.isatty():
        raise click.UsageError(sanitize(f"{existing[0]} exists: use --yes to replace it, it stays as .bak"))
    click.confirm(sanitize(f"{existing[0]} exists: replace it and keep it as .bak?"), abort=True, err=True)


def _save(grid: "OccupancyGrid", out: Path) -> None:
    from fleet_tui.maps.saving import save_map
    from fleet_tui.model.set_up.survey import survey

    saved = save_map(grid, out, lambda step: click.echo(sanitize(step), err=True))
    click.echo(sanitize(f"{saved}: {survey(grid).text}"))
