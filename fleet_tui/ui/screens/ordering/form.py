"""The order form: robot, from, to. Typed text filters the labels, Enter goes on, the last Enter sends; `>`
after a label adds a leg: A > B > C. Its way and length: `rules/routes/order_draft.py`."""

import math
from collections.abc import Callable, Sequence

from msgspec.structs import replace
from textual import events, on
from textual.app import ComposeResult
from textual.widgets import Button, Input, Static

from fleet_tui.commands.checks import robot_problems
from fleet_tui.commands.language.any_robot import ANYONE, is_anyone
from fleet_tui.commands.language.favourites import Favourite, Given
from fleet_tui.commands.language.lookup import HERE, Place, is_still, order_of, starts_here
from fleet_tui.commands.routes.dispatching import to_any
from fleet_tui.commands.routes.nearest import Nearest, nearest, why_none
from fleet_tui.commands.routes.order_draft import Draft
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.problem import Problem
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.ordering.past_orders import PastOrders
from fleet_tui.ui.screens.ordering.choices import (
    Choice,
    Choices,
    changed,
    charge_first,
    choices,
    condition,
    hindrance,
    is_in_label,
    lines,
    missing,
    no_match,
    scope,
    title,
    warnings,
    without_places,
)
from fleet_tui.ui.screens.ordering.fields import OrderFields
from fleet_tui.ui.screens.ordering.legs import SIGN, Legs
from fleet_tui.ui.screens.ordering.sending import Give, GiveAnyone, OrderSending
from fleet_tui.ui.screens.overlay import MouseButton, ReturningOverlay
from fleet_tui.ui.widgets.matches import Matches

Picture = tuple[tuple[object, ...], tuple[object, ...]]
"""Values, and the graphs and labels, each of which is replaced as a whole."""


CHOSEN = Message("the dispatcher chooses the robot")
AGAIN = 1.0
"""Seconds after which the nearest robot is looked for again: it takes a search of every graph."""
NEXT = Message("Enter  next")
SEND = Message("Enter  send")
"""Labels of the button for Enter: before the last field, and in it."""


class ChoiceList(Matches[Choice]):
    """Lists the choices of the field with the cursor, for a robot if it is known."""

    def __init__(
        self, state: Callable[[], FleetState], fields: OrderFields, given: Callable[[], Sequence[Given]]
    ) -> None:
        super().__init__(id="matches")
        self._state = state
        self._fields = fields
        self._given = given

    def list_for(self, robot: Robot | None, keep: bool = False) -> bool:
        """List the choices, the first one marked if something is typed; to `keep` the mark returns False if
        its choice is gone."""
        typed, found = self._fields.typed, self._choices(robot)
        texts = lines(self._state(), robot, typed, found, self._start)
        if keep:
            return self.renew(found, texts)
        self.show(found, texts, mark=0 if typed else None)
        return True

    @property
    def _start(self) -> Place | None:
        """Return the place that distances are from, None for that of the robot."""
        start = self._fields.chosen.get("from") if self._fields.current == "to" else None
        return start if start != HERE else None

    def scope(self, robot: Robot | None) -> str:
        """Return which places are listed before anything is typed."""
        return scope(robot, self._fields.typed, self.items)

    def unknown(self, robot: Robot | None) -> str:
        """Return that what is typed is no choice, empty if it is one."""
        typed = self._fields.typed
        return no_match(robot, self._fields.current, typed) if typed.strip() and not self.items else ""

    def _choices(self, robot: Robot | None) -> Choices:
        fields, field = self._fields, self._fields.current
        if field != "robot" and self._is_for_nobody(robot):
            return []
        return choices(
            self._state(),
            robot,
            field,
            fields[field].typed,
            fields.chosen.get(field),
            self._given,
            self._start,
        )

    def draft(self, robot: Robot | None) -> Draft:
        """Return the draft of an order, without a robot that of any, as if Enter took the marked choice."""
        if self._is_for_nobody(robot):
            return Draft("")
        name, marked, fields = robot.name if robot is not None else "", self.marked, self._fields
        if isinstance(marked, Favourite):
            return Draft(name, (marked.start, marked.end), marked=marked.start)
        place = marked if isinstance(marked, Place) else None
        chosen = {**fields.chosen, fields.current: place} if place is not None else fields.chosen
        places = (chosen.get("from"), *fields["to"].legs.places, chosen.get("to"))
        visited = tuple(one for one in places if one is not None and one != HERE)
        return Draft(name, visited, chosen.get("from") == HERE, place if place != HERE else None)

    def _is_for_nobody(self, robot: Robot | None) -> bool:
        return robot is None and not is_anyone(self._fields["robot"].value, self._state())


