"""The backend of a console that shows a recording: nothing goes anywhere."""

from collections.abc import Callable, Mapping

from fleet_tui.config.schema import Config
from fleet_tui.model.commands import Command
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.events import Event
from fleet_tui.recording.play.player import Player
from fleet_tui.state.store import Store


class ReplayBackend:
    """Takes nothing and has no connection; behind it a player changes the picture."""

    def __init__(self, player: Player) -> None:
        self._player = player

    def open(self, _config: Config, store: Store, stands: "Callable[[ReplayBackend], None]") -> None:
        """Begin to play."""
        stands(self)
        self._player.start(store)

    def submit(self, _command: Command) -> None:
        """Nothing can be sent."""

    def tell(self, _event: Event) -> None:
        """Ignore the event: a recording is not changed."""

    def show_map(self, _robot: str, _floor: str) -> None:
        """The maps that were looked at are in the recording."""

    @property
    def counters(self) -> Mapping[str, LinkCounter]:
        """Return what came over each link, as far as it was played."""
        return self._player.frames.counters

    def overhear(self, _on: bool) -> None:
        """Do nothing: logs are there if they were subscribed to while recording."""

    def close(self) -> None:
        """Stop playing."""
        self._player.close()
