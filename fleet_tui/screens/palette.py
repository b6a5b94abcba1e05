"""The command palette: every action of the keys table, and "go to" for all that has a name."""

from collections.abc import Callable, Iterable
from functools import partial

from textual import on
from textual.app import ComposeResult
from textual.fuzzy import Matcher
from textual.widgets import Input

from fleet_tui.screens.overlay import Overlay
from fleet_tui.widgets.field import Field, Keys
from fleet_tui.widgets.matches import Matches

Entry = tuple[str, Callable[[], object]]
SHOWN = 40


class Palette(Overlay):
    """Typing searches, Enter does the marked entry."""

    def __init__(self, entries: Callable[[], Iterable[Entry]]) -> None:
        super().__init__(id="palette")
        self._entries = entries
        self._found: list[Entry] = []
        self._matches = Matches(id="wishes")

    def compose(self) -> ComposeResult:
        """A field above what matches."""
        keys: Keys = {
            "enter": self._do,
            "escape": self.action_close,
            "up": partial(self._matches.step, -1),
            "down": partial(self._matches.step, 1),
            "ctrl+p": self.action_close,
        }
        yield Field(keys, id="wish", placeholder="what to do, or where to go")
        yield self._matches

    def show(self) -> None:
        """Open with everything there is."""
        field = self.query_one(Field)
        with field.prevent(Input.Changed):
            field.value = ""
        self._list()
        self.open(field)

    @on(Input.Changed, "#wish")
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        self._list()

    def _list(self) -> None:
        """What matches, the best first; without a wish everything in its own sequence."""
        typed = self.query_one(Field).value.strip()
        matcher = Matcher(typed)
        scored = [
            (matcher.match(text) if typed else 1.0, entry) for entry in self._entries() for text in entry[:1]
        ]
        scored.sort(key=lambda pair: -pair[0])
        self._found = [entry for score, entry in scored if score > 0][:SHOWN]
        self._matches.show(text for text, _ in self._found)

    def _do(self) -> None:
        # What was typed last may not have been listed yet.
        marked = self._matches.marked
        before = [text for text, _ in self._found]
        self._list()
        if before != [text for text, _ in self._found]:
            marked = 0
        if marked < len(self._found):
            self._run(marked)

    def _run(self, index: int) -> None:
        self.action_close()
        self._found[index][1]()

    @on(Matches.OptionSelected, "#wishes")
    def _clicked(self, event: Matches.OptionSelected) -> None:
        event.stop()
        if self.is_open:
            self._run(event.option_index)
