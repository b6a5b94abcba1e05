"""Filter, order, marks and copies of the rows of the main screen."""

import math
import time
from collections.abc import Callable, Sequence
from time import monotonic

from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.widget import Widget
from textual.widgets import Input, Label, Static

from fleet_tui.model.commands import Command, CommandRecord
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.details import detail_text
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.tables.marked import MarkedCommands
from fleet_tui.ui.screens.overlay import Overlay
from fleet_tui.ui.screens.tables.copy import copied_rows, copy
from fleet_tui.ui.screens.tables.pane_rows import PaneRows
from fleet_tui.ui.view.lines.commands import command_text, stage_text
from fleet_tui.ui.view.tables.groups import GroupHead
from fleet_tui.ui.widgets.field import Field, row_keys
from fleet_tui.ui.widgets.filter_field import filter_help
from fleet_tui.ui.widgets.pace import Pace
from fleet_tui.ui.widgets.panes import Panes
from fleet_tui.ui.widgets.rows_pane import RowsPane

PAUSE = 0.3
ALL_EVERY = 0.5
"""Seconds after a letter in which the panes wait, and after which they are shown all the same."""


SHOWN = 9
"""Lines; the number of others follows."""
STAYS = 8.0
"""Seconds for which it stays after the last outcome."""


class TableTools:
    """Filter, sort, mark and copy: on the focused table, without one on the fleet."""

    def __init__(self, console: Console, panes: Panes, rows: PaneRows) -> None:
        self._console = console
        self._panes = panes
        self._rows = rows
        self.filter_line = FilterLine(rows.show)
        self.outcomes = Outcomes(lambda: console.store.state)
        self.marked = MarkedCommands(console, self.robots, self.outcomes.show, self._unmark)
        self.actions = {
            "filter_rows": self._filter,
            "sort_rows": self._sort,
            "group_rows": self._group,
            "mark_row": self._mark,
            "copy_row": self._copy,
        }

    @property
    def widgets(self) -> tuple[Widget, ...]:
        """Return what is to be mounted on the screen."""
        return self.filter_line, self.outcomes

    def robots(self) -> list[str]:
        """Return the marked robots, in the order of the configuration."""
        marks = self._panes.fleet.listing.marks
        return [name for name in self._console.store.state.robots if name in marks]

    @property
    def _table(self) -> RowsPane:
        return next((table for table in self._panes.tables if table.has_focus), self._panes.fleet)

    def back(self) -> bool:
        """Close the outcomes, else clear the filter, else the marks of a table, the focused one first; False
        if there is none of these."""
        if self.outcomes.close():
            return True
        for table in (self._table, *self._panes.tables):
            if table.arrangement.typed:
                table.arrangement.typed = ""
                self._rows.show(table)
                return True
            if table.listing.marks:
                table.listing.marks.clear()
                self._renew(table)
                return True
        return False

    def _filter(self) -> None:
        if self._table.size.height:
            self.filter_line.start(self._table)
        else:
            self._console.notices.say(Message("no table is in view: Esc shows them"))

    def _sort(self) -> None:
        self._table.arrangement.next_column()
        self._renew(self._table)

    def _group(self) -> None:
        fleet = self._panes.fleet
        if not fleet.arrangement.groups.next(self._console.navigation.here):
            self._console.notices.say(Message("one floor and one link: nothing to group by"))
        self._rows.show(fleet)

    def fold(self, head: GroupHead) -> None:
        """Fold a group of the fleet, or unfold it; the cursor stays on it."""
        self._panes.fleet.arrangement.groups.fold(head)
        self._renew(self._panes.fleet)

    def _renew(self, table: RowsPane) -> None:
        """Show the newest rows; the cursor stays, on the head of a group, too."""
        table.show(self._rows.of(table))

    def _mark(self) -> None:
        if isinstance(self._table.listing.cursor, GroupHead):
            self._console.notices.say(Message("a group can't be marked: mark its robots"))
            return
        self._table.listing.toggle_mark()
        self._renew(self._table)

    def _unmark(self) -> None:
        for table in self._panes.tables:
            table.listing.marks.clear()
            self._renew(table)

    def _copy(self) -> None:
        copy(self._panes, *copied_rows(self._table.listing), self._console.notices.say)


