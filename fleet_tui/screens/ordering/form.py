"""The order form: robot, from, to. Typed text filters the labels, Enter goes on, the last Enter sends; `>`
after a label adds a leg: A > B > C. Its way and length: `rules/routes/order_draft.py`."""

from collections.abc import Callable, Sequence

from textual import events, on
from textual.app import ComposeResult
from textual.widgets import Button, Input, Static

from fleet_tui.controllers.ordering.past_orders import PastOrders
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.anyone import ANYONE
from fleet_tui.rules.language.favourites import Favourite
from fleet_tui.rules.language.lookup import Place, destination_only, may_skip_start
from fleet_tui.rules.routes.order_draft import Draft
from fleet_tui.screens.ordering.choice_list import ChoiceList
from fleet_tui.screens.ordering.choices import (
    Choice,
    hindrance,
    is_in_label,
    missing,
    no_match,
    title,
    without_places,
)
from fleet_tui.screens.ordering.fields import OrderFields
from fleet_tui.screens.ordering.legs import SIGN, Legs
from fleet_tui.screens.ordering.proposal import Proposal
from fleet_tui.screens.ordering.sending import Give, GiveAnyone, OrderSending
from fleet_tui.screens.overlay import MouseButton, ReturningOverlay
from fleet_tui.text.language import tr

NEXT, SEND = "Enter  next", "Enter  send"
"""Labels of the button for Enter: before the last field, and in it."""


class OrderForm(ReturningOverlay):
    """`start` opens it for a robot. A complete request goes to `give`, the places of one without a robot to
    `give_anyone`; `past` are the orders to give again."""

    def __init__(
        self, state: Callable[[], FleetState], give: Give, give_anyone: GiveAnyone, past: PastOrders
    ) -> None:
        super().__init__(id="order-form")
        self._state, self._past = state, past
        self._picked: Place | None = None
        self._way: Sequence[Place] = ()
        self._said_of: list[str] = []
        self.route = Static(id="route", markup=False)
        self._send = MouseButton(tr(NEXT), id="send", compact=True)
        self._fields = OrderFields(
            {
                "enter": self._enter,
                "greater_than_sign": self._add_leg,
                "escape": self.action_close,
                "tab": lambda: self._fields.step(1),
                "shift+tab": lambda: self._fields.step(-1),
                "up": lambda: self._choices.step(-1),
                "down": lambda: self._choices.step(1),
            }
        )
        self._choices = ChoiceList(state, self._fields, past.newest_first)
        self._proposal = Proposal(state)
        self._sending = OrderSending(state, self._fields, give, give_anyone)

    def compose(self) -> ComposeResult:
        """Compose three fields, the matches of the current one, and a note on missing input."""
        yield from (self._fields, self._choices, self._proposal, self.route)
        yield from (Static(id="missing", markup=False), self._send)

    def draft(self) -> Draft | None:
        """Return the order as far as it is typed, None while the form is closed."""
        return self._proposal.on(self._choices.draft(self._robot())) if self.is_open else None

    def _robot(self) -> Robot | None:
        return self._state().robots.get(self._fields["robot"].value.strip())

    def start(self, robot: str, picked: Place | None = None, way: Sequence[Place] = ()) -> None:
        """Open for a robot. A vertex `picked` on the map is the start, or the end if none is needed; `way`
        are both, as proposed."""
        self._picked, self._way = picked, way
        self._fields.clear(robot)
        self._say("")
        self._arrange()
        self.open(self._fields.first_empty)
        self._list()
        self._past.read(lambda: self._choices.is_untouched and self._list())

    def _arrange(self) -> None:
        """Hide the start if there is cargo on board without an order."""
        has_start = (robot := self._robot()) is None or not destination_only(robot)
        self._fields.show_start(has_start)
        if self._picked is not None:
            field = "from" if has_start and not may_skip_start(robot) else "to"
            self._fields.take(field, self._picked)
        if self._way and has_start and not may_skip_start(robot):
            self._fields.take("from", self._way[0])
        if self._way:
            self._fields.take("to", self._way[-1])
        self._picked, self._way = None, ()
        self.border_title = title(robot, has_start)

    def _say(self, text: str, field: str = "") -> None:
        """Show an error, and focus its field."""
        self._said_of = self._fields.values
        self.query_one("#missing", Static).update(tr(text))
        if field:
            self.screen.set_focus(self._fields[field])

    @on(events.DescendantFocus)
    def _list(self) -> None:
        """List the matches of the field with the cursor, the first one marked."""
        if self.is_open:
            robot = self._robot()
            self._send.label = tr(SEND if self._fields.current == "to" else NEXT)
            self._choices.refill(robot)
            self.border_subtitle = self._choices.scope
            unknown = self._choices.unknown(robot)
            self._send.disabled = bool(unknown)
            if notice := hindrance(self._state(), robot) or unknown:
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

    @on(ChoiceList.OptionSelected, "#matches")
    def click_match(self, event: ChoiceList.OptionSelected) -> None:
        """Take a match by mouse."""
        event.stop()
        if self.is_open and (choice := self._choices.at(event.option_index)) is not None:
            self._take(self._fields.current, choice)

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

    def _choice(self) -> Choice | None:
        """Return the choice for Enter, None after showing an error if no choice fits."""
        robot, field, typed = self._robot(), self._fields.current, self._fields.typed
        if (choice := self._choices.choice(robot)) is not None:
            return choice
        if field == "robot" and not typed:
            return ANYONE
        if field == "from" and not typed and may_skip_start(robot):
            self._fields.step(1)
        else:
            problem = no_match(robot, field, typed) if typed else missing(field)
            self._say(without_places(robot) or problem)
        return None

    def _take(self, field: str, choice: Choice) -> None:
        """Fill the field and go on to the next one; after the last one send."""
        if isinstance(choice, Favourite):
            self._fields.take_both(choice)
            return
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
        problem, field = self._sending.finish(self._robot(), self.action_close)
        if problem:
            self._arrange()
            self._say(problem, field)
