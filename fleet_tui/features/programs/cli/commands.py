"""`fleet-tui programs`. Exit codes 0: all well or confirmed, 1: a program needs attention, or the answer is
no, 2: usage."""

import asyncio
import sys

import click

from fleet_tui.cli import offers
from fleet_tui.cli.chosen import of_file
from fleet_tui.cli.options import NearestGroup, common, merged, timeout
from fleet_tui.config.log_file import log_to_file
from fleet_tui.config.programs import ProgramEntry
from fleet_tui.config.schema import Config
from fleet_tui.text.errors import ConfigError, did_you_mean
from fleet_tui.text.sanitize import sanitize

WITHIN = 30.0
"""Seconds; that of programs.change, which is imported on use."""


@click.group(cls=NearestGroup, invoke_without_command=True)
@click.option("--json", "as_json", is_flag=True, help="Print JSON; schema in `fleet-tui docs programs`.")
@common
@click.pass_context
def programs(ctx: click.Context, as_json: bool, config_file: str | None, debug: bool) -> None:
    """Show and control the programs of the robot servers. Without a command it lists them. Exit code
    1: one has failed or is unknown."""
    if ctx.invoked_subcommand is None:
        _list(as_json=as_json, config_file=config_file, debug=debug)
    elif as_json or config_file or debug:
        raise click.UsageError(f"put options after programs {ctx.invoked_subcommand}")


@merged
def _list(as_json: bool, config_file: str | None, debug: bool) -> None:
    from fleet_tui.features.programs.cli.listing import list_programs

    config = _configured(config_file, debug)
    sys.exit(asyncio.run(list_programs(config.programs, as_json, click.echo)))


def _changing(verb: str) -> None:
    """Add the command of a verb."""

    @programs.command(verb, help=f"{verb.capitalize()} a program, and wait until its state shows it.")
    @click.argument("name", metavar="NAME", shell_complete=offers.programs)
    @click.option("--yes", is_flag=True, help="Don't ask.")
    @timeout(WITHIN)
    @common
    @merged
    def run(name: str, yes: bool, timeout: float, config_file: str | None, debug: bool) -> None:
        from fleet_tui.features.programs.cli.changing import change_program

        config = _configured(config_file, debug)
        sys.exit(change_program(config, _named(config, name), verb, timeout, yes, click.echo))


for _verb in ("start", "stop", "restart"):
    _changing(_verb)


@programs.command()
@click.argument("name", metavar="NAME", shell_complete=offers.programs)
@click.option("--follow", is_flag=True, help="Keep running and print new lines, until Ctrl-C.")
@common
@merged
def log(name: str, follow: bool, config_file: str | None, debug: bool) -> None:
    """Print the end of a program's log."""
    from fleet_tui.features.programs.cli.printing import print_log

    program = _named(_configured(config_file, debug), name)

    def say(line: str) -> None:
        click.echo(sanitize(line))

    def say_error(line: str) -> None:
        click.echo(sanitize(line), err=True)

    sys.exit(asyncio.run(print_log(program, follow, say, say_error)))


def _configured(config_file: str | None, debug: bool) -> Config:
    log_to_file(debug)
    config = of_file(config_file)
    if not config.programs:
        raise ConfigError([f"{config.path}: no [[programs]], see: fleet-tui docs programs"])
    return config


def _named(config: Config, name: str) -> ProgramEntry:
    known = {program.name: program for program in config.programs}
    if name not in known:
        raise click.UsageError(sanitize(f"unknown program {name!r}{did_you_mean(name, known)}"))
    return known[name]
