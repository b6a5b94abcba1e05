"""The order form: robot, from, to. Typing filters the labels, Enter goes on, the last Enter sends."""

from collections.abc import Callable
from functools import partial

from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.widget import Widget
from textual.widgets import Button, Input, Static

from fleet_tui.model.commands import Command, PlaceOrder, PlaceOrderWithCargo
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.lookup import Place, destination_only, matches
from fleet_tui.model.robot import Robot
from fleet_tui.screens.overlay import MouseButton, Overlay
from fleet_tui.view.text import visible
from fleet_tui.widgets.field import Field, Keys
from fleet_tui.widgets.matches import Matches

FIELDS = ("robot", "from", "to")
SHOWN = 8


class OrderForm(Overlay):
    """`start` opens it for a robot; a complete order goes to `send`."""

    def __init__(self, state: Callable[[], FleetState], send: Callable[[Command], None]) -> None:
        super().__init__(id="order-form")
        self._state = state
        self._send = send
        self._found: list[Place] | list[str] = []
        self._chosen: dict[str, Place] = {}
        self._picked: Place | None = None
        self._whose = ""
        self._matches = Matches(id="matches")

    def compose(self) -> ComposeResult:
        """Three fields, the matches of the one that is being filled, and what is missing."""
        keys: Keys = {
            "enter": self._enter,
            "escape": self.action_close,
            "tab": partial(self.action_step, 1),
            "shift+tab": partial(self.action_step, -1),
            "up": partial(self._matches.step, -1),
            "down": partial(self._matches.step, 1),
        }
        for field in FIELDS:
            with Horizontal(classes="field"):
                yield Static(field.capitalize(), classes="name")
                yield Field(keys, id=field)
        yield self._matches
        yield Static(id="missing", markup=False)
        yield MouseButton("Enter  send", id="send", compact=True)

    def _input(self, field: str) -> Input:
        return self.query_one(f"#{field}", Input)

    def _robot(self) -> Robot | None:
        return self._state().robots.get(self._input("robot").value.strip())

    def start(self, robot: str, picked: Place | None = None) -> None:
        """Open with the robot chosen and the cursor in the first field to fill.

        A vertex `picked` on the map is where the order starts, or where the cargo on board goes.
        """
        self._chosen, self._picked, self._whose = {}, picked, robot
        for field in FIELDS:
            self._set(field, robot if field == "robot" else "")
        self._say("")
        self._arrange()
        to_fill = "from" if self._input("from").display and "from" not in self._chosen else "to"
        self.open(self._input(to_fill))
        self._list()

    def _set(self, field: str, text: str) -> None:
        # Without its Changed message: that would arrive after what is typed next.
        with self._input(field).prevent(Input.Changed):
            self._input(field).value = text

    def _forget_other_robots(self) -> None:
        """Ids are those of one robot's graph: for another robot everything is chosen anew."""
        if (robot := self._robot()) is not None and robot.name != self._whose:
            self._whose = robot.name
            self._chosen.clear()

    def _arrange(self) -> None:
        """With cargo on board and no orders there is only a destination."""
        robot = self._robot()
        has_start = robot is None or not destination_only(robot)
        box = self._input("from")
        box.display = has_start
        if isinstance(box.parent, Widget):
            box.parent.display = has_start
        if self._picked is not None:
            place, field = self._picked, "from" if has_start else "to"
            self._picked = None
            self._chosen[field] = place
            self._set(field, visible(place.name))
        self.border_title = "Order" if has_start else "Come here: cargo is on board"

    def _say(self, text: str, field: str = "") -> None:
        """Say what is wrong, and go to the field where it is."""
        self.query_one("#missing", Static).update(text)
        if field:
            self.screen.set_focus(self._input(field))

    def _field(self) -> str:
        """The field that is being filled."""
        focused = self.screen.focused
        return focused.id if isinstance(focused, Input) and focused.id in FIELDS else "to"

    def _find(self) -> list[Place] | list[str]:
        """What the field with the cursor can mean."""
        field, robot = self._field(), self._robot()
        typed = self._input(field).value
        if field == "robot":
            wanted = typed.strip().casefold()
            return [name for name in self._state().robots if wanted in name.casefold()][:SHOWN]
        found = matches(robot, typed)[:SHOWN] if robot else []
        chosen = self._chosen.get(field)
        if chosen is None or visible(chosen.name) != typed:
            return found
        # Floors may have the same label: what was chosen stays what Enter takes.
        return [chosen, *(place for place in found if place != chosen)]

    def _list(self) -> None:
        """The matches of what was typed, the first one marked."""
        self._found = self._find()
        self._matches.show(map(_line, self._found))

    @on(Input.Changed)
    def filter(self, event: Input.Changed) -> None:
        """What is typed names something else now."""
        event.stop()
        field, value = event.input.id or "", event.input.value
        # The message may be about letters that were typed before the choice was made.
        if field in self._chosen and visible(self._chosen[field].name) != value:
            del self._chosen[field]
        self._forget_other_robots()
        if event.input.id == "robot":
            self._arrange()
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
        # What was typed last may not have been listed yet: look again before choosing.
        found = self._find()
        marked = self._matches.marked
        self._found, marked = found, marked if found == self._found else 0
        self._accept(marked)

    def _accept(self, index: int) -> None:
        field = self._field()
        typed = self._input(field).value.strip()
        if not typed and index == 0:
            self._say(_missing(field))
        elif index >= len(self._found):
            self._say(f"{field.capitalize()}: nothing is called {typed!r}")
        else:
            self._take(field, self._found[index])

    def _take(self, field: str, choice: Place | str) -> None:
        """Fill the field and go on to the next one; after the last one send."""
        self._set(field, choice if isinstance(choice, str) else visible(choice.name))
        if isinstance(choice, str):
            self._arrange()
        else:
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
            now = "carries cargo and has no orders now: only To" if only_to else "needs a From now"
            self._say(f"{robot.name} {now}. Enter sends", "to" if only_to else "from")
            return
        for field in ("to",) if only_to else ("from", "to"):
            if field not in self._chosen:
                self._say(_missing(field, self._input(field).value), field)
                return
        start, end = self._chosen.get("from"), self._chosen["to"]
        if start is not None and start.vertex == end.vertex:
            self._say("From and To are the same place", "to")
            return
        command = (
            PlaceOrderWithCargo(robot.name, end.vertex)
            if only_to or start is None
            else PlaceOrder(robot.name, start.vertex, end.vertex)
        )
        # Closing restyles the screen; the command does not wait for that.
        self._send(command)
        self.action_close()


def _missing(field: str, typed: str = "") -> str:
    if typed.strip():
        return f"{field.capitalize()}: Enter takes the marked place of this robot"
    remedy = "its name" if field == "robot" else "a label or a vertex id"
    return f"{field.capitalize()} is missing: type {remedy}"


def _line(choice: Place | str) -> str:
    return choice if isinstance(choice, str) else f"{visible(choice.name)}  ({choice.vertex}, {choice.floor})"
