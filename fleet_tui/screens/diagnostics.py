"""The diagnostics screen: what `doctor` finds out once, live. Nothing of it works while it is closed."""

import base64
import os
from collections.abc import Hashable, Mapping
from functools import partial
from typing import ClassVar

from rich.style import Style
from textual import on
from textual.actions import SkipAction
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.timer import Timer
from textual.widgets import Input

from fleet_tui.backend import Backend
from fleet_tui.keys import DIAGNOSTICS, PAGES, Pane, by_id
from fleet_tui.screens.diagnostics_pages import FILTERED, Page, Pages
from fleet_tui.screens.overlay import Overlay
from fleet_tui.terminal.lean_app import LeanApp
from fleet_tui.view.lines.diagnostics import foot_runs, page_runs
from fleet_tui.view.roles import StyleRole
from fleet_tui.widgets.bindings import bindings
from fleet_tui.widgets.field import Field, Keys
from fleet_tui.widgets.line_view import LineView
from fleet_tui.widgets.messages import RowPicked
from fleet_tui.widgets.rows_pane import RowsPane

KEYS = by_id(DIAGNOSTICS)
EVERY = 0.25  # seconds between two looks


def clipboard(text: str) -> str:
    """The bytes that ask a terminal to put a text into its clipboard (OSC 52)."""
    return f"\x1b]52;c;{base64.b64encode(text.encode(errors='replace')).decode()}\x07"


