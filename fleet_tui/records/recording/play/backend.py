"""The backend of a console on a recording: sends nothing."""

from collections.abc import Mapping

from fleet_tui.model.commands import Command
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.events import Event
from fleet_tui.model.set_up.driving import HandDrive
from fleet_tui.records.recording.play.player import Player
from fleet_tui.state.store import Store
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message


class ReplayBackend:
    """Accepts no commands and has no connection; a player changes the state."""

    refusal = Message("not sent: this is a recording")

    def __init__(self, player: Player, store: Store) -> None:
        self._player = player
        self._store = store
        self.streams = store.streams

    def watch(self, _robot: str, _key: str) -> None:
        """Do nothing: streams are not recorded."""

    def unwatch(self, _robot: str, _key: str) -> None:
        """Do nothing."""

    def open(self) -> None:
        self._player.start(self._store)

    def submit(self, *_commands: Command) -> Message:
        """Send nothing."""
        return self.refusal

    def drive(self, _robot: str) -> HandDrive:
        """Raise CommandError: a recording drives no robot."""
        raise CommandError(self.refusal)

    def post(self, _event: Event) -> Message:
        """Ignore the event: a recording does not change."""
        return Message("not possible in a recording")

    def show_map(self, _robot: str, _floor: str) -> None:
        """Do nothing: the maps shown at the time are in the recording."""

    @property
    def counters(self) -> Mapping[str, LinkCounter]:
        """Return the counters of each link up to the played position."""
        return self._player.frames.counters

    def subscribe_logs(self, _on: bool) -> None:
        """Do nothing: logs are there if they were subscribed to while recording."""

    def close(self) -> None:
        self._player.close()
