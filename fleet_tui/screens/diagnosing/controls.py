"""Actions of the diagnostics screen: pages, freezing and copying."""

from collections.abc import Hashable
from functools import partial
from typing import TYPE_CHECKING

from fleet_tui.screens.diagnosing.pages import Page, Pages, line_of
from fleet_tui.terminal.clipboard import clipboard, copied_text
from fleet_tui.text.language import tr

if TYPE_CHECKING:
    from fleet_tui.screens.diagnosing.overlay import Diagnostics


class DiagnosticsControls:
    """`current` is the open page, `notice` the response to the last key."""

    def __init__(self, view: "Diagnostics", pages: Pages) -> None:
        self._view = view
        self._pages = pages
        self.current = Page.LINK
        self.notice = ""
        self._cursors: dict[Page, Hashable] = {}
        self._came_from_topics = False
        self._robot = ""

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
        self.page(self.current if page is None else page)
        if page is Page.HEALTH:
            self._view.rows.listing.cursor = self._pages.first_part(robot)
            self._view.look()

    def page(self, number: int) -> None:
        """Show a page, with its last cursor position."""
        self._cursors[self.current] = self._view.rows.listing.cursor
        self.current = Page(number)
        self.notice = ""
        self._came_from_topics = False
        self._view.rows.listing.cursor = self._cursors.get(self.current)
        self._view.put_filter(self._pages.wanted.get(self.current, ""))
        self._view.look()

    def step_page(self, step: int) -> None:
        """Show the next (1) or previous (-1) page."""
        self.page((self.current - 1 + step) % len(Page) + 1)

    def filter(self) -> None:
        """Open the field for the filter of the rows."""
        self._view.open_filter()

    def freeze(self) -> None:
        """Freeze the message or the log, or resume."""
        nothing = tr("only the message and the robot log can be frozen")
        self.notice = "" if self._pages.freeze(self.current) else nothing
        self._view.look()

    def copy(self, tries: int = 5) -> None:
        """Copy to the clipboard of the local terminal, also over ssh. It may still be reading the last
        picture."""
        output = self._view.output
        text, what = self._pages.copy(self.current, self._view.rows.listing.cursor, output.budget)
        if not text:
            self.notice = tr("nothing to copy")
        elif output.call(clipboard(text)):
            self.notice = copied_text(what)
        elif tries > 1:
            self._view.set_timer(0.1, partial(self.copy, tries - 1))
            return
        else:
            self.notice = tr("not copied: the terminal is not reading")
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
            self._pages.wanted[Page.LOG] = ""
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
