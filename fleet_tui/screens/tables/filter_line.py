"""The line in which a filter is typed: its table follows with each letter."""

import math
import time
from collections.abc import Callable
from functools import partial

from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.widgets import Input, Label

from fleet_tui.screens.overlay import Overlay
from fleet_tui.text.language import tr
from fleet_tui.widgets.field import Field
from fleet_tui.widgets.pace import Pace
from fleet_tui.widgets.rows_pane import RowsPane

PAUSE = 0.3
ALL_EVERY = 0.5
"""Seconds after a letter in which the panes wait, and after which they are shown all the same."""


class FilterLine(Overlay):
    """Above the footer, in the place of the message. `show` shows the newest rows of a pane, and the best
    one for what is typed."""

    def __init__(self, show: Callable[[RowsPane, str], None]) -> None:
        super().__init__(id="filter-line")
        self._show = show
        self._pane: RowsPane | None = None
        self._typed_at = -math.inf
        self._pace = Pace(ALL_EVERY)
        steps = {"up": -1, "down": 1, "pageup": -10, "pagedown": 10}
        keys: dict[str, Callable[[], object]] = {
            key: partial(self._move, step) for key, step in steps.items()
        }
        keys |= {"enter": self._keep, "escape": self.action_close}
        self._field = Field(keys, id="filter-text")
        self._title = Label(id="filter-name", markup=False)

    def compose(self) -> ComposeResult:
        """Compose the name of the table, and the field."""
        yield Horizontal(self._title, self._field)

    def start(self, pane: RowsPane) -> None:
        """Open it for a table, with its filter."""
        self._pane = pane
        pane.arrangement.is_typing = True
        keys = " ".join(f"{name}:" for name in pane.arrangement.names)
        self._field.placeholder = tr(f"words !word {keys} Enter keeps, Esc clears")
        self._title.update(f" {tr((pane.id or '').capitalize())} /")
        with self._field.prevent(Input.Changed):
            self._field.value = pane.arrangement.typed
        self._typed_at = time.monotonic()
        self._show(pane, "")
        self.open(self._field)

    @on(Input.Changed)
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        if self.is_open:  # else it comes from a field that is already left
            self._apply(event.value)

    def _apply(self, typed: str) -> None:
        if self._pane is not None and typed != self._pane.arrangement.typed:
            self._pane.arrangement.typed = typed
            self._typed_at = time.monotonic()
            self._show(self._pane, typed)

    @property
    def goes_first(self) -> bool:
        """Tell whether the other panes have to wait: the next letter may come any moment, and a tick of
        hundreds of robots takes the time of a frame."""
        return self.is_open and time.monotonic() - self._typed_at < PAUSE and not self._pace.is_due()

    def _move(self, step: int) -> None:
        self._apply(self._field.value)
        if self._pane is not None:
            self._pane.move(step)

    def _keep(self) -> None:
        """Keep the filter, and go to the row that it found."""
        # The last letters may not have been applied yet.
        self._apply(self._field.value)
        if self._pane is not None:
            self._before = self._pane
            self._pane.pick()
        super().action_close()

    def action_close(self) -> None:
        """Clear the filter, and restore the focus."""
        self._apply("")
        super().action_close()

    def on_hide(self) -> None:
        """Note that nothing is typed any more, whatever closed it."""
        if self._pane is not None:
            self._pane.arrangement.is_typing = False
