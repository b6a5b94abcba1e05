"""`fleet-tui history`, `report` and `metrics`. Exit codes 0: printed or ended by a signal, 1: no history, or
it can't be read or written, 2: a wrong argument."""

import sys
import time
from datetime import datetime
from pathlib import Path

import click

from fleet_tui.cli.offers import robots
from fleet_tui.cli.options import FileName, NearestGroup, fleet, merged
from fleet_tui.config.log_file import log_to_file
from fleet_tui.records.audit.search import TIME_FORMS, moment
from fleet_tui.text.errors import FleetError
from fleet_tui.text.sanitize import sanitize

SHIFT = "8h"


@click.group(cls=NearestGroup)
def shift() -> None:
    """Group of the commands, which the command line lists as its own."""


class Since(click.ParamType):  # type: ignore[type-arg,unused-ignore]  # generic in newer versions of click only
    """A moment in the past, as Unix seconds."""

    name = "time"

    def convert(self, value: object, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Parse the typed text."""
        now = datetime.now().astimezone()
        try:
            at = moment(str(value), now)
        except FleetError as problem:
            self.fail(str(problem), param, ctx)
        if at >= now:
            self.fail(f"{value} is not in the past: use {TIME_FORMS}", param, ctx)
        return at.timestamp()


@shift.command()
@click.argument("words", nargs=-1)
@click.option(
    "--since",
    type=Since(),
    default=SHIFT,
    metavar="TIME",
    show_default=True,
    help="Begin 30m, 8h, 7d ago, at 12:00 or at 2024-05-31T12:00.",
)
@click.option(
    "--robot", metavar="ROBOT", default="", shell_complete=robots, help="Print only events of this robot."
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON; schema in `fleet-tui docs history`.")
@click.option("--csv", "as_csv", is_flag=True, help="Print CSV for a spreadsheet.")
@click.option(
    "--collect",
    is_flag=True,
    help="Write the history until Ctrl-C or SIGTERM: a service for sites where no console stays open.",
)
@fleet
@merged
def history(
    words: tuple[str, ...],
    since: float,
    robot: str,
    as_json: bool,
    as_csv: bool,
    collect: bool,
    config_file: str | None,
    url: str | None,
    debug: bool,
) -> None:
    """Print past orders, alarms, commands, links and notes. Oldest first; WORDS filter the events,
    `!word` leaves out those with it. Connects to no robot, except with --collect."""
    if as_json and as_csv:
        raise click.UsageError("--json and --csv exclude each other")
    log_to_file(debug)
    if collect:
        from fleet_tui.cli.chosen import chosen
        from fleet_tui.features.history.cli.collecting import collect as run

        run(chosen(config_file, url), click.echo)
        return
    from fleet_tui.features.history.cli.printing import Form, print_events
    from fleet_tui.features.history.cli.reading import history_of_site, site_of

    form = Form.JSON if as_json else Form.CSV if as_csv else Form.TEXT
    with history_of_site(site_of(config_file, url)) as read:
        print_events(read, since, time.time(), words, robot, form, sys.stdout)


@shift.command()
@click.option(
    "--since", type=Since(), default=SHIFT, metavar="TIME", show_default=True, help="Begin as in `history`."
)
@click.option(
    "--output",
    type=FileName(path_type=Path, dir_okay=False),
    metavar="FILE",
    required=True,
    help="Write the page to this file; an older one is replaced.",
)
@fleet
@merged
def report(since: float, output: Path, config_file: str | None, url: str | None, debug: bool) -> None:
    """Write a shift on one page of HTML, to be handed over. Its pictures are in it; it prints well. Connects
    to no robot."""
    from fleet_tui.features.history.cli.reading import history_of_site, site_of
    from fleet_tui.features.history.cli.reporting import write_report

    log_to_file(debug)
    config = site_of(config_file, url)
    with history_of_site(config) as read:
        size = write_report(config, read, since, time.time(), output)
    click.echo(f"{sanitize(str(output))}: {size / 1000:.0f} kB; open it in a browser")


@shift.command()
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    metavar="PORT",
    default=9464,
    show_default=True,
    help="Listen on this port; 0 picks a free one.",
)
@click.option(
    "--host", metavar="ADDRESS", default="127.0.0.1", show_default=True, help="Listen on this address."
)
@fleet
@merged
def metrics(port: int, host: str, config_file: str | None, url: str | None, debug: bool) -> None:
    """Serve the fleet's figures to Prometheus. Until Ctrl-C or SIGTERM; sends no commands."""
    from fleet_tui.cli.chosen import chosen
    from fleet_tui.features.history.cli.metrics import metrics as run

    log_to_file(debug)
    run(chosen(config_file, url), host, port, click.echo)
