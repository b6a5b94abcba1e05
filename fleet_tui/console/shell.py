"""Commands without a screen. The command line imports this module when one of them is used."""

import math
import sys
import time
from pathlib import Path

import click

from fleet_tui.cli.config.commands import config
from fleet_tui.cli.docs import docs
from fleet_tui.cli.duration import DurationParam
from fleet_tui.cli.kinds import kinds as list_kinds
from fleet_tui.cli.manual import man
from fleet_tui.cli.map.commands import map_group
from fleet_tui.cli.offers import robots
from fleet_tui.cli.options import FileName, NearestGroup, NumberRange, fleet, merged, timeout, without_config
from fleet_tui.cli.orders.commands import orders
from fleet_tui.config.log_file import log_to_file
from fleet_tui.config.schema import Config
from fleet_tui.features.graphs.cli.commands import graph
from fleet_tui.features.history.cli.commands import shift
from fleet_tui.features.programs.cli.commands import programs
from fleet_tui.features.routines.cli.commands import routine
from fleet_tui.text.sanitize import sanitize


@click.group(cls=NearestGroup)
def headless() -> None:
    """Group of the commands, which the command line lists as its own."""


groups = (*orders.commands.values(), *shift.commands.values())
for command in (config, graph, map_group, programs, routine, docs, man, *groups):
    headless.add_command(command)


@headless.command()
@click.option("--json", "as_json", is_flag=True, help="Print JSON; schema in `fleet-tui docs status-json`.")
@click.option("--watch", is_flag=True, help="Keep running and print changes (with --json as JSON Lines).")
@click.option("--oneline", is_flag=True, help="Print one line, for a status bar.")
@timeout(5.0)
@fleet
@merged
def status(
    config_file: str | None,
    url: str | None,
    debug: bool,
    as_json: bool,
    watch: bool,
    oneline: bool,
    timeout: float,
) -> None:
    """Print the fleet as a table or JSON. Exit code 0: all well, 1: something needs attention, 3: no
    link."""
    if as_json and oneline:
        raise click.UsageError("--json and --oneline exclude each other")
    from fleet_tui.cli.chosen import chosen
    from fleet_tui.cli.status.status import status as run

    log_to_file(debug)
    config = chosen(config_file, url)
    sys.exit(run(config, timeout, as_json, oneline, watch, click.echo))


@headless.command()
@click.option("--json", "as_json", is_flag=True, help="Print JSON; schema in `fleet-tui docs kinds`.")
@without_config
@merged
def kinds(config_file: str | None, debug: bool, as_json: bool) -> None:
    """List the kinds of robots, their reports and commands."""
    list_kinds(as_json, click.echo)


@headless.command()
@without_config
@merged
def rights(config_file: str | None, debug: bool) -> None:
    """Print your rights on this machine: view, dispatch or setup. Its administrator grants them in
    /etc/fleet-tui/rights.toml."""
    from fleet_tui.cli.rights import rights_lines

    for line in rights_lines():
        click.echo(line)


@headless.command()
@click.option("--json", "as_json", is_flag=True, help="Print JSON; schema in `fleet-tui docs doctor`.")
@click.option(
    "--robot",
    metavar="ROBOT",
    default="",
    shell_complete=robots,
    help="Check only this robot, its bridge and its floors.",
)
@click.option(
    "--bundle", is_flag=True, help="Also pack the report, recordings, log and audit log for a ticket."
)
@timeout(20.0)
@fleet
@merged
def doctor(
    config_file: str | None,
    url: str | None,
    debug: bool,
    as_json: bool,
    robot: str,
    bundle: bool,
    timeout: float,
) -> None:
    """Find what is wrong between you and the robots. Each fault comes with its remedy. Sends no
    commands. Exit code 0: all well, 1: faults or checks not run, 3: no link."""
    from fleet_tui.cli.chosen import chosen_to_examine
    from fleet_tui.features.doctor.run import doctor as run

    log_to_file(debug)
    began = time.monotonic()
    config, unnamed = chosen_to_examine(config_file, url, timeout / 2)
    timeout -= time.monotonic() - began
    said: list[str] = []

    def say(line: str) -> None:
        click.echo(line)
        said.append(click.unstyle(line))

    code = run(config, timeout, as_json, say, robot, unnamed)
    if bundle:
        _pack(config, said, as_json)
    sys.exit(code)


def _pack(config: Config, said: list[str], as_json: bool) -> None:
    """Pack the doctor's output, and print the path: not into the JSON."""
    from fleet_tui.features.recording.bundle import pack

    click.echo(sanitize(pack(config, "\n".join([*said, ""]), "json" if as_json else "txt")), err=as_json)


@headless.command()
@click.argument("file", type=FileName(path_type=Path))
@click.option("--for", "seconds", type=DurationParam(), default="366d", help="Stop after 45s, 30m, 8h, ...")
@click.option("--rotate-mb", type=NumberRange(1), help="Start a new file every N megabytes.", metavar="N")
@click.option("--rotate-every", type=DurationParam(), help="Start a new file every 30m, 1h, ...")
@click.option(
    "--keep", type=click.IntRange(0), help="Keep only the newest N files; 0 keeps all.", metavar="N"
)
@click.option(
    "--timeout",
    type=NumberRange(0.1),
    metavar="SECONDS",
    help="Stop if there is no link after this many seconds.",
)
@fleet
@merged
def record(
    config_file: str | None,
    url: str | None,
    debug: bool,
    file: Path,
    seconds: float,
    rotate_mb: float | None,
    rotate_every: float | None,
    keep: int | None,
    timeout: float | None,
) -> None:
    """Record all wire traffic to FILE until Ctrl-C or SIGTERM. Sends no commands. Exit code 0: recorded, 1:
    FILE cannot be created, 3: no link."""
    from fleet_tui.cli.chosen import chosen
    from fleet_tui.features.recording.cli import record as run
    from fleet_tui.records.recording.part_files import PartLimits

    log_to_file(debug)
    config = chosen(config_file, url)
    usual = config.recording
    limits = PartLimits(
        part_bytes=(usual.rotate_mb if rotate_mb is None else rotate_mb) * 1e6,
        part_seconds=usual.rotate_minutes * 60 if rotate_every is None else rotate_every,
        kept=usual.keep if keep is None else keep,
    )
    is_live = sys.stderr.isatty()
    sys.exit(run(config, file, limits, seconds, timeout or math.inf, click.echo, is_live))


@headless.command()
@click.argument("words", nargs=-1)
@click.option(
    "--robot", metavar="ROBOT", default="", shell_complete=robots, help="Show only records of this robot."
)
@click.option(
    "--since",
    default="",
    metavar="TIME",
    help="Show only records since 30m, 2h, 7d (ago), 12:00 or 2024-05-31T12:00.",
)
@click.option("--csv", "as_csv", is_flag=True, help="Print CSV for a spreadsheet.")
@click.option("--demo", is_flag=True, help="Show records of demos instead of those of real fleets.")
@without_config
@merged
def audit(
    config_file: str | None,
    debug: bool,
    words: tuple[str, ...],
    robot: str,
    since: str,
    as_csv: bool,
    demo: bool,
) -> None:
    """Print commands and their outcomes, newest first. WORDS filter records as in the console's audit log."""
    from fleet_tui.features.audit.cli import write_records

    named = {"robot": robot, "since": since}
    typed = [*words, *(f"{name}:{value}" for name, value in named.items() if value)]
    said = write_records(" ".join(typed), as_csv, demo, sys.stdout)
    if said:
        click.echo(sanitize(said), err=True)
