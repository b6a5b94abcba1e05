"""The `serve` command. The web server, an extra, is imported on use."""

import sys

import click

from fleet_tui.cli.chosen import of_file
from fleet_tui.cli.options import NearestGroup, drawing_mode, fleet, merged
from fleet_tui.config.log_file import log_to_file
from fleet_tui.config.rights import own_rights
from fleet_tui.model.problem import Right
from fleet_tui.text.errors import ConfigError, FleetError, NoConfigError
from fleet_tui.text.language import Message


@click.group(cls=NearestGroup)
def served() -> None:
    """Group of the command, which the command line lists as its own."""


@served.command()
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    metavar="PORT",
    default=8000,
    show_default=True,
    help="Listen on this port; 0 picks a free one.",
)
@click.option(
    "--host", metavar="ADDRESS", default="127.0.0.1", show_default=True, help="Listen on this address."
)
@click.option("--allow-commands", is_flag=True, help="Allow commands; by default the console is read-only.")
@click.option("--demo", is_flag=True, help="Serve a separate simulated fleet in each tab.")
@drawing_mode
@fleet
@merged
def serve(
    config_file: str | None,
    url: str | None,
    debug: bool,
    port: int,
    host: str,
    allow_commands: bool,
    demo: bool,
    drawing: str | None,
) -> None:
    """Serve the console to web browsers. By default read-only, and only on this machine."""
    command = [sys.executable, "-P", "-m", "fleet_tui", *(["demo"] if demo else [])]
    command += _address(url, config_file, demo, allow_commands, debug) if url else _file(config_file, demo)
    command += [] if allow_commands else ["--read-only"]
    command += ["--debug"] if debug else []
    command += ["--drawing", drawing] if drawing else []
    try:
        from fleet_tui.features.serve.run import run
    except ModuleNotFoundError as missing:
        needed = "pip install 'textual-serve==1.1.3', or fleet-tui with its extra: 'fleet-tui[serve]'"
        raise FleetError(
            Message("serve needs {name}, which is not installed: {needed}", name=missing.name, needed=needed)
        ) from missing
    click.echo(_said(allow_commands), err=True)
    run(command, host, port, debug, click.echo, lambda line: click.echo(line, err=True))


def _address(url: str, config_file: str | None, demo: bool, allow_commands: bool, debug: bool) -> list[str]:
    """Return the option for the fleet at an address. Its errors are reported here, not in each tab."""
    if config_file or demo:
        raise click.UsageError(f"{'--config' if config_file else '--demo'} and --url exclude each other")
    from fleet_tui.links.discovery.address import bridge_at
    from fleet_tui.links.discovery.awaiting import Discovering

    log_to_file(debug)
    site = Discovering(bridge_at(url)).result()
    if site.config.robots and site.unclear and allow_commands:
        raise ConfigError(site.unclear)
    return ["--url", url]


def _file(config_file: str | None, demo: bool) -> list[str]:
    """Return the option for a configuration; a demo needs none."""
    try:
        path = of_file(config_file).path
    except NoConfigError:
        if demo:
            return []
        raise
    return ["--config", str(path)]


def _said(allow_commands: bool) -> str:
    if allow_commands:
        if refusal := own_rights().refusal(Right.DISPATCH):
            return f"{refusal}: no tab can command the robots."
        return "Commands allowed: every tab can command the robots."
    return "read-only: no commands; allow them with --allow-commands."
