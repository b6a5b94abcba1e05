"""Help: tasks, keys, the legend and typed commands; typed text searches all of them."""

from functools import cache, partial

from textual import on
from textual.app import ComposeResult
from textual.content import Content
from textual.widgets import Input

from fleet_tui.text.language import Message, tr, verbatim
from fleet_tui.ui.documentation import headings, pages, subject
from fleet_tui.ui.screens.overlay import Overlay
from fleet_tui.ui.view.help.layout import help_lines
from fleet_tui.ui.view.help.pages import Pages, tabs
from fleet_tui.ui.view.help.section import HelpRow, HelpSection, search
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.field import Field, Keys, row_keys
from fleet_tui.ui.widgets.line_view import LineView
from fleet_tui.ui.widgets.messages import ButtonPressed
from fleet_tui.ui.widgets.text_view import TextView

FRAME = 4
"""Lines of the box besides its text: the border, the search, the names of the pages."""
ELSEWHERE = Message("Try a shorter or another word. The whole manual: fleet-tui docs, in a shell.")


@cache
def _documentation() -> HelpSection:
    """Return the pages of the documentation, found by their subjects and headings."""
    texts = {name: path.read_text(encoding="utf-8") for name, path in pages().items()}
    rows = [
        HelpRow(
            ((Message("fleet-tui docs {name}", name=name), StyleRole.KEY),),
            verbatim(subject(text)),
            headings(text),
        )
        for name, text in texts.items()
        if name != "index"
    ]
    return HelpSection(Message("Documentation, in a shell"), tuple(rows))


class Help(Overlay):
    """One page at a time, first the tasks; Tab goes on."""

    def __init__(self) -> None:
        super().__init__(id="help")
        self._pages: Pages = {}
        self._page = ""
        self._tabs = LineView(id="help-pages")
        self._text = TextView(id="help-text", moved=self._moved)
        self.views = (self._tabs, self._text)

    def compose(self) -> ComposeResult:
        """Compose a search field and the names of the pages above the text."""
        keys: Keys = {
            **row_keys(self._text),
            "escape": self.action_close,
            "tab": partial(self._step, 1),
            "shift+tab": partial(self._step, -1),
        }
        self.border_title = Content(tr("Help"))
        yield Field(
            keys,
            id="search",
            placeholder=tr("type to search all pages; Tab: next page; PgDn: more; Esc: close"),
        )
        yield self._tabs
        yield self._text

    def show(self, pages: Pages) -> None:
        """Open on the first page."""
        self._pages = pages
        self.open(self.query_one("#search", Input))
        self._turn_to(next(iter(pages)))

    def _turn_to(self, page: str) -> None:
        """Show a page, and end the search."""
        field = self.query_one("#search", Input)
        # Without its Changed message: that would arrive after the next typed text.
        with field.prevent(Input.Changed):
            field.value = ""
        self._page = page
        self._list()
        self._fit()

    def _fit(self) -> None:
        """Take the lines of the page, as far as there are."""
        if width := self._text.size.width:
            self.styles.max_height = len(help_lines(self._pages[self._page], width)) + FRAME

    def _step(self, step: int) -> None:
        names = list(self._pages)
        self._turn_to(names[(names.index(self._page) + step) % len(names)])

    @on(Input.Changed, "#search")
    def _searched(self, event: Input.Changed) -> None:
        event.stop()
        self._list()

    @on(ButtonPressed)
    def _tab_clicked(self, event: ButtonPressed) -> None:
        event.stop()
        self._turn_to(event.name)

    def _list(self) -> None:
        """Show the page, or the matches in all pages."""
        wanted = self.query_one("#search", Input).value.strip()
        sections = list(self._pages[self._page])
        if wanted:
            every = {id(one): one for sections in self._pages.values() for one in sections}
            sections = search([*every.values(), _documentation()], wanted)
        if not sections:
            sections = [
                HelpSection(Message("nothing matches {text}", text=f"{wanted!r}"), (HelpRow((), ELSEWHERE),))
            ]
        runs, buttons = tabs(self._pages, "" if wanted else self._page)
        self._tabs.show(runs, buttons=buttons)
        self._text.show(partial(help_lines, sections))

    def _moved(self, position: str) -> None:
        self.border_subtitle = Content(position)

    def on_resize(self) -> None:
        """Fill it at its new size."""
        if self._pages:
            self._list()
            self._fit()
