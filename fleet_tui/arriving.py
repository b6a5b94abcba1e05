"""Opens the console: on a configuration, on the robots behind an address, or after asking for one."""

import os
from typing import TYPE_CHECKING

from fleet_tui.config.load import find, load
from fleet_tui.errors import ConfigError, NoConfigError
from fleet_tui.log_file import log_to_file
from fleet_tui.terminal.detect import IN_BROWSER, need_terminal

if TYPE_CHECKING:
    from fleet_tui.discovery.site import DiscoveredSite


def open_with(
    config_file: str | None, url: str | None, read_only: bool, drawing: str | None, debug: bool
) -> None:
    """Run the console until the operator leaves. Raises FleetError if it can't start."""
    if url and config_file:
        raise ConfigError(["--config and --url exclude each other"])
    site = None
    try:
        config = None if url else load(find(config_file))
    except NoConfigError:
        config = None
    if config is None:
        site = _arrive(url, read_only, drawing, debug)
        if site is None:
            return
        config = site.config
    from fleet_tui.console import open_console

    open_console(config, read_only, drawing, debug, site=site)


def _arrive(url: str | None, read_only: bool, drawing: str | None, debug: bool) -> "DiscoveredSite | None":
    """Discover the site, and ask a person about uncertain settings; None if they leave."""
    from fleet_tui.discovery.address import bridge_at
    from fleet_tui.discovery.awaiting import Discovering

    log_to_file(debug)  # messages of the network libraries must not reach the terminal
    discovering = Discovering(bridge_at(url)) if url else None
    from fleet_tui.console import ask_first  # takes long: discovery continues

    need_terminal()
    site = discovering.result() if discovering else None
    if site is not None:
        certain = bool(site.config.robots) and not (site.choices or site.lacks)
        # A browser's tab shows a single app: no question can be asked there.
        if IN_BROWSER in os.environ and site.unclear and not read_only:
            raise ConfigError(site.unclear)
        if certain or IN_BROWSER in os.environ:
            return site
    return ask_first(site, drawing)
