"""Opens the console: on a configuration, the robots behind an address or simulated ones, or after asking."""

import os
import sys
from pathlib import Path
from shutil import get_terminal_size
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, NamedTuple

from fleet_tui.config.load import find, load, load_if_any
from fleet_tui.config.log_file import log_to_file
from fleet_tui.config.schema import Config
from fleet_tui.config.trust import saying_yes
from fleet_tui.config.withholding import TRUST
from fleet_tui.robots.registry import DEFAULT_KIND
from fleet_tui.text.errors import ConfigError, LinkError, NoConfigError
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.terminal.detect import IN_BROWSER, need_terminal

if TYPE_CHECKING:
    from fleet_tui.console.entry import Chosen


class SimulatedFleet(NamedTuple):
    """The robots of a demo; `ros` empty: the usual version of their kind."""

    robots: int = 3
    floors: int = 2
    faults: str = ""
    speed: float = 1.0
    ros: str = ""
    kind: str = DEFAULT_KIND


def open_with(
    config_file: str | None, url: str | None, read_only: bool, drawing: str | None, debug: bool
) -> None:
    """Run the console until the operator leaves. Raises FleetError if it can't start."""
    if url and config_file:
        raise ConfigError(["--config and --url exclude each other"])
    site = None
    try:
        config = None if url else _trusted(load(find(config_file)))
    except NoConfigError:
        config = None
    if config is None:
        chosen = _arrive(url, read_only, drawing, debug)
        if isinstance(chosen, str):
            open_demo(SimulatedFleet(), None, read_only, drawing, debug)
            return
        if chosen is None:
            return
        site, config = chosen, chosen.config
    from fleet_tui.console.open import open_console

    open_console(config, read_only, drawing, debug, site=site)


def _trusted(config: Config) -> Config:
    """Return the configuration, and all of it if a person trusts what somebody else could have written."""
    if TRUST not in "".join(config.withheld) or not sys.stdin.isatty() or IN_BROWSER in os.environ:
        return config
    import click

    for line in config.withheld:
        click.echo(click.wrap_text(sanitize(line), get_terminal_size().columns), err=True)
    if not click.confirm("Trust what is in it now?", err=True):
        return config
    with saying_yes():
        return load(config.path)


def open_demo(
    fleet: SimulatedFleet, config_file: str | None, read_only: bool, drawing: str | None, debug: bool
) -> None:
    """Run the console on a simulated fleet, with theme and keys of the user's configuration, if there is one.
    Raises FleetError if it can't start."""
    from fleet_tui.console.demo import ON_BROKER, demo_config, simulated, vehicles_config, with_vehicles

    with TemporaryDirectory(prefix="fleet-tui-") as folder, simulated(*fleet) as (first, *further):
        from fleet_tui.console.open import open_console

        found = load_if_any(config_file)
        robots, floors, _, _, ros, kind = fleet
        if kind == ON_BROKER:
            config = vehicles_config(found, first, robots, floors, Path(folder))
        else:
            brokers = [url for url in further if url.startswith("mqtt:")]
            bridges = [url for url in further if url not in brokers]
            config = demo_config(found, first, robots, floors, ros, kind, Path(folder), bridges)
            for broker in brokers:
                config = with_vehicles(config, broker)
        open_console(config, read_only, drawing, debug, demo=True)


def _arrive(url: str | None, read_only: bool, drawing: str | None, debug: bool) -> "Chosen":
    """Discover the site, and ask a person about uncertain settings, or without an address for a fleet."""
    from fleet_tui.links.discovery.address import bridge_at
    from fleet_tui.links.discovery.awaiting import Discovering

    log_to_file(debug)  # messages of the network libraries must not reach the terminal
    bridge = bridge_at(url) if url else None
    discovering = Discovering(bridge) if bridge else None
    from fleet_tui.console.open import ask_first  # takes long: discovery continues

    need_terminal()
    try:
        site = discovering.result() if discovering else None
    except LinkError as problem:
        assert bridge is not None
        raise LinkError(
            Message(
                "{problem}. Each step of the way: fleet-tui doctor --url {shown}",
                problem=problem,
                shown=bridge.shown,
            )
        ) from problem
    if site is not None:
        certain = bool(site.config.robots) and not (site.choices or site.lacks)
        # A browser's tab shows a single app: no question can be asked there.
        if IN_BROWSER in os.environ and site.unclear and not read_only:
            raise ConfigError(site.unclear)
        if certain or IN_BROWSER in os.environ:
            return site
    chosen = ask_first(site, drawing)
    if chosen is None and site is None:
        _repeat_commands()
    return chosen


def _repeat_commands() -> None:
    """Print the commands that the first-run screen has shown: it is gone with the terminal's other screen."""
    from fleet_tui.console.first_run import LOCAL
    from fleet_tui.ui.view.tables.opening import commands

    for line, effect in commands(LOCAL):
        sys.stdout.write(f"{line:<47} {effect}\n")
