"""Help: every key, generated from the table of keys; typed text searches."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from textual import on
from textual.app import ComposeResult
from textual.containers import VerticalScroll
from textual.widgets import Input, Static

from fleet_tui.keys import KEYS, Key, Pane
from fleet_tui.model.kind import ORDER, Kind
from fleet_tui.screens.overlay import Overlay
from fleet_tui.widgets.field import Field, Keys

SECTIONS = (Pane.RECORDING, Pane.MAP, Pane.TABLE, Pane.DIAGNOSTICS, Pane.CONSOLE, Pane.ANYWHERE)

ORDER_FORM = """\
Order form: type to filter the labels, Enter selects the marked one; Enter in To sends; > after \
a label adds a leg (A > B > C). To lists the robot's last destinations first.
"""
TYPED = {
    "order": "robot_0 Base > Store, robot_0 A > B > C, robot_0 > B ({alone} to B), order robot_0 Base Store",
    "cancel": "cancel 12, cancel robot_0 12",
    "clear": "clear robot_0",
    "pause": "pause all, pause robot_0",
    "resume": "resume robot_0, resume all",
}
NOTES = """\
Robots go by name or number, places by label or id; id=7 is always the id.
Enter on an order: repeat, return trip, origin. The same order within 1 s is not sent twice.
Confirmations: y confirms; n, Esc or Enter cancels.
Mouse: wheel zooms at the pointer, drag pans, click selects. To select text with the \
terminal, hold Shift.
Pause is not a safety device: near people, use the robot's own stop."""


def notes(kind: Kind) -> str:
    """Return further notes for robots of a kind."""
    typed = ", ".join(text for verb, text in TYPED.items() if kind.can(verb))
    typed = typed.format(alone="cargo on board" if "cargo" in kind.reports else "directly")
    form = ORDER_FORM if kind.can(ORDER) else ""
    return f"{form}Typed commands (: then Tab completes, Enter sends): {typed or 'none'}. {NOTES}"


class Help(Overlay):
    """The keys of the focused pane first, then the rest."""

    def __init__(self, keys: Mapping[str, tuple[str, ...]]) -> None:
        super().__init__(id="help")
        self._keys = keys
        self._pane, self._hidden, self._kind = Pane.CONSOLE, set[str](), Kind()

    def compose(self) -> ComposeResult:
        """Compose a search field above the list."""
        keys: Keys = {
            "escape": self.action_close,
            "up": partial(self.action_scroll, -1),
            "down": partial(self.action_scroll, 1),
            "pageup": partial(self.action_scroll, -10),
            "pagedown": partial(self.action_scroll, 10),
        }
        yield Field(keys, id="search", placeholder="type to search, Esc closes")
        with VerticalScroll(can_focus=False):
            yield Static(id="keys", markup=False)

    def show(self, pane: Pane, detail: str, kind: Kind, hidden: set[str]) -> None:
        """Open on the keys of a pane, except those `hidden`, for robots of a kind; `detail` describes the
        terminal."""
        self._pane, self._detail, self._kind, self._hidden = pane, detail, kind, hidden
        search = self.query_one("#search", Input)
        search.value = ""
        self._list("")
        self.open(search)

    @on(Input.Changed, "#search")
    def search(self, event: Input.Changed) -> None:
        """Filter by the typed text."""
        event.stop()
        self._list(event.value)

    def _list(self, wanted: str) -> None:
        lines = []
        for section in sorted(SECTIONS, key=lambda section: section is not self._pane):
            if section is Pane.RECORDING and self._pane is not section:
                continue  # no recording is open
            shown = (key for key in KEYS if key.section is section and key.id not in self._hidden)
            found = [self._line(key) for key in shown if self._is_wanted(wanted, key)]
            if found:
                lines += [section.value, *found, ""]
        if not wanted:
            lines += [notes(self._kind), "", self._detail]
        self.query_one("#keys", Static).update("\n".join(lines) or f"no key matches {wanted!r}")
        self.query_one(VerticalScroll).scroll_home(animate=False)

    def _line(self, key: Key[Any]) -> str:
        return f"  {' '.join(self._keys[key.id]) or '(palette)':<10} {key.text}  ({key.id})"

    def _is_wanted(self, wanted: str, key: Key[Any]) -> bool:
        """Tell whether a key matches; a single character means the key itself."""
        if len(wanted) == 1:
            return wanted in self._keys[key.id]
        texts = (key.text, key.id, *self._keys[key.id])
        return any(wanted.casefold() in text.casefold() for text in texts)

    def action_scroll(self, rows: int) -> None:
        """Scroll up or down."""
        self.query_one(VerticalScroll).scroll_relative(y=rows, animate=False)
