"""Commands to all marked rows: asked once, sent one by one, each with its own outcome."""

from collections.abc import Callable, Iterator, Sequence
from time import monotonic

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.commands.language.any_robot import own_place
from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.subject import Subject, subject_of
from fleet_tui.model.commands import Command, PauseRobot, PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message, joined, verbatim
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.view.lines.questions import losses, request_text

SHOWN = 12
"""Lines of a question; the number of others follows."""
Outcomes = Callable[[Sequence[tuple[Command, Message]], float], None]
"""Shows the outcome of each command sent since a moment (monotonic), with the reason of those that were not
sent."""


class _Asked(Struct, frozen=True):
    """The request for one row, and what it is about; `lack`: the reason that it can't have it."""

    request: Request
    subject: Subject
    lack: Message = EMPTY


class MarkedCommands:
    """`marks` are the marked robots in the order of the fleet; `done` is called when their commands were
    sent."""

    def __init__(
        self, console: Console, marks: Callable[[], list[str]], outcomes: Outcomes, done: Callable[[], None]
    ) -> None:
        self._store = console.store
        self._dispatch = console.dispatch
        self._ask = console.ask
        self._marks = marks
        self._outcomes = outcomes
        self._done = done

    def do(self, selected: str, make: Callable[[str], Command]) -> None:
        """Give a command to the marked robots, without marks to the selected one."""
        if marks := self._marks():
            self.give([Request((make(robot),)) for robot in marks])
        else:
            self._dispatch.do(Request((make(selected),)))

    def give(self, requests: Sequence[Request]) -> None:
        """Send the requests of marked rows, after one question if they are several. A pause is never asked
        about."""
        state = self._store.state
        asked = [_Asked(request, subject_of(state, request)) for request in requests]
        if len(requests) == 1:
            self._dispatch.do(requests[0], self._done)
        elif all(isinstance(one, PauseRobot) for request in requests for one in request.commands):
            self._send(asked)
        else:
            self._ask(lambda: self._question(asked), lambda: self._send(asked))

    def give_order(self, request: Request, sent: Callable[[], None]) -> Message:
        """Send an order of the form, to all marked robots if its own is one of them. Returns the reason not
        to."""
        marks, (first, *_) = self._marks(), request.commands
        if first.robot not in marks:
            return self._dispatch.give(request, sent)

        def done() -> None:
            sent()
            self._done()

        if len(marks) == 1:
            return self._dispatch.give(request, done)
        state = self._store.state
        asked = [_asked_of(state, request, state.robots[first.robot], state.robots[name]) for name in marks]

        def send() -> None:
            self._send(asked)
            sent()

        self._ask(lambda: self._question(asked), send)
        return EMPTY

    def _question(self, asked: Sequence[_Asked]) -> Message:
        commands = [command for one in asked for command in one.request.commands]
        robots = len({command.robot for command in commands})
        head = (
            Message("Send to {count} robots?", count=robots)
            if robots > 1
            else Message("Send {count} commands?", count=len(commands))
        )
        lines = [line for one in asked for line in self._lines(one)]
        more = [Message("and {count} more", count=len(lines) - SHOWN)] if len(lines) > SHOWN else []
        return joined("\n", [head, *("  " + line for line in lines[:SHOWN]), *more])

    def _lines(self, asked: _Asked) -> Iterator[Message]:
        """Yield what a request is about, with its losses and warnings, or why it can't be sent."""
        state, request = self._store.state, asked.request
        found = self._dispatch.objections(request)
        against = asked.lack or next((problem.text for problem in found if problem.blocks), EMPTY)
        if against or (withdrawn := self._dispatch.withdrawn(request, asked.subject)):
            yield Message("not sent: {problem}", problem=sanitize(against)) if against else withdrawn
            return
        warnings = joined("", (Message(" ({text})", text=sanitize(problem.text)) for problem in found))
        first, *others = list(losses(state, request)) or [request_text(state, request)]
        yield Message("{first}{warnings}", first=first, warnings=warnings)
        yield from map(verbatim, others)

    def _send(self, asked: Sequence[_Asked]) -> None:
        told, since = list[tuple[Command, Message]](), monotonic()
        for one in asked:
            problem = (
                Message("not sent: {problem}", problem=one.lack)
                if one.lack
                else self._dispatch.send_confirmed(one.request, one.subject)
            )
            told += [(command, problem) for command in one.request.commands]
        self._outcomes(told, since)
        self._done()


def _asked_of(state: FleetState, request: Request, robot: Robot, other: Robot) -> _Asked:
    """Return the orders of a robot for another one, whose graph may have other ids for the same labels."""
    if robot is other:
        return _Asked(request, subject_of(state, request))
    orders = [one for one in request.commands if isinstance(one, PlaceOrder)]
    own = dict[str, str]()
    lacks = list[Message]()
    for vertex, floor in request.floors:
        label = robot.maps[floor].name_of(vertex) if floor in robot.maps else None
        place = Place(vertex, label or vertex, floor)
        found = own_place(state, other, place)
        own[vertex] = found.vertex if found else vertex
        lacks += (
            []
            if found
            else [Message("{name} has no {place} on {floor}", name=other.name, place=place.name, floor=floor)]
        )
    commands = tuple(
        replace(
            one,
            robot=other.name,
            stops=tuple(replace(stop, vertex=own.get(stop.vertex, stop.vertex)) for stop in one.stops),
        )
        for one in orders
    )
    floors = tuple((own[vertex], floor) for vertex, floor in request.floors)
    own_request = replace(request, commands=commands, floors=floors)
    return _Asked(own_request, subject_of(state, own_request), next(iter(lacks), EMPTY))
