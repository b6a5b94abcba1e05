"""The last line: the newest message for the operator."""

import math
from collections.abc import Callable
from time import monotonic

from fleet_tui.state.store import Store
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.view.lines.commands import newest

SHOWN = 8.0
"""Seconds for which a text is shown: later it would read as the answer to the last key."""

READ = 2.0
"""Seconds after which a text was read, so that the next key ends it."""


class Notices:
    """Keeps the newest text and the number of the newest command at that time; `text` is the first one."""

    def __init__(
        self,
        store: Store,
        refresh: Callable[[], None],
        text: Message = EMPTY,
        clock: Callable[[], float] = monotonic,
    ) -> None:
        self._store = store
        self._refresh = refresh
        self._clock = clock
        self._text = text
        self._until = clock() + SHOWN
        self.at = 0.0
        self._since = math.inf
        """Since when the text is shown, which a key may end; the first one is for a newcomer."""
        self.key_at = 0.0
        """The time of the last key of the console (monotonic seconds, of the state)."""
        self.is_hint = False
        """The newest text only helps: it is quiet, and the next key ends it."""
        self._hinted: set[str] = set()

    @property
    def text(self) -> Message:
        """Return the newest text while it is shown, by the time of this console also in a replay."""
        return self._text if self._clock() < self._until else EMPTY

    def say(self, text: Message, stays: bool = False) -> None:
        """Show a text at once."""
        self.note(text, stays)
        self._refresh()

    def hint(self, text: Message, topic: str = "") -> None:
        """Show a text that only helps, until the next key; on a `topic` once in a session."""
        if topic not in self._hinted:
            self._hinted |= {topic} - {""}
            self.note(text)
            self.is_hint = True
            self._refresh()

    def note(self, text: Message, stays: bool = False) -> None:
        """Show a text with the next tick; if it `stays`, until there is a newer one."""
        self._text = text
        self.at = newest(self._store.state)
        self.is_hint = False
        self._until = math.inf if stays else self._clock() + SHOWN
        self._since = math.inf if stays else self._clock()

    def key_pressed(self) -> None:
        """Remember the time of a key: what it leaves behind was read, and a text that had time for that
        ends."""
        self.key_at = newest(self._store.state)
        if self.is_hint or self._clock() - self._since >= READ:
            self._text = EMPTY

    def clear(self) -> None:
        """Show no text."""
        self._text = EMPTY
