"""The diagnostics screen: a live version of `doctor`. It uses no resources while it is closed."""

from collections.abc import Callable, Hashable, Mapping
from functools import partial
from typing import ClassVar

from textual.binding import BindingType

from fleet_tui.keys import PAGES, Pane
from fleet_tui.situation.why.reason import Reason
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.screens.diagnosing.pages import BESIDE, Page, Pages, line_of
from fleet_tui.ui.screens.tables.paged_overlay import PagedOverlay
from fleet_tui.ui.terminal.budget import Budget
from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.view.lines.diagnostics import foot_runs, page_runs
from fleet_tui.ui.widgets.bindings import bindings, overlay_bindings

EVERY = 0.25  # seconds between two updates
TWO_PAGES = 180
"""Cells of the screen from which a second page is beside the open one."""


class DiagnosticsControls:
    """`current` is the open page, `notice` the response to the last key."""

    def __init__(self, view: "Diagnostics", pages: Pages) -> None:
        self._view = view
        self._pages = pages
        self.current = Page.LINK
        self.notice = EMPTY
        self._cursors: dict[Page, Hashable] = {}
        self._came_from_topics = False
        self._robot = ""
        self.actions: dict[str, Callable[[], None]] = {
            **{f"page_{name.lower()}": partial(self.page, n) for n, name in enumerate(PAGES, 1)},
            "next_page": partial(self.step_page, 1),
            "previous_page": partial(self.step_page, -1),
            "filter": self.filter,
            "freeze": self.freeze,
            "copy": self.copy,
            "level": self.next_level,
            "bad": self.show_bad,
            "leave": self.leave,
        }

    def begin(self, robot: str, page: Page | None = None) -> None:
        """Show a page, by default the one that was open last; a topic of `robot` is marked if another one was
        looked at, on a given page its worst part, too."""
        self._pages.robot = robot
        if robot != self._robot or page is Page.TOPICS:
            first = self._pages.worst_topic if page is Page.TOPICS else self._pages.first_topic
            self._robot = robot
            self._pages.topic = first(robot)
            self._cursors[Page.TOPICS] = self._pages.topic
            if self.current is Page.TOPICS:
                self._view.rows.listing.cursor = self._pages.topic
        self._pages.begin_log(robot)
        self._turn_to(self.current if page is None else page)
        if page is Page.HEALTH:
            self._view.rows.listing.cursor = self._pages.first_part(robot)

    def page(self, number: int) -> None:
        """Show a page, with its last cursor position."""
        self._turn_to(number)
        self._view.look()

    def _turn_to(self, number: int) -> None:
        self._cursors[self.current] = self._view.rows.listing.cursor
        self.current = Page(number)
        self.notice = EMPTY
        self._came_from_topics = False
        self._view.rows.listing.cursor = self._cursors.get(self.current)
        self._view.rows.arrangement = self._pages.arrangements[self.current]
        self._view.put_filter(self._view.rows.arrangement.typed)

    def step_page(self, step: int) -> None:
        """Show the next (1) or previous (-1) page."""
        self.page((self.current - 1 + step) % len(Page) + 1)

    def filter(self) -> None:
        """Open the field for the filter of the rows, on a page that has columns."""
        if self.current is not Page.RAW:
            self._view.action_filter()

    def freeze(self) -> None:
        """Freeze the message or the log, or resume."""
        nothing = Message("only the message and the robot log can be frozen")
        self.say(EMPTY if self._pages.freeze(self.current) else nothing)

    def copy(self) -> None:
        """Copy the message, or the rows."""
        self._view.action_copy()

    def say(self, text: Message) -> None:
        self.notice = text
        self._view.look()

    def next_level(self) -> None:
        """Show fewer levels of the robots' log, or all again."""
        if self.current is Page.LOG:
            self._pages.next_level()
            self._view.look()

    def show_bad(self) -> None:
        """Show the last bad message of the topic, or its newest one again."""
        if self.current is Page.RAW:
            self._pages.turn_bad()
            self._view.look()

    def leave(self) -> None:
        """Go one level back: from a message to the topics, from the log of the robot in trouble to all, else
        close the screen."""
        if self.current is Page.RAW and self._came_from_topics:
            self.page(Page.TOPICS)
        elif self.current is Page.LOG and self._pages.shows_troubled:
            self._pages.arrangements[Page.LOG].typed = ""
            self.page(Page.LOG)
        else:
            self._view.action_close()

    def choose(self, key: Hashable) -> None:
        """Open a row."""
        match self.current, key:
            case Page.LINK, _:
                self.page(Page.TOPICS)
            case Page.TOPICS, (str(link), str(topic)):
                self._pages.choose(link, topic)
                self.page(Page.RAW)
                self._came_from_topics = True
            case Page.LOG, _:
                line = self._view.rows.listing.cursor = line_of(key)
                self._pages.opened_lines ^= {line}
                self._view.look()
            case Page.HEALTH, _:
                self._pages.opened ^= {key}
                self._view.look()


class Diagnostics(PagedOverlay):
    """One table with the rows of the open page."""

    BINDINGS: ClassVar[list[BindingType]] = [*bindings(Pane.DIAGNOSTICS), *overlay_bindings("diagnostics")]

    def __init__(self, pages: Pages, keys: Mapping[str, tuple[str, ...]]) -> None:
        self._pages = pages
        self._keys = keys
        self._controls = DiagnosticsControls(self, pages)
        self.actions = self._controls.actions
        super().__init__("diagnostics", self._controls.choose, EVERY, self._controls.say)

    def show(self, robot: str, cause: Reason | None = None) -> None:
        """Open on the last page, first the link's, for a `cause` on the one that shows more of it; `robot` is
        the one whose topic is marked first."""
        self.open(self.rows)
        self._controls.begin(robot, None if cause is None else Page[cause.page.upper()])
        self.begin(self.rows)

    @property
    def copied(self) -> tuple[str, str]:
        """Return the message or the rows to copy, and their description."""
        return self._pages.copied if self._controls.current is Page.RAW else super().copied

    @property
    def _budget(self) -> Budget:
        assert isinstance(self.app, LeanApp)
        return self.app.output.budget

    def look(self) -> None:
        """Show the current page."""
        page, listing = self._controls.current, self.rows.listing
        self.beside.display = self.screen.size.width >= TWO_PAGES
        self._pages.width = self.rows.row_width
        table = self._pages.table(page, self._budget)
        keys = table.keys
        if listing.cursor is None and keys and not table.is_followed:
            listing.cursor = keys[0]
        self.rows.show(table)
        if self.beside.display:
            self._show_beside(BESIDE[page])
        self._tabs.show(*page_runs(list(PAGES), page, self._pages.frozen(page)))
        self._foot.show(*foot_runs(self._keys, page, self._controls.notice))

    def _show_beside(self, page: Page) -> None:
        marked = self.rows.listing.cursor
        if page is Page.RAW and isinstance(marked, tuple) and marked != self._pages.topic:
            self._pages.choose(*marked)
        self._pages.width = self.beside.row_width
        self.beside.show(self._pages.table(page, self._budget))

    def action_key(self, id_: str) -> None:
        self.actions[id_]()
