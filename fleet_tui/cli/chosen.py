"""The configuration that a command line names: a file, or the address of a bridge."""

import click

from fleet_tui.config.load import find, load
from fleet_tui.config.log_file import state_problem
from fleet_tui.config.schema import Config
from fleet_tui.links.discovery.address import bridge_at
from fleet_tui.links.discovery.awaiting import Discovering
from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.text.errors import ConfigError, FleetError, LinkError
from fleet_tui.text.sanitize import sanitize


def of_file(config_file: str | None) -> Config:
    """Return the configuration of a file; tells what of it does not count. Raises ConfigError."""
    config = load(find(config_file))
    for line in filter(None, (*config.withheld, state_problem())):
        click.echo(sanitize(f"warning: {line}"), err=True)
    return config


def chosen(config_file: str | None, url: str | None) -> Config:
    """Return the configuration of a file, or of an address with warnings on uncertain settings. Raises
    ConfigError, LinkError if the bridge can't be reached, FleetError if no robot is found."""
    return of_file(config_file) if not _is_address(config_file, url) else _warned(_discovered(url))


def chosen_to_command(config_file: str | None, url: str | None) -> Config:
    """Return the same, without robots of uncertain kind: commands to them would be in another kind's
    format."""
    if not _is_address(config_file, url):
        return of_file(config_file)
    site = _discovered(url)
    if site.unclear:
        raise ConfigError(site.unclear)
    return _warned(site)


def chosen_to_examine(config_file: str | None, url: str | None, within: float) -> tuple[Config, str]:
    """Return the same; for an address without robots a configuration without any, and the reason, empty if
    the bridge itself can't be reached."""
    if not _is_address(config_file, url):
        return of_file(config_file), ""
    bridge = bridge_at(url or "")
    try:
        return _warned(Discovering(bridge, within).result()), ""
    except LinkError:
        return Config(rosbridge=bridge), ""
    except FleetError as problem:
        return Config(rosbridge=bridge), str(problem)


def _is_address(config_file: str | None, url: str | None) -> bool:
    if config_file and url:
        raise click.UsageError("--config and --url exclude each other")
    return bool(url)


def _discovered(url: str | None) -> DiscoveredSite:
    return Discovering(bridge_at(url or "")).result()


def _warned(site: DiscoveredSite) -> Config:
    config = site.config
    for line in site.warnings:
        click.echo(sanitize(f"warning: {line}"), err=True)
    return config
