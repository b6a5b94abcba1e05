"""The three fields of the order form, one below the other."""

from collections.abc import Callable, Sequence
from itertools import takewhile

from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.widgets import Static

from fleet_tui.commands.language.favourites import Favourite
from fleet_tui.commands.language.lookup import HERE, Place
from fleet_tui.text.language import N_, tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.screens.ordering.legs import LegField, Legs
from fleet_tui.ui.widgets.field import Keys

NAMES = {"robot": N_("Robot"), "from": N_("From"), "to": N_("To")}


class OrderFields(Vertical):
    """Robot, from, to, in every state of the robot. `chosen`: the places for the texts of the fields."""

    def __init__(self, keys: Keys) -> None:
        super().__init__(id="order-fields")
        self._boxes = {name: LegField(keys, id=name) for name in NAMES}
        self.chosen: dict[str, Place] = {}
        self._gone: dict[str, tuple[str, list[str]]] = {}
        """What was chosen or marked and has changed: by field its text then, and the names of places."""
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
        return self._boxes[
            "from" if self.chosen.get("from", HERE) == HERE and "to" not in self.chosen else "to"
        ]

    def clear(self, robot: str) -> None:
        """Clear all but the robot."""
        self.chosen = {}
        self._gone = {}
        self._robot = robot
        for name, box in self._boxes.items():
            box.put(robot if name == "robot" else "", Legs())

    def choose_for(self, robot: str) -> None:
        """Drop the places of another robot: ids are those of one robot's graph."""
        self._gone.pop("robot", None)
        if robot != self._robot:
            self._robot = robot
            self.chosen.clear()
            self._gone.clear()
            if self._boxes["from"].value == HERE.name:
                self._boxes["from"].put("")
            if self._boxes["to"].legs.places:
                self._boxes["to"].put("", Legs())

    def take(self, name: str, place: Place) -> None:
        """Fill a field with a place."""
        self._boxes[name].put(sanitize(place.name))
        self.chosen[name] = place
        self._gone.pop(name, None)

    def take_both(self, favourite: Favourite) -> None:
        """Fill From and To with an order to give again, the cursor in To: the next Enter sends it."""
        self._boxes["to"].put("", Legs())
        self.take("from", favourite.start)
        self.take("to", favourite.end)
        self.screen.set_focus(self._boxes["to"])

    @property
    def visited(self) -> list[Place]:
        """Return the places of a complete order."""
        return [self.chosen["from"], *self._boxes["to"].legs.places, self.chosen["to"]]

    def start_here(self, may: bool) -> None:
        """Fill an empty From with HERE where an order may begin there, and clear it elsewhere."""
        box = self._boxes["from"]
        if may and not box.value:
            self.take("from", HERE)
        elif not may and self.chosen.get("from") == HERE:
            del self.chosen["from"]
            box.put("")

    @property
    def gone(self) -> list[str]:
        """Return the names of places that must be chosen again, as they have changed."""
        return list(dict.fromkeys(name for _, names in self._gone.values() for name in names))

    def note_gone(self, field: str, *names: str) -> None:
        """Ask for a field again, until it is chosen or something else typed in it."""
        self._gone[field] = self._boxes[field].typed, [*self._gone.get(field, ("", []))[1], *names]

    def drop_gone(self, is_still: Callable[[Place], bool]) -> bool:
        """Drop the places that were chosen and are no longer what they were. Tells whether there are any."""
        gone = [name for name, place in self.chosen.items() if place != HERE and not is_still(place)]
        for name in gone:
            self.note_gone(name, self.chosen.pop(name).name)
        box = self._boxes["to"]
        legs = box.legs.places
        kept = tuple(takewhile(is_still, legs))
        if kept != legs:
            box.put(box.typed, Legs(kept))
            self.note_gone("to", *(leg.name for leg in legs[len(kept) :]))
        return bool(gone) or kept != legs

    def drop_changed(self, name: str) -> None:
        """Drop the place of a field whose text has changed."""
        # A Changed message may be about letters typed before the choice was made.
        typed = self._boxes[name].typed
        if name in self.chosen and sanitize(self.chosen[name].name) != typed:
            del self.chosen[name]
        if name in self._gone and self._gone[name][0] != typed:
            del self._gone[name]

    def step(self, step: int) -> None:
        """Go to the next (1) or previous (-1) field, around the ends."""
        names = list(NAMES)
        self.screen.set_focus(self._boxes[names[(names.index(self.current) + step) % len(names)]])
