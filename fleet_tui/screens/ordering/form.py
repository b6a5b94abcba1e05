"""The order form: robot, from, to. Typed text filters the labels, Enter goes on, the last Enter sends; `>`
after a label adds a leg: A > B > C. Its way and length: `rules/routes/order_draft.py`."""

from collections.abc import Callable
from functools import partial

from textual import events, on
from textual.app import ComposeResult
from textual.widgets import Button, Input, Static

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.lookup import Place, destination_only, may_skip_start
from fleet_tui.rules.routes.order_draft import Draft
from fleet_tui.screens.ordering.choices import (
    Choices,
    choices,
    hindrance,
    is_in_label,
    line,
    missing,
    order,
    title,
    wanted_now,
    without_places,
)
from fleet_tui.screens.ordering.drafts import draft_of
from fleet_tui.screens.ordering.fields import OrderFields
from fleet_tui.screens.ordering.legs import SIGN, Legs
from fleet_tui.screens.overlay import MouseButton, Overlay
from fleet_tui.widgets.matches import Matches

NEXT, SEND = "Enter  next", "Enter  send"
"""Labels of the button for Enter: before the last field, and in it."""


class OrderForm(Overlay):
    """`start` opens it for a robot. A complete request goes to `give`, which returns its problems, and calls
    back when it was sent."""

    def __init__(
        self, state: Callable[[], FleetState], give: Callable[[Request, Callable[[], None]], str]
    ) -> None:
        super().__init__(id="order-form")
        self._state = state
        self._give = give
        self._found: Choices = []
        self._picked: Place | None = None
        self._said_of: list[str] = []
        self.route = Static(id="route", markup=False)
        self._matches, self._send = Matches(id="matches"), MouseButton(NEXT, id="send", compact=True)
        self._fields = OrderFields(
            {
                "enter": self._enter,
                "greater_than_sign": self._add_leg,
                "escape": self.action_close,
                "tab": lambda: self._fields.step(1),
                "shift+tab": lambda: self._fields.step(-1),
                "up": partial(self._matches.step, -1),
                "down": partial(self._matches.step, 1),
            }
        )

    def compose(self) -> ComposeResult:
        """Compose three fields, the matches of the current one, and a note on missing input."""
        yield from (self._fields, self._matches, self.route, Static(id="missing", markup=False), self._send)

    def draft(self) -> Draft | None:
        """Return the order as far as it is typed, None while the form is closed."""
        robot = self._robot() if self.is_open else None
        return draft_of(robot, self._fields, self._found, self._matches.highlighted) if robot else None

    def _robot(self) -> Robot | None:
        return self._state().robots.get(self._fields["robot"].value.strip())

    def start(self, robot: str, picked: Place | None = None) -> None:
        """Open for a robot. A vertex `picked` on the map is the start, or the end if none is needed."""
        self._picked = picked
        self._fields.clear(robot)
        self._say("")
        self._arrange()
        self.open(self._fields.first_empty)
        self._list()

    def _arrange(self) -> None:
        """Hide the start if there is cargo on board without an order."""
        has_start = (robot := self._robot()) is None or not destination_only(robot)
        self._fields.show_start(has_start)
        if self._picked is not None:
            field = "from" if has_start and not may_skip_start(robot) else "to"
            self._fields.take(field, self._picked)
        self._picked = None
        self.border_title = title(robot, has_start)

    def _say(self, text: str, field: str = "") -> None:
        """Show an error, and focus its field."""
        self._said_of = self._fields.values
        self.query_one("#missing", Static).update(text)
        if field:
            self.screen.set_focus(self._fields[field])

    @on(events.DescendantFocus)
    def _list(self) -> None:
        """List the matches of the field with the cursor, the first one marked."""
        if self.is_open:
            field, robot = self._fields.current, self._robot()
            self._send.label = SEND if field == "to" else NEXT
            typed = self._fields[field].typed
            self._found = choices(self._state(), robot, field, typed, self._fields.chosen.get(field))
            self._matches.show(map(line, self._found), mark=bool(typed.strip()))
            if notice := hindrance(self._state(), robot):
                self._say(notice)

    @on(Input.Changed)
    def filter(self, event: Input.Changed) -> None:
        """Filter the matches by the typed text."""
        event.stop()
        field = event.input.id or ""
        self._fields.drop_changed(field)
        if robot := self._robot():
            self._fields.choose_for(robot.name)
        if field == "robot":
            self._arrange()
        if self._fields.values != self._said_of:
            self._say("")
        self._list()

    @on(Matches.OptionSelected, "#matches")
    def click_match(self, event: Matches.OptionSelected) -> None:
        """Take a match by mouse."""
        event.stop()
        if self.is_open and event.option_index < len(self._found):
            self._take(self._fields.current, self._found[event.option_index])

    @on(Button.Pressed, "#send")
    def _enter(self) -> None:
        """Take the marked match and go on; in the last field send."""
        if (choice := self._choice()) is not None:
            self._take(self._fields.current, choice)

    def _add_leg(self) -> None:
        """Take the marked match as one place of several, unless the sign is part of a label."""
        field, box = self._fields.current, self._fields[self._fields.current]
        if field == "robot" or is_in_label(self._robot(), box.typed + SIGN):
            box.insert_text_at_cursor(SIGN)
        elif field == "from":
            self._enter()
        elif isinstance(choice := self._choice(), Place):
            box.put("", Legs((*box.legs.places, choice)))
            self._list()

    def _choice(self) -> Place | str | None:
        """Return the choice for Enter, None after showing an error if no choice fits."""
        # The last letters may not have been listed yet: update before choosing.
        field = self._fields.current
        typed = self._fields[field].typed
        found = choices(self._state(), self._robot(), field, typed, self._fields.chosen.get(field))
        marked = self._matches.highlighted if found == self._found else None
        self._found, typed = found, typed.strip()
        if found and (typed or marked is not None):
            return found[marked or 0]
        if field == "from" and not typed and may_skip_start(self._robot()):
            self._fields.step(1)
        else:
            problem = f"{field.capitalize()}: no match for {typed!r}" if typed else missing(field)
            self._say(without_places(self._robot()) or problem)
        return None

    def _take(self, field: str, choice: Place | str) -> None:
        """Fill the field and go on to the next one; after the last one send."""
        if isinstance(choice, str):
            self._fields[field].put(choice)
            self._arrange()
        else:
            self._fields.take(field, choice)
        if field == "to":
            self._finish()
        else:
            self._fields.step(1)

    def _finish(self) -> None:
        """Send a complete request; name missing input."""
        robot = self._robot()
        if robot is None:
            self._say(f"Robot: no match for {self._fields['robot'].value.strip()!r}", "robot")
            return
        self._fields.choose_for(robot.name)
        only_to = destination_only(robot)
        if only_to == self._fields["from"].display:
            self._arrange()
            self._say(wanted_now(robot, only_to), "to" if only_to else "from")
            return
        only_to = only_to or (may_skip_start(robot) and not self._fields["from"].value.strip())
        for field in ("to",) if only_to else ("from", "to"):
            if field not in self._fields.chosen:
                self._say(missing(field, self._fields[field].typed), field)
                return
        if problem := self._give(order(robot, self._fields.visited(only_to), only_to), self.action_close):
            self._say(problem, "to")
