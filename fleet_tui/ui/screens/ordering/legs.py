"""A chain of orders while it is typed: `A > B > `, and the text after it."""

from dataclasses import dataclass

from textual.widgets import Input

from fleet_tui.commands.language.lookup import Place
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.widgets.field import Field

SIGN = ">"


@dataclass(frozen=True, slots=True)
class Legs:
    """The places already chosen at the start of a field's text."""

    places: tuple[Place, ...] = ()

    @property
    def text(self) -> str:
        """Return the text of these places."""
        return "".join(f"{sanitize(place.name)} {SIGN} " for place in self.places)

    def kept(self, typed: str) -> "Legs":
        """Return those still present in the typed text."""
        legs = self
        while not typed.startswith(legs.text):
            legs = Legs(legs.places[:-1])
        return legs

    def rest(self, typed: str) -> str:
        """Return the text after them, without the sign left by a removed leg."""
        return typed[len(self.text) :].removesuffix(f" {SIGN}")


class LegField(Field):
    """A field that may hold several places in sequence."""

    legs = Legs()

    @property
    def typed(self) -> str:
        """Return the text after the legs that are still present."""
        self.legs = self.legs.kept(self.value)
        return self.legs.rest(self.value)

    def put(self, text: str, legs: Legs | None = None) -> None:
        """Put a text after the legs."""
        self.legs = self.legs if legs is None else legs
        # Without its Changed message: that would arrive after the next typed text.
        with self.prevent(Input.Changed):
            self.value = self.legs.text + text
        self.cursor_position = len(self.value)
