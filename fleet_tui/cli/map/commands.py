"""`fleet-tui map info|show|save`. The command line imports this module when one of them is used."""

import json
import sys
from collections.abc import Callable
from pathlib import Path

import click

from fleet_tui.cli.options import common, merged, timeout
from fleet_tui.log_file import log_to_file
from fleet_tui.text.sanitize import sanitize

VERSION = 1
WITHIN = 10.0


@click.group("map")
def map_group() -> None:
    """Show or save maps: of a file (map_server YAML, PGM, PNG), or live behind a bridge."""


def _source(command: Callable[..., None]) -> Callable[..., None]:
    """Add `FILE|URL` and its options."""
    text = "Floor of the live map, if the bridge has several."
    command = click.option("--floor", default="", metavar="NAME", help=text)(command)
    return click.argument("source", metavar="FILE|URL")(timeout(WITHIN)(common(merged(command))))


@map_group.command()
@click.option("--json", "as_json", is_flag=True, help="Print JSON; schema in docs/commands.md.")
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
def show(source: str, floor: str, timeout: float, config_file: str | None, debug: bool) -> None:
    """Print a map in braille, in ASCII where the output has no UTF-8; 80x24 without a terminal."""
    from fleet_tui.cli.map.picture import map_text, output_drawing, output_size
    from fleet_tui.cli.map.source import map_from
    from fleet_tui.model.set_up.survey import survey

    log_to_file(debug)
    grid, name = map_from(source, floor, timeout)
    width, height = output_size()
    click.echo(sanitize(f"{name}: {survey(grid).text}")[:width])
    click.echo(map_text(grid, width, height - 1, output_drawing()))


@map_group.command()
@_source
@click.argument("out", type=click.Path(dir_okay=False, path_type=Path))
@click.option("--yes", is_flag=True, help="Replace an existing map, which stays as .bak.")
def save(
    source: str, out: Path, floor: str, yes: bool, timeout: float, config_file: str | None, debug: bool
) -> None:
    """Save a map as OUT.yaml and OUT.pgm, at full precision, and compare the files with it."""
    from fleet_tui.cli.map.source import map_from
    from fleet_tui.maps.saving import map_files, save_map
    from fleet_tui.model.set_up.survey import survey

    log_to_file(debug)
    existing = [path for path in map_files(out) if path.exists()]
    if existing and not yes:
        question = f"{existing[0]} exists: replace it and keep it as .bak?"
        if not sys.stdin.isatty():
            raise click.UsageError(
                sanitize(f"{existing[0]} exists: use --yes to replace it, it stays as .bak")
            )
        click.confirm(sanitize(question), abort=True, err=True)
    grid, _ = map_from(source, floor, timeout)
    saved = save_map(grid, out, lambda step: click.echo(sanitize(step), err=True))
    click.echo(sanitize(f"{saved}: {survey(grid).text}"))
