"""Filter, order, marks and copies of the rows of the main screen."""

from functools import partial
from typing import TYPE_CHECKING

from textual.widget import Widget

from fleet_tui.actions import TableActions
from fleet_tui.controllers.dispatch import Ask
from fleet_tui.controllers.tables.marked import MarkedCommands
from fleet_tui.screens.tables.filter_line import FilterLine
from fleet_tui.screens.tables.outcomes import Outcomes
from fleet_tui.terminal.clipboard import clipboard, copied_text
from fleet_tui.terminal.lean_app import LeanApp
from fleet_tui.view.tables.groups import GroupHead
from fleet_tui.widgets.rows_pane import RowsPane

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen

TRIES = 5
AGAIN_AFTER = 0.1
"""Copies while the terminal is still reading the last picture, and seconds between them."""


class TableTools:
    """Filter, sort, mark and copy: on the focused table, without one on the fleet."""

    def __init__(self, screen: "MainScreen", ask: Ask) -> None:
        self._screen = screen
        self.filter_line = FilterLine(screen.show_rows)
        self.outcomes = Outcomes(lambda: screen.store.state)
        self.marked = MarkedCommands(
            screen.store, screen.dispatch, ask, self.robots, self.outcomes.show, self._unmark
        )
        self.actions = TableActions(self._filter, self._sort, self._group, self._mark, self._copy)

    @property
    def widgets(self) -> tuple[Widget, ...]:
        """Return what is to be mounted on the screen."""
        return self.filter_line, self.outcomes

    def robots(self) -> list[str]:
        """Return the marked robots, in the order of the configuration."""
        marks = self._screen.fleet.listing.marks
        return [name for name in self._screen.store.state.robots if name in marks]

    @property
    def _table(self) -> RowsPane:
        return next((table for table in self._screen.panes.tables if table.has_focus), self._screen.fleet)

    def back(self) -> bool:
        """Close the outcomes, else clear the filter, else the marks of a table, the focused one first; False
        if there is none of these."""
        if self.outcomes.close():
            return True
        for table in (self._table, *self._screen.panes.tables):
            if table.arrangement.typed:
                table.arrangement.typed = ""
            elif table.listing.marks:
                table.listing.marks.clear()
            else:
                continue
            self._screen.show_rows(table)
            return True
        return False

    def _filter(self) -> None:
        if self._table.size.height:
            self.filter_line.start(self._table)
        else:
            self._screen.notices.say("no table is in view: Esc shows them")

    def _sort(self) -> None:
        self._table.arrangement.next_column()
        self._screen.show_rows(self._table)

    def _group(self) -> None:
        fleet = self._screen.fleet
        if not fleet.arrangement.groups.next(self._screen.navigation.here):
            self._screen.notices.say("one floor and one link: nothing to group by")
        self._screen.show_rows(fleet)

    def fold(self, head: GroupHead) -> None:
        """Fold a group of the fleet, or unfold it; the cursor stays on it."""
        fleet = self._screen.fleet
        fleet.arrangement.groups.fold(head)
        fleet.show(self._screen.newest.of(fleet))

    def _mark(self) -> None:
        if isinstance(self._table.listing.cursor, GroupHead):
            self._screen.notices.say("a group can't be marked: mark its robots")
            return
        self._table.listing.toggle_mark()
        self._screen.show_rows(self._table)

    def _unmark(self) -> None:
        for table in self._screen.panes.tables:
            table.listing.marks.clear()
        self._screen.tick()

    def _copy(self, tries: int = TRIES) -> None:
        """Copy the cursor's row to the clipboard of the local terminal, also over ssh."""
        app, say, line = self._screen.app, self._screen.notices.say, self._table.listing.line
        assert isinstance(app, LeanApp)
        if not line:
            say("nothing to copy")
        elif app.output.call(clipboard(line)):
            say(copied_text(line))
        elif tries > 1:
            self._screen.set_timer(AGAIN_AFTER, partial(self._copy, tries - 1))
        else:
            say("not copied: the terminal is not reading")
