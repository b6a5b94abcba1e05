"""Commands to all marked rows: asked once, sent one by one, each with its own outcome."""

from collections.abc import Callable, Iterator, Sequence

from msgspec.structs import replace

from fleet_tui.controllers.dispatch import Ask, Dispatch
from fleet_tui.model.commands import Command, PauseRobot, PlaceOrder
from fleet_tui.model.order import Stop
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.lookup import places
from fleet_tui.state.store import Store
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.lines.questions import losses, request_text

SHOWN = 12
"""Lines of a question; the number of others follows."""
Outcomes = Callable[[Sequence[tuple[Command, str]]], None]
"""Shows the outcome of each command, with the reason of those that were not sent."""


class MarkedCommands:
    """`marks` are the marked robots in the order of the fleet; `done` is called when their commands were
    sent."""

    def __init__(
        self,
        store: Store,
        dispatch: Dispatch,
        ask: Ask,
        marks: Callable[[], list[str]],
        outcomes: Outcomes,
        done: Callable[[], None],
    ) -> None:
        self._store, self._dispatch, self._ask = store, dispatch, ask
        self._marks, self._outcomes, self._done = marks, outcomes, done

    def do(self, selected: str, make: Callable[[str], Command]) -> None:
        """Give a command to the marked robots, without marks to the selected one."""
        robots = self._marks() or [selected]
        self.give([Request((make(robot),)) for robot in robots])

    def give(self, requests: Sequence[Request]) -> None:
        """Send requests, after one question if they are several. A pause is never asked about."""
        if len(requests) == 1:
            self._dispatch.do(requests[0])
        elif all(isinstance(one, PauseRobot) for request in requests for one in request.commands):
            self._send(requests)
        else:
            self._ask(lambda: self._question(requests), lambda: self._send(requests))

    def give_order(self, request: Request, sent: Callable[[], None]) -> str:
        """Send an order of the form, to all marked robots if its own is one of them. Returns the reason not
        to."""
        marks, (first, *_) = self._marks(), request.commands
        if len(marks) < 2 or first.robot not in marks:
            return self._dispatch.give(request, sent)
        robots = self._store.state.robots
        requests = [_as_for(request, robots[first.robot], robots[name]) for name in marks]

        def send() -> None:
            self._send(requests)
            sent()

        self._ask(lambda: self._question(requests), send)
        return ""

    def _question(self, requests: Sequence[Request]) -> str:
        lines = [line for request in requests for line in self._lines(request)]
        more = [f"and {len(lines) - SHOWN} more"] if len(lines) > SHOWN else []
        return "\n".join(
            [f"Send to {len(requests)} robots?", *(f"  {line}" for line in lines[:SHOWN]), *more]
        )

    def _lines(self, request: Request) -> Iterator[str]:
        """Yield what a request is about, with its losses and warnings, or why it can't be sent."""
        state = self._store.state
        found = self._dispatch.objections(request)
        against = next((problem.text for problem in found if problem.blocks), "")
        if against:
            yield f"not sent: {sanitize(against)}"
            return
        warnings = "".join(f" ({sanitize(problem.text)})" for problem in found)
        lost = list(losses(state, request)) or [request_text(state, request)]
        yield lost[0] + warnings
        yield from lost[1:]

    def _send(self, requests: Sequence[Request]) -> None:
        told = []
        for request in requests:
            problem = self._dispatch.send_confirmed(request)
            told += [(command, problem) for command in request.commands]
        self._outcomes(told)
        self._done()


def _as_for(request: Request, robot: Robot, other: Robot) -> Request:
    """Return the request of a robot for another one, whose graph may have other ids for the same labels."""
    if robot is other:
        return request
    ids = {(place.name, place.floor): place.vertex for place in places(other)}

    def stop(one: Stop) -> Stop:
        floor = request.floors.get(one.vertex, "")
        return replace(one, vertex=ids.get((robot.name_of(one.vertex) or "", floor), one.vertex))

    commands = tuple(
        replace(one, robot=other.name, stops=tuple(map(stop, one.stops)))
        for one in request.commands
        if isinstance(one, PlaceOrder)
    )
    floors = {
        ids.get((robot.name_of(vertex) or "", floor), vertex): floor
        for vertex, floor in request.floors.items()
    }
    return replace(request, commands=commands, floors=floors)