class FilterLine(Overlay):
    """Above the footer, in the place of the message. `show` shows the newest rows of a pane, and the best
    one for what is typed."""

    def __init__(self, show: Callable[[RowsPane, str], None]) -> None:
        super().__init__(id="filter-line")
        self._show = show
        self._pane: RowsPane | None = None
        self._typed_at = -math.inf
        self._pace = Pace(ALL_EVERY)
        keys = {**row_keys(self), "enter": self._keep, "escape": self.action_close}
        self._field = Field(keys, id="filter-text")
        self._title = Label(id="filter-name", markup=False)

    def compose(self) -> ComposeResult:
        """Compose the name of the table, and the field."""
        yield Horizontal(self._title, self._field)

    def start(self, pane: RowsPane) -> None:
        """Open it for a table, with its filter."""
        self._pane = pane
        pane.arrangement.is_typing = True
        self._field.placeholder = filter_help(pane.arrangement)
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

    @property
    def page(self) -> int:
        return self._pane.page if self._pane is not None else 0

    def move(self, step: int) -> None:
        """Move the cursor of the table, as it is filtered by what is typed."""
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


class Outcomes(Static):
    """Over the tables, without the focus: keys go on to where they went."""

    def __init__(self, state: Callable[[], FleetState]) -> None:
        super().__init__(id="outcomes", markup=False)
        self.border_title = tr("Outcomes")
        self.border_subtitle = tr("marks cleared, Esc closes")
        self._state = state
        self._told: Sequence[tuple[Command, Message]] = ()
        self._since = 0.0
        self._ends = math.inf
        self.display = False

    def show(self, told: Sequence[tuple[Command, Message]], since: float) -> None:
        """Show the outcome of each of these commands, sent from `since` (monotonic) on, or the reason that it
        was not sent."""
        self._told = told
        self._since = since
        self._ends = math.inf
        self.display = True
        self.look()

    def close(self) -> bool:
        """Close it; False if it was not open."""
        was_open, self.display = self.display, False
        return was_open

    def look(self) -> None:
        """Show the newest stage of each, and close when all have been known for a while."""
        if not self.display:
            return
        state, now = self._state(), monotonic()
        records = [
            None if problem else _record(state, command, self._since) for command, problem in self._told
        ]
        if all(record is None or record.is_decided for record in records):
            self._ends = min(self._ends, now + STAYS)
        if now >= self._ends or self._is_outdated(state):
            self.display = False
            return
        told = zip(self._told, records, strict=True)
        lines = [_line(state, command, problem, record) for (command, problem), record in told]
        more = [tr("and {count} more: L has all", count=len(lines) - SHOWN)] if len(lines) > SHOWN else []
        text = "\n".join([*lines[:SHOWN], *more])
        if text != self.content:
            self.update(text)

    def _is_outdated(self, state: FleetState) -> bool:
        """Tell whether another command was given since."""
        told = [command for command, _ in self._told]
        return any(one.issued_at >= self._since and one.command not in told for one in state.commands)


def _record(state: FleetState, command: Command, since: float) -> CommandRecord | None:
    """Return the newest record of a command given from `since` (monotonic) on."""
    found = (record for record in reversed(state.commands) if record.command == command)
    return next((record for record in found if record.issued_at >= since), None)


def _line(state: FleetState, command: Command, problem: Message, record: CommandRecord | None) -> str:
    text = command_text(state, command)
    if record is None:
        return f"{text}: {translate(sanitize(problem)) or tr('sending')}"
    return f"{text}: {stage_text(record, state.now)}{translate(detail_text(sanitize(record.detail)))}"
