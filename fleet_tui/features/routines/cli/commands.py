"""`fleet-tui routine`. Exit codes 0: done or no problem, 1: problems, a robot failed, or a person is needed,
2: unreadable, 3: no link, 130: Ctrl-C."""

import sys

import click
from click.shell_completion import CompletionItem

from fleet_tui.cli.offers import config_of, starting
from fleet_tui.cli.options import NearestGroup, NumberRange, common, fleet, merged, timeout
from fleet_tui.config.log_file import log_to_file

HELD_FOR = 300.0
"""Seconds for which a routine that nobody can resume waits for its link."""


def offered(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the files in the configuration's folder of routines."""
    from fleet_tui.features.routines.files import routine_names

    return starting(routine_names(config_of(context).routine_folder), typed)


@click.group(cls=NearestGroup)
def routine() -> None:
    """Check, run, list and install routines. A routine is a file of instructions for robots."""


@routine.command("check")
@click.argument("name", shell_complete=offered)
@click.option("--json", "as_json", is_flag=True, help="Print JSON; schema in `fleet-tui docs routines`.")
@timeout(5.0)
@fleet
@merged
def check_command(
    name: str, as_json: bool, timeout: float, config_file: str | None, url: str | None, debug: bool
) -> None:
    """Check a routine against the robots and graphs. Prints its timeline, sends nothing."""
    from fleet_tui.cli.chosen import chosen
    from fleet_tui.features.routines.cli.checking import check

    log_to_file(debug)
    sys.exit(check(chosen(config_file, url), name, timeout, as_json, click.echo))


@routine.command("run")
@click.argument("name", shell_complete=offered)
@click.option("--resume", is_flag=True, help="Go on from where it was held or ended.")
@click.option("--skip", is_flag=True, help="With --resume: go on after an instruction of unknown outcome.")
@click.option("--yes", is_flag=True, help="Send orders in spite of warnings.")
@click.option(
    "--json", "as_json", is_flag=True, help="Print JSON Lines; schema in `fleet-tui docs routines`."
)
@click.option(
    "--timeout",
    type=NumberRange(0.1, 86400),
    metavar="SECONDS",
    default=HELD_FOR,
    show_default=True,
    help="Without a terminal: maximum seconds to wait while it is held.",
)
@fleet
@merged
def run_command(
    name: str,
    resume: bool,
    skip: bool,
    yes: bool,
    as_json: bool,
    timeout: float,
    config_file: str | None,
    url: str | None,
    debug: bool,
) -> None:
    """Run a routine, and print each event. Without a link it is held until a person resumes it. Ctrl-C ends
    it; running orders go on."""
    from fleet_tui.cli.chosen import chosen_to_command
    from fleet_tui.features.routines.cli.running import RunOptions, run_routine

    if skip and not resume:
        raise click.UsageError("--skip needs --resume")
    log_to_file(debug)
    options = RunOptions(resume, skip, yes, as_json, timeout)
    sys.exit(run_routine(chosen_to_command(config_file, url), name, options, click.echo))


@routine.command("list")
@click.option("--json", "as_json", is_flag=True, help="Print JSON; schema in `fleet-tui docs routines`.")
@common
@merged
def list_command(as_json: bool, config_file: str | None, debug: bool) -> None:
    """List the routines with their times, states and last runs."""
    from fleet_tui.cli.chosen import of_file
    from fleet_tui.features.routines.cli.listing import list_routines

    log_to_file(debug)
    sys.exit(list_routines(of_file(config_file), as_json, click.echo))


@routine.command("install")
@click.argument("name", shell_complete=offered)
@click.option("--print", "only_print", is_flag=True, help="Print the units without writing them.")
@common
@merged
def install_command(name: str, only_print: bool, config_file: str | None, debug: bool) -> None:
    """Write a timer of the user's systemd for the times of a routine. Enables nothing."""
    from fleet_tui.cli.chosen import of_file
    from fleet_tui.features.routines.cli.installing import install_routine

    log_to_file(debug)
    sys.exit(install_routine(of_file(config_file), name, only_print, click.echo))
