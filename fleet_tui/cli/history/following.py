"""Links and notes of a service, told when they change."""

from collections.abc import Callable, Iterable

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.text.sanitize import sanitize


class Following:
    """Says each link's state once, and again when it changes."""

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say = say
        self._told: dict[str, str] = {}

    def look(self, state: FleetState, notes: Iterable[str] = ()) -> None:
        """Say what changed since the last call."""
        news = {link.url: _words(link) for link in state.links.values()}
        for name, text in news.items():
            if self._told.get(name) != text:
                self._say(sanitize(f"{name}: {text}"))
        for note in notes:
            if note not in self._told:
                self._say(sanitize(note))
        self._told = {**news, **dict.fromkeys(notes, "")}


def _words(link: LinkState) -> str:
    if link.phase is Phase.UP:
        return "connected"
    return f"no link{': ' if link.reason else ''}{link.reason}"
