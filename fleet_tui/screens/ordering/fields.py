"""The three fields of the order form, one below the other."""

from collections.abc import Sequence

from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.widget import Widget
from textual.widgets import Static

from fleet_tui.rules.language.favourites import Favourite
from fleet_tui.rules.language.lookup import Place
from fleet_tui.screens.ordering.legs import LegField, Legs
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.widgets.field import Keys

NAMES = ("robot", "from", "to")


class OrderFields(Vertical):
    """Robot, from, to; From is hidden if an order needs no start. `chosen`: the places for the texts of the
    fields."""

    def __init__(self, keys: Keys) -> None:
        super().__init__(id="order-fields")
        self._boxes = {name: LegField(keys, id=name) for name in NAMES}
        self.chosen: dict[str, Place] = {}
        self._robot = ""

    def __getitem__(self, name: str) -> LegField:
        return self._boxes[name]

    def compose(self) -> ComposeResult:
        """Compose each field after its name."""
        for name, box in self._boxes.items():
            with Horizontal(classes="field"):
                yield Static(tr(name.capitalize()), classes="name")
                yield box

    @property
    def values(self) -> list[str]:
        """Return the contents of the fields."""
        return [box.value for box in self._boxes.values()]

    @property
    def current(self) -> str:
        """Return the name of the field with the cursor."""
        focused = self.screen.focused
        return focused.id if isinstance(focused, LegField) and focused.id in NAMES else "to"

    @property
    def typed(self) -> str:
        """Return the text typed in the current field, after its legs."""
        return self._boxes[self.current].typed.strip()

    def missing(self, names: Sequence[str]) -> str:
        """Return the first of these fields without a place, empty if all have one."""
        return next((name for name in names if name not in self.chosen), "")

    @property
    def first_empty(self) -> LegField:
        """Return the first field to fill: the robot is chosen."""
        return self._boxes["from" if self._boxes["from"].display and not self.chosen else "to"]

    def clear(self, robot: str) -> None:
        """Clear all but the robot."""
        self.chosen, self._robot = {}, robot
        for name, box in self._boxes.items():
            box.put(robot if name == "robot" else "", Legs())

    def choose_for(self, robot: str) -> None:
        """Drop the places of another robot: ids are those of one robot's graph."""
        if robot != self._robot:
            self._robot = robot
            self.chosen.clear()
            if self._boxes["to"].legs.places:
                self._boxes["to"].put("", Legs())

    def take(self, name: str, place: Place) -> None:
        """Fill a field with a place."""
        self._boxes[name].put(sanitize(place.name))
        self.chosen[name] = place

    def take_both(self, favourite: Favourite) -> None:
        """Fill From and To with an order to give again, the cursor in To: the next Enter sends it."""
        self._boxes["to"].put("", Legs())
        self.take("from", favourite.start)
        self.take("to", favourite.end)
        self.screen.set_focus(self._boxes["to"])

    def visited(self, only_to: bool) -> list[Place]:
        """Return the places of a complete order; `only_to`: without a start."""
        first = [] if only_to else [self.chosen["from"]]
        return [*first, *self._boxes["to"].legs.places, self.chosen["to"]]

    def drop_changed(self, name: str) -> None:
        """Drop the place of a field whose text has changed."""
        # A Changed message may be about letters typed before the choice was made.
        if name in self.chosen and sanitize(self.chosen[name].name) != self._boxes[name].typed:
            del self.chosen[name]

    def show_start(self, is_shown: bool) -> None:
        """Show or hide From."""
        box = self._boxes["from"]
        box.display = is_shown
        if isinstance(box.parent, Widget):
            box.parent.display = is_shown

    def step(self, step: int) -> None:
        """Go to the next (1) or previous (-1) field, around the ends."""
        shown = [name for name, box in self._boxes.items() if box.display]
        self.screen.set_focus(self._boxes[shown[(shown.index(self.current) + step) % len(shown)]])
