"""The backend of a console that shows a recording: nothing goes anywhere."""

from collections.abc import Mapping

from fleet_tui.model.commands import Command
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.events import Event
from fleet_tui.recording.play.player import Player
from fleet_tui.state.store import Store


class ReplayBackend:
    """Takes nothing and has no connection; behind it a player changes the picture."""

    refusal = "not sent: this is a recording"

    def __init__(self, player: Player, store: Store) -> None:
        self.player, self._store = player, store

    def open(self) -> None:
        """Begin to play."""
        self.player.start(self._store)

    def submit(self, _command: Command) -> str:
        """Send nothing."""
        return self.refusal

    def tell(self, _event: Event) -> str:
        """Leave what was recorded as it is."""
        return "not possible in a recording"

    def show_map(self, _robot: str, _floor: str) -> None:
        """The maps that were looked at are in the recording."""

    @property
    def counters(self) -> Mapping[str, LinkCounter]:
        """Return what came over each link, as far as it was played."""
        return self.player.frames.counters

    def subscribe_logs(self, _on: bool) -> None:
        """Do nothing: logs are there if they were subscribed to while recording."""

    def close(self) -> None:
        """Stop playing."""
        self.player.close()
