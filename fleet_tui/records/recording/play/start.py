"""From a file to a player, and to the configuration of a console on it."""

from collections.abc import Callable, Iterable
from pathlib import Path

from msgspec.structs import replace

from fleet_tui.config.schema import Config, Operator
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.play.player import Player
from fleet_tui.text.errors import ConfigError, FleetError


def playing(
    path: Path,
    found: Config,
    speed: float,
    start: str,
    progress: Callable[[float], None],
    notes: Iterable[str] = (),
) -> tuple[Player, Config]:
    """Return a player at its start, and the configuration: robots, floors, links and limits of the recording,
    keys and appearance of the one `found`. `notes` are further remarks. Raises ConfigError."""
    try:
        recording = open_recording(path, progress)
        recording.notes = [*notes, *recording.notes]
        player = Player(recording, speed)
        if start:
            player.enter(player.time_of(start))
    except FleetError as problem:
        raise ConfigError([str(problem)]) from None
    operator = Operator(read_only=True)
    return player, replace(recording.config, keys=found.keys, ui=found.ui, path=found.path, operator=operator)
