"""The command palette: typed commands, every action of the keys table, "go to" for everything with a name."""

from collections.abc import Callable, Iterable
from functools import partial

from textual import on
from textual.app import ComposeResult
from textual.content import Content
from textual.widgets import Input

from fleet_tui.commands.language.ranking import rank
from fleet_tui.text.language import tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.offers import Offer
from fleet_tui.ui.controllers.typed import Typed
from fleet_tui.ui.screens.overlay import Overlay
from fleet_tui.ui.widgets.field import Field, Keys
from fleet_tui.ui.widgets.matches import Matches

SHOWN = 40


class Palette(Overlay):
    """Typed text searches, Enter runs the marked entry, Tab completes a command."""

    def __init__(self, entries: Callable[[], Iterable[Offer]], typed: Callable[[str], Typed]) -> None:
        super().__init__(id="palette")
        self._entries = entries
        self._typed_as = typed
        self._turn: list[str] = []
        self._matches = Matches[Offer](id="requests")

    def compose(self) -> ComposeResult:
        """Compose a field above the matches."""
        keys: Keys = {
            "enter": self._do,
            "escape": self.action_close,
            "tab": self._complete,
            "up": partial(self._matches.step, -1),
            "down": partial(self._matches.step, 1),
            "ctrl+p": self.action_close,
        }
        self.border_title = Content(tr("Command"))
        yield Field(keys, id="request", placeholder=tr("action, robot, place or order: robot_0 Base > Store"))
        yield self._matches

    def show(self, line: str = "") -> None:
        """Open with all entries, or with the beginning of a line."""
        self._fill(line)
        field = self.query_one(Field)
        # Further letters continue the line.
        field.select_on_focus = not line
        self.open(field)

    def _fill(self, line: str) -> None:
        """Put a line into the field, and list its matches."""
        field = self.query_one(Field)
        # Without its Changed message: that would arrive after the next typed text.
        with field.prevent(Input.Changed):
            field.value = line
        field.cursor_position = len(line)
        self._list()

    @on(Input.Changed, "#request")
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        self._list()

    def _list(self) -> None:
        """List a command first, then the matches, best first; without input everything in its usual sequence.
        Enter on an incomplete command continues typing. Last are actions that other words find."""
        line = self.query_one(Field).value
        typed, command = line.strip(), self._typed_as(line)
        entries = list(self._entries())
        offers = (Offer(translate(text), do) for text, do in command.entries)
        found = [*offers, *_matching(typed, entries)][:SHOWN]
        if command.is_command or not found:
            lines = [one for one in command.completed if one.strip() != typed]
            found += [Offer(sanitize(one), partial(self._go_on, one)) for one in lines[:SHOWN]]
        if typed and not command.is_command:
            found += [one for one in entries if rank(typed, one.also) is not None and one not in found]
        if not found and typed:
            said = translate(command.problem) or tr(
                "no match for {typed}: press ? for all keys", typed=sanitize(typed)
            )
            found = [Offer(said, partial(self._go_on, line))]
        self._matches.show(found, [offer.text for offer in found], keys=[offer.key for offer in found])

    def _complete(self) -> None:
        """Replace the last word by its next completion."""
        field = self.query_one(Field)
        if len(self._turn) > 1 and field.value == self._turn[0]:
            self._turn = [*self._turn[1:], self._turn[0]]
        else:
            self._turn = list(self._typed_as(field.value).completed)
        if self._turn:
            self._fill(self._turn[0])

    def _go_on(self, line: str) -> None:
        self.open(self.query_one(Field))
        self._fill(line)

    def _do(self) -> None:
        """Run the marked entry as it is now. If it is gone, mark another one and wait for the next Enter."""
        marked = self._matches.marked
        self._list()
        for offer in self._matches.items:
            if marked is not None and offer.text == marked.text:
                self.action_close()
                offer.do()
                return

    @on(Matches.OptionSelected, "#requests")
    def _clicked(self, event: Matches.OptionSelected) -> None:
        event.stop()  # the click has marked it

    @on(Matches.DoubleClicked)
    def _double_clicked(self, event: Matches.DoubleClicked) -> None:
        event.stop()
        if self.is_open:
            self._do()


def _matching(typed: str, offers: list[Offer]) -> list[Offer]:
    """Return the offers with the typed words, the best first."""
    if not typed:
        return offers
    ranked = [
        (place, n) for n, one in enumerate(offers) if (place := rank(typed, one.text, one.name)) is not None
    ]
    return [offers[n] for _, n in sorted(ranked)]