def picture_of(state: FleetState, robot: Robot | None) -> Picture:
    """Return that of a robot, or of all for an order that any robot may drive."""
    robots = [robot] if robot is not None else list(state.robots.values())
    maps = tuple(
        part for one in robots for known in one.maps.values() for part in (known.graph, known.labels)
    )
    values: tuple[object, ...] = ()
    if robot is not None:
        is_to_charge = charge_first(state, robot) != ()
        values = (robot.name, robot.floor, starts_here(robot), robot.kind, is_to_charge)
    return (*values, len(maps)), maps


def is_same(one: Picture, other: Picture) -> bool:
    """Tell whether two pictures have the same values and the very same maps."""
    return one[0] == other[0] and all(part is same for part, same in zip(one[1], other[1], strict=True))


class OrderForm(ReturningOverlay):
    """`start` opens it for a robot. A complete request goes to `give`, the places of one without a robot to
    `give_anyone`; `past` are the orders to give again; `objections` returns what speaks against a request.

    It works on one picture of the robot's graphs, labels and floor: when these change, `look` lists the
    choices anew and drops what was chosen and is gone, and Enter asks again.
    """

    def __init__(
        self,
        state: Callable[[], FleetState],
        give: Give,
        give_anyone: GiveAnyone,
        past: PastOrders,
        objections: Callable[[Request], list[Problem]],
    ) -> None:
        super().__init__(id="order-form")
        self._state = state
        self._past = past
        self._objections = objections
        self._picture = picture_of(state(), None)
        self._said = EMPTY
        self._said_of = list[str]()
        self._clicked = ""
        self.route = Static(id="route", markup=False)
        self._send = MouseButton(translate(NEXT), id="send", compact=True)
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
        """Compose three fields, the robot's condition, the matches of a field, and a note."""
        yield from (self._fields, Static(id="condition", markup=False))
        yield from (self._choices, self._proposal, self.route)
        yield from (Static(id="missing", markup=False), self._send)

    def draft(self) -> Draft | None:
        """Return the order as far as it is typed, None while the form is closed."""
        return self._proposal.on(self._choices.draft(self._robot())) if self.is_open else None

    def _robot(self) -> Robot | None:
        return self._state().robots.get(self._fields["robot"].value.strip())

    def start(self, robot: str, picked: Place | None = None, way: Sequence[Place] = ()) -> None:
        """Open for a robot, with nothing chosen but what is given: a vertex `picked` on the map is the start,
        or the end if none is needed; `way` are both, as proposed."""
        self._fields.clear(robot)
        self._clicked = ""
        self._said, self._picture = EMPTY, picture_of(self._state(), self._robot())
        may_be_here = (chosen := self._robot()) is not None and starts_here(chosen)
        if picked is not None:
            self._fields.take("to" if may_be_here else "from", picked)
        if way:
            self._fields.take("to", way[-1])
        if way and not may_be_here:
            self._fields.take("from", way[0])
        self._arrange()
        self.open(self._fields.first_empty)
        self._list()
        self._past.read(lambda: self.is_open and self._choices.list_for(self._robot(), keep=True))

    def look(self) -> bool:
        """Show what is true now. Returns False, having said so, if a choice is not what it was."""
        if not self.is_open:
            return True
        robot = self._robot()
        picture = picture_of(self._state(), robot)
        holds = True
        if not is_same(picture, self._picture):
            self._picture = picture
            holds = not self._fields.drop_gone(self._is_still)
            self._arrange()
            if not self._choices.list_for(robot, keep=True):
                holds = False
                field = self._fields.current
                self._fields.note_gone(field, self._fields.typed or tr(field.capitalize()))
            self.border_subtitle = self._choices.scope(robot)
            if not holds:
                self._said = EMPTY
        self._tell()
        return holds

    def _is_still(self, place: Place) -> bool:
        robot = self._robot()
        robots = [robot] if robot is not None else self._state().robots.values()
        return any(is_still(one, place) for one in robots)

    def _arrange(self) -> None:
        """Let From begin where the robot is, if it may."""
        robot = self._robot()
        self._fields.start_here(robot is not None and starts_here(robot))
        self.border_title = title(robot)

    def _say(self, text: Message, field: str = "") -> None:
        """Show an error until something else is typed, and focus its field."""
        self._said = text
        self._said_of = self._fields.values
        if field:
            self.screen.set_focus(self._fields[field])
        self._tell()

    def _tell(self) -> None:
        """Show the error, else what speaks against the order now."""
        state, robot = self._state(), self._robot()
        unknown, found = self._choices.unknown(robot), self._problems(robot)
        self._send.disabled = bool(unknown) or (self._is_last and any(problem.blocks for problem in found))
        again = changed(gone) if (gone := self._fields.gone) else ""
        text = (
            again
            or translate(self._said)
            or hindrance(state, robot)
            or unknown
            or warnings(state, robot, found)
        )
        for id_, told in (("#condition", condition(state, robot)), ("#missing", text)):
            note = self.query_one(id_, Static)
            if told != note.content:  # an update lays out the whole screen
                note.update(told)
                note.display = bool(told) or id_ == "#missing"

    @property
    def _is_last(self) -> bool:
        return self._fields.current == "to"

    def _problems(self, robot: Robot | None) -> list[Problem]:
        """Return what speaks against the order that Enter would give, or against any to this robot."""
        if robot is None:
            return []
        draft = self._choices.draft(robot)
        if len(draft.places) + draft.starts_here < 2:
            return robot_problems(self._state(), robot)
        return self._objections(order_of(robot, [*[HERE] * draft.starts_here, *draft.places]))

    @on(events.DescendantFocus)
    def _list(self) -> None:
        """List the matches of the field with the cursor, the first one marked."""
        if self.is_open:
            robot = self._robot()
            self._send.label = translate(SEND if self._is_last else NEXT)
            self._choices.list_for(robot)
            self.border_subtitle = self._choices.scope(robot)
            self._tell()

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
            self._said = EMPTY
        self._list()

    @on(ChoiceList.OptionSelected, "#matches")
    def click_match(self, event: ChoiceList.OptionSelected) -> None:
        """Choose a match by mouse; a double click or the button sends."""
        event.stop()
        choice = self._choices.at(event.option_index)
        self._clicked = ""
        if not self.is_open or choice is None or not self.look():
            return
        self._clicked = self._fields.current
        self._choose(self._clicked, choice)
        if self._is_last:
            self._list()

    @on(ChoiceList.DoubleClicked)
    def send_clicked(self, event: ChoiceList.DoubleClicked) -> None:
        """Send what the first click of two chose as the destination."""
        event.stop()
        if self.is_open and self._clicked == "to":
            self._finish()

    @on(Button.Pressed, "#send")
    def _enter(self) -> None:
        """Take the marked match and go on; in the last field send."""
        if self.look() and (choice := self._choice()) is not None:
            was_last = self._is_last
            self._choose(self._fields.current, choice)
            if was_last:
                self._finish()

    def _add_leg(self) -> None:
        """Take the marked match as one place of several, unless the sign is part of a label."""
        field, box = self._fields.current, self._fields[self._fields.current]
        if field == "robot" or is_in_label(self._robot(), box.typed + SIGN):
            box.insert_text_at_cursor(SIGN)
        elif field == "from":
            self._enter()
        elif self.look() and isinstance(choice := self._choice(), Place):
            box.put("", Legs((*box.legs.places, choice)))
            self._list()

    def _choice(self) -> Choice | None:
        """Return the choice for Enter, None after showing an error if none is marked."""
        robot, field, typed = self._robot(), self._fields.current, self._fields.typed
        if (choice := self._choices.marked) is not None:
            return choice
        if field == "robot" and not typed:
            return ANYONE
        if typed and self._choices.option_count:
            self._choices.highlighted = 0
            self._say(missing(field, typed))
        else:
            problem = no_match(robot, field, typed) if typed else missing(field)
            self._say(without_places(robot) or problem)
        return None

    def _choose(self, field: str, choice: Choice) -> None:
        """Fill the field, and go on to the next one."""
        if isinstance(choice, Favourite):
            self._fields.take_both(choice)
            return
        if isinstance(choice, str):
            self._fields[field].put(choice)
            if (robot := self._robot()) is not None:
                self._fields.choose_for(robot.name)
            self._arrange()
        else:
            self._fields.take(field, choice)
        if field != "to":
            self._fields.step(1)

    def _finish(self) -> None:
        """Send a complete request; name missing input."""
        problem, field = self._sending.finish(self._robot(), self.action_close)
        if problem:
            self._say(problem, field)


