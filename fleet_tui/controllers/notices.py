"""The last line: the newest message for the operator."""

from collections.abc import Callable

from fleet_tui.state.store import Store
from fleet_tui.view.lines.commands import newest


class Notices:
    """Keeps the newest text and the number of the newest command at that time."""

    def __init__(self, store: Store, refresh: Callable[[], None], text: str = "") -> None:
        self._store, self._refresh = store, refresh
        self.text, self.at = text, 0.0

    def say(self, text: str) -> None:
        """Show a text at once."""
        self.note(text)
        self._refresh()

    def note(self, text: str) -> None:
        """Show a text with the next tick."""
        self.text, self.at = text, newest(self._store.state)
