"""The replay command; imported when the command line uses it."""

import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

import click

from fleet_tui.cli.options import FileName, NearestGroup, NumberRange, common, merged, screen
from fleet_tui.config.load import load_if_any
from fleet_tui.config.schema import Config
from fleet_tui.features.recording.bags.opening import BagError, is_bag
from fleet_tui.text.errors import ConfigError
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import percent

PATIENCE = 0.5
"""Seconds between two progress messages."""


@click.group(cls=NearestGroup)
def replayed() -> None:
    """Group of the command, which the command line lists as its own."""


@replayed.command()
@click.argument("file", type=FileName())
@click.option(
    "--speed",
    type=NumberRange(0.25, 64),
    metavar="X",
    default=1.0,
    show_default=True,
    help="Play at this multiple of the recorded speed.",
)
@click.option(
    "--at",
    "start",
    default="",
    metavar="TIME",
    help="Start at 12:04:31, 2024-05-31T12:04:31, +90s or +1m30s.",
)
@screen
@common
@merged
def replay(
    config_file: str | None,
    debug: bool,
    file: str,
    speed: float,
    start: str,
    read_only: bool,
    drawing: str | None,
) -> None:
    """Replay a recording or a ROS bag in the console. Nothing is sent."""
    from fleet_tui.console.open import open_replay
    from fleet_tui.records.recording.play.start import playing

    found, path, notes = load_if_any(config_file), Path(file), list[str]()
    with TemporaryDirectory(prefix="fleet-tui-") as folder:
        if is_bag(path):
            path, notes = _recording_of(path, found, Path(folder))
        player, config = playing(path, found, speed, start, _Progress(), notes)
        open_replay(config, player, drawing, debug)


def _recording_of(bag: Path, config: Config, folder: Path) -> tuple[Path, list[str]]:
    """Return the configured topics of a bag as a recording, and notes on it."""
    from fleet_tui.features.recording.bags.convert import convert

    made = folder / "bag.jsonl.gz"
    try:
        notes = convert(bag, config, made, _Progress()).notes
    except BagError as problem:
        raise ConfigError([str(problem)]) from None
    over_progress = "\r" if sys.stderr.isatty() else ""
    for note in notes:
        click.echo(over_progress + sanitize(note), err=True)
    return made, notes


class _Progress:
    """Prints the progress of reading, if that takes a while."""

    def __init__(self) -> None:
        self._next = time.monotonic() + PATIENCE

    def __call__(self, share: float) -> None:
        now = time.monotonic()
        if now >= self._next and sys.stderr.isatty():
            self._next = now + PATIENCE
            click.echo(f"\rreading: {percent(share):>5} ", nl=False, err=True)
