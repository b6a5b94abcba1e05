"""The order form: robot, from, to. Typing filters the labels, Enter goes on, the last Enter sends; `>`
after a label adds a leg: A > B > C."""

from collections.abc import Callable
from functools import partial

from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.widget import Widget
from textual.widgets import Button, Input, Static

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.lookup import Place, destination_only, may_skip_start
from fleet_tui.screens.choices import Choices, choices, is_in_label, line, missing, order, wanted_now
from fleet_tui.screens.legs import SIGN, LegField, Legs
from fleet_tui.screens.overlay import MouseButton, Overlay
from fleet_tui.text.sanitize import sanitize
from fleet_tui.widgets.field import Keys
from fleet_tui.widgets.matches import Matches

FIELDS = ("robot", "from", "to")


class OrderForm(Overlay):
    """`start` opens it for a robot. What is complete goes to `give`, which returns what is wrong with
    it, and calls back when it was sent."""

    def __init__(
        self, state: Callable[[], FleetState], give: Callable[[Request, Callable[[], None]], str]
    ) -> None:
        super().__init__(id="order-form")
        self._state = state
        self._give = give
        self._found: Choices = []
        self._chosen: dict[str, Place] = {}
        self._picked: Place | None = None
        self._whose, self._said_of = "", list[str]()
        self._matches = Matches(id="matches")

    def compose(self) -> ComposeResult:
        """Three fields, the matches of the one that is being filled, and what is missing."""
        keys: Keys = {
            "enter": self._enter,
            "greater_than_sign": self._add_leg,
            "escape": self.action_close,
            "tab": partial(self.action_step, 1),
            "shift+tab": partial(self.action_step, -1),
            "up": partial(self._matches.step, -1),
            "down": partial(self._matches.step, 1),
        }
        for field in FIELDS:
            with Horizontal(classes="field"):
                yield Static(field.capitalize(), classes="name")
                yield LegField(keys, id=field)
        yield self._matches
        yield Static(id="missing", markup=False)
        yield MouseButton("Enter  send", id="send", compact=True)

    def _input(self, field: str) -> LegField:
        return self.query_one(f"#{field}", LegField)

    def _robot(self) -> Robot | None:
        return self._state().robots.get(self._input("robot").value.strip())

    def start(self, robot: str, picked: Place | None = None) -> None:
        """Open with the robot chosen and the cursor in the first field to fill.

        A vertex `picked` on the map is where the order starts; where it ends if it needs no start.
        """
        self._chosen, self._picked, self._whose = {}, picked, robot
        for field in FIELDS:
            self._input(field).put(robot if field == "robot" else "", Legs())
        self._say("")
        self._arrange()
        to_fill = "from" if self._input("from").display and not self._chosen else "to"
        self.open(self._input(to_fill))
        self._list()

    def _forget_other_robots(self) -> None:
        """Ids are those of one robot's graph: for another robot everything is chosen anew."""
        if (robot := self._robot()) is not None and robot.name != self._whose:
            self._whose = robot.name
            self._chosen.clear()
            if self._input("to").legs.places:
                self._input("to").put("", Legs())

    def _arrange(self) -> None:
        """With cargo on board and no orders there is only a destination."""
        has_start = (robot := self._robot()) is None or not destination_only(robot)
        box = self._input("from")
        box.display = has_start
        if isinstance(box.parent, Widget):
            box.parent.display = has_start
        if self._picked is not None:
            place, field = self._picked, "from" if has_start and not may_skip_start(robot) else "to"
            self._chosen[field], self._picked = place, None
            self._input(field).put(sanitize(place.name))
        loaded = robot is not None and robot.has_cargo
        self.border_title = "Come here: cargo is on board" if loaded and not has_start else "Order"

    def _say(self, text: str, field: str = "") -> None:
        """Say what is wrong, and go to the field where it is."""
        self._said_of = [box.value for box in self.query(LegField)]
        self.query_one("#missing", Static).update(text)
        if field:
            self.screen.set_focus(self._input(field))

    def _field(self) -> str:
        """The field that is being filled."""
        focused = self.screen.focused
        return focused.id if isinstance(focused, Input) and focused.id in FIELDS else "to"

    def _find(self) -> Choices:
        """Return what the field with the cursor can mean."""
        field = self._field()
        typed = self._input(field).typed
        return choices(self._state(), self._robot(), field, typed, self._chosen.get(field))

    def _list(self) -> None:
        """The matches of what was typed, the first one marked."""
        self._found = self._find()
        self._matches.show(map(line, self._found), mark=bool(self._input(self._field()).typed.strip()))

    @on(Input.Changed)
    def filter(self, event: Input.Changed) -> None:
        """Filter the matches by the typed text."""
        event.stop()
        field = event.input.id or ""
        # The message may be about letters that were typed before the choice was made.
        if field in self._chosen and sanitize(self._chosen[field].name) != self._input(field).typed:
            del self._chosen[field]
        self._forget_other_robots()
        if field == "robot":
            self._arrange()
        if [box.value for box in self.query(LegField)] != self._said_of:
            self._say("")
        self._list()

    def on_descendant_focus(self) -> None:
        """The matches are those of the field with the cursor."""
        if self.is_open:
            self._list()

    def action_step(self, step: int) -> None:
        """Another field, around the ends."""
        fields = [field for field in FIELDS if self._input(field).display]
        at = fields.index(self._field())
        self.screen.set_focus(self._input(fields[(at + step) % len(fields)]))

    @on(Matches.OptionSelected, "#matches")
    def click_match(self, event: Matches.OptionSelected) -> None:
        """A match by mouse."""
        event.stop()
        if self.is_open and event.option_index < len(self._found):
            self._take(self._field(), self._found[event.option_index])

    @on(Button.Pressed, "#send")
    def _enter(self) -> None:
        """Take the marked match and go on; in the last field send."""
        if (choice := self._choice()) is not None:
            self._take(self._field(), choice)

    def _add_leg(self) -> None:
        """Take the marked match as one place of several, unless a label goes on with the sign."""
        field = self._field()
        box = self._input(field)
        if field == "robot" or is_in_label(self._robot(), box.typed + SIGN):
            box.insert_text_at_cursor(SIGN)
        elif field == "from":
            self._enter()
        elif isinstance(choice := self._choice(), Place):
            box.put("", Legs((*box.legs.places, choice)))
            self._list()

    def _choice(self) -> Place | str | None:
        """Return what Enter takes, None after saying why there is nothing."""
        # What was typed last may not have been listed yet: look again before choosing.
        found, field = self._find(), self._field()
        marked = self._matches.highlighted if found == self._found else None
        self._found = found
        typed = self._input(field).typed.strip()
        if found and (typed or marked is not None):
            return found[marked or 0]
        if field == "from" and not typed and may_skip_start(self._robot()):
            self.action_step(1)
            return None
        self._say(f"{field.capitalize()}: nothing is called {typed!r}" if typed else missing(field))
        return None

    def _take(self, field: str, choice: Place | str) -> None:
        """Fill the field and go on to the next one; after the last one send."""
        if isinstance(choice, str):
            self._input(field).put(choice)
            self._arrange()
        else:
            self._input(field).put(sanitize(choice.name))
            self._chosen[field] = choice
        if field == "to":
            self._finish()
        else:
            self.action_step(1)

    def _finish(self) -> None:
        """Send what is complete; name what is missing."""
        robot = self._robot()
        if robot is None:
            self._say(f"Robot: nothing is called {self._input('robot').value.strip()!r}", "robot")
            return
        self._forget_other_robots()
        only_to = destination_only(robot)
        if only_to == self._input("from").display:
            self._arrange()
            self._say(wanted_now(robot, only_to), "to" if only_to else "from")
            return
        only_to = only_to or (may_skip_start(robot) and not self._input("from").value.strip())
        for field in ("to",) if only_to else ("from", "to"):
            if field not in self._chosen:
                self._say(missing(field, self._input(field).typed), field)
                return
        first = [] if only_to else [self._chosen["from"]]
        visited = [*first, *self._input("to").legs.places, self._chosen["to"]]
        if problem := self._give(order(robot, visited, only_to), self.action_close):
            self._say(problem, "to")
