"""The history of the configured site, for commands that read it."""

import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from fleet_tui.cli.chosen import of_file
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.schema import Config
from fleet_tui.links.discovery.address import bridge_at
from fleet_tui.records.history.database import history_path, is_empty, opened_to_read
from fleet_tui.records.history.reading import History
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message


def site_of(config_file: str | None, url: str | None) -> Config:
    """Return the configuration of a file, or one of an address alone: nothing is asked of its robots."""
    if config_file and url:
        raise click.UsageError("--config and --url exclude each other")
    return Config(rosbridge=bridge_at(url)) if url else of_file(config_file)


@contextmanager
def history_of_site(config: Config) -> Iterator[History]:
    """Open its history. Raises FleetError without one, or if it can't be read."""
    path = history_path(state_folder(), config)
    if not path.exists():
        raise FleetError(_missing(config, path))
    try:
        with opened_to_read(path) as database:
            if is_empty(database):
                raise FleetError(_missing(config, path))
            yield History(database)
    except sqlite3.Error as problem:
        raise FleetError(Message("{path}: {problem}", path=path, problem=problem)) from None


def _missing(config: Config, path: Path) -> Message:
    site = str(config.path) if config.path.suffix else config.rosbridge.shown
    if not config.history.days:
        return Message("{site}: the history is switched off: set days in [history]", site=site)
    return Message(
        "no history of {site} yet ({path}): an open console writes it, as do `fleet-tui record`"
        " and `fleet-tui history --collect`",
        site=site,
        path=path,
    )
