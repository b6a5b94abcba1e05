"""The `config init` and `config show` commands."""

import os

import click

from fleet_tui.cli.chosen import of_file
from fleet_tui.cli.offers import files
from fleet_tui.cli.options import NearestGroup, NumberRange, common, merged, screen, timeout
from fleet_tui.config.load import find, user_folder
from fleet_tui.config.log_file import log_to_file
from fleet_tui.config.schema import Config
from fleet_tui.text.sanitize import sanitize


@click.group(cls=NearestGroup)
def config() -> None:
    """Create a configuration or show the effective one."""


@config.command()
@click.option(
    "--from-live", "url", metavar="URL", default="", help="Discover robots and floors on this bridge."
)
@click.option(
    "--output",
    metavar="FILE",
    default="",
    shell_complete=files,
    help="Write to this file instead of standard output.",
)
@click.option("--force", is_flag=True, help="Overwrite an existing file.")
@click.option(
    "--wait",
    type=NumberRange(0, 3600),
    metavar="SECONDS",
    default=0.0,
    help="Listen at least so long for vehicles on a broker: each sends a state within 30 s.",
)
@timeout(20.0)
@common
@merged
def init(
    config_file: str | None, debug: bool, url: str, output: str, force: bool, wait: float, timeout: float
) -> None:
    """Write a configuration to edit, with comments. An example, or one discovered on a bridge. --config FILE
    supplies the certificates and authorization for the connection, from its [rosbridge]."""
    from fleet_tui.cli.config.init import example, from_live, next_steps, write

    log_to_file(debug)
    known = of_file(config_file) if config_file else Config()
    site = from_live(known, url, timeout, wait) if url else None
    write(site.text if site else example(), output, force, click.echo)
    for line in next_steps(site, output):
        click.echo(sanitize(line), err=True)


@config.command()
@click.option("--origin", "with_origin", is_flag=True, help="Also show the origin of each value.")
@screen
@common
@merged
def show(
    config_file: str | None, debug: bool, with_origin: bool, read_only: bool, drawing: str | None
) -> None:
    """Show all effective values except secrets."""
    from fleet_tui.cli.config.origins import show as lines

    found = of_file(config_file)
    options = {"operator.read_only": read_only, "ui.drawing": drawing}
    for line in lines(found, _why(config_file), with_origin, options):
        click.echo(sanitize(line))


def _why(given: str | None) -> str:
    """Return the reason that this file is in effect."""
    if given:
        return "option --config"
    if os.environ.get("FLEET_TUI_CONFIG"):
        return "environment: FLEET_TUI_CONFIG"
    return "the user's" if find(None) == user_folder() / "config.toml" else "in this folder"