class Diagnostics(Overlay):
    """One table whose rows are those of the page that is shown."""

    BINDINGS: ClassVar[list[BindingType]] = [
        *bindings(Pane.DIAGNOSTICS),
        *(
            Binding(binding.key, "close", show=False, id=binding.id)
            for binding in bindings(Pane.CONSOLE)
            if isinstance(binding, Binding) and binding.id == "diagnostics"
        ),
    ]

    def __init__(self, pages: Pages, backend: Backend, keys: Mapping[str, tuple[str, ...]]) -> None:
        super().__init__(id="diagnostics")
        self._pages, self._backend, self._keys = pages, backend, keys
        self._page = Page.LINK
        self._back = False
        self._cursors: dict[Page, Hashable] = {}
        self._end: Hashable = None
        self._said = ""
        self._listens = False
        self._timer: Timer | None = None
        self.rows = RowsPane(id="diagnostics-rows", choose=self._choose)
        self._tabs = LineView(id="diagnostics-pages")
        self._foot = LineView(id="diagnostics-keys", keep_right=True)

    def compose(self) -> ComposeResult:
        """The pages' names, a field that shows up when it is used, the rows, the keys."""
        keys: Keys = {
            "enter": self._leave_field,
            "escape": partial(self._leave_field, clear=True),
            "up": partial(self.rows.move, -1),
            "down": partial(self.rows.move, 1),
            "pageup": partial(self.rows.move, -10),
            "pagedown": partial(self.rows.move, 10),
        }
        yield self._tabs
        yield Field(keys, id="diagnostics-filter", placeholder="text in the rows; Enter keeps it, Esc clears")
        yield self.rows
        yield self._foot

    def set_inks(self, styles: Mapping[StyleRole, Style]) -> None:
        """Change every colour."""
        for view in (self._tabs, self.rows, self._foot):
            view.set_inks(styles)

    def show(self, robot: str) -> None:
        """Open, first on the link; `robot` is the one whose topic is marked first."""
        if self._pages.topic is None:
            self._pages.topic = self._cursors[Page.TOPICS] = self._pages.first_topic(robot)
        self.open(self.rows)
        self.page(self._page)
        self._tick()
        if self._timer is None:
            self._timer = self.set_interval(EVERY, self._tick)

    def _tick(self) -> None:
        if self._listens != self.is_open:
            self._listens = self.is_open
            self._backend.overhear(self.is_open)
        if self.is_open:
            self.look()
        elif self._timer is not None:
            self._timer.stop()
            self._timer = None

    def on_resize(self) -> None:
        """Fill it at its new size."""
        if self.is_open:
            self.look()

    @property
    def _app(self) -> LeanApp:
        assert isinstance(self.app, LeanApp)
        return self.app

    def look(self) -> None:
        """Show what is there now."""
        table = self._pages.table(self._page, self._app.output.budget)
        keys = table.keys
        # At the end of the log, the cursor stays at the end.
        if self._page is Page.LOG and keys and self.rows.listing.cursor in (None, self._end):
            self.rows.listing.cursor = keys[-1]
        self._end = keys[-1] if keys else None
        if self.rows.listing.cursor is None and keys:
            self.rows.listing.cursor = keys[0]
        self.rows.show(table)
        self._tabs.show(*page_runs(list(PAGES), self._page, self._pages.frozen(self._page)))
        self._foot.show(*foot_runs(self._keys, self._page, self._said))

    def action_key(self, id_: str) -> None:
        """Do what a key of this screen is for."""
        KEYS[id_].action(self)

    def page(self, number: int) -> None:
        """Show a page, with the cursor where it was."""
        self._cursors[self._page] = self.rows.listing.cursor
        self._page, self._said, self._back = Page(number), "", False
        self.rows.listing.cursor = self._cursors.get(self._page)
        field = self.query_one(Field)
        with field.prevent(Input.Changed):
            field.value = self._pages.wanted.get(self._page, "")
        field.display = bool(field.value)
        self.screen.set_focus(self.rows)
        self.look()

    def step_page(self, step: int) -> None:
        """The next or previous page."""
        self.page((self._page - 1 + step) % len(Page) + 1)

    def filter(self) -> None:
        """Type what must stand in the rows."""
        field = self.query_one(Field)
        if self.screen.focused is field:
            raise SkipAction  # there it is a letter of a topic
        if self._page in FILTERED:
            field.display = True
            self.screen.set_focus(field)

    @on(Input.Changed, "#diagnostics-filter")
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        self._pages.wanted[self._page] = event.value.strip()
        self.look()

    def _leave_field(self, clear: bool = False) -> None:
        field = self.query_one(Field)
        if clear:
            field.value = ""
        field.display = bool(field.value)
        self.screen.set_focus(self.rows)

    def freeze(self) -> None:
        """Keep the message or the log as it is, or go on."""
        nothing = "only the message and the robots' log can be frozen"
        self._said = "" if self._pages.freeze(self._page) else nothing
        self.look()

    def copy(self, tries: int = 5) -> None:
        """To the clipboard of the terminal, wherever that runs. It may still be reading the last picture."""
        text, what = self._pages.copy(self._page, self.rows.listing.cursor, self._app.output.budget)
        if not text:
            self._said = "nothing to copy"
        elif self._app.output.call(clipboard(text)):
            tmux = " (tmux: set -s set-clipboard on)" if "TMUX" in os.environ else ""
            self._said = f"sent to the clipboard: {what}{tmux}"
        elif tries > 1:
            self.set_timer(0.1, partial(self.copy, tries - 1))
            return
        else:
            self._said = "not copied: the terminal does not read now"
        self.look()

    def next_level(self) -> None:
        """Fewer levels of the robots' log, or all again."""
        if self._page is Page.LOG:
            self._pages.next_level()
            self.look()

    def show_bad(self) -> None:
        """The last message of the topic, or the last bad one."""
        if self._page is Page.RAW:
            self._pages.turn_bad()
            self.look()

    def leave(self) -> None:
        """One level back: from a message to the topics, else out."""
        if self._page is Page.RAW and self._back:
            self.page(Page.TOPICS)
        else:
            self.action_close()

    @on(RowPicked)
    def _picked(self, event: RowPicked) -> None:
        event.stop()

    def _choose(self, key: Hashable) -> None:
        match self._page, key:
            case Page.LINK, _:
                self.page(Page.TOPICS)
            case Page.TOPICS, (str(link), str(topic)):
                self._pages.choose(link, topic)
                self.page(Page.RAW)
                self._back = True
            case Page.HEALTH, _:
                self._pages.opened ^= {key}
                self.look()