class Proposal(Static):
    """Shows the nearest idle robot with the reason for it, why none can drive the order, or that a dispatcher
    chooses."""

    def __init__(self, state: Callable[[], FleetState]) -> None:
        super().__init__(id="proposal", markup=False)
        self._state = state
        self._found: Nearest | None = None
        self._places: tuple[Place, ...] = ()
        self._at = -math.inf
        self.display = False

    def on(self, draft: Draft) -> Draft | None:
        """Return a draft without a robot as that of the nearest idle one, None without one; a draft with a
        robot hides the proposal."""
        self._look(() if draft.robot else draft.places)
        if draft.robot or self._found is None:
            return draft if draft.robot else None
        return replace(draft, robot=self._found.robot, places=self._found.places)

    def _look(self, places: tuple[Place, ...]) -> None:
        state = self._state()
        if places == self._places and (not places or state.now - self._at < AGAIN):
            return
        self._places = places
        self._at = state.now
        is_dispatched = to_any(state, places) is not None
        self._found = nearest(state, places) if places and not is_dispatched else None
        reason = (
            why_none(state, places) if places and not is_dispatched else CHOSEN if is_dispatched else EMPTY
        )
        self.update(translate(sanitize(self._found.text if self._found is not None else reason)))
        self.display = bool(places)
