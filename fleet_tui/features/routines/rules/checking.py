"""Checks of a whole routine before it starts, against the robots and their graphs."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import assert_never

from fleet_tui.commands.language.words import find_robot, vertex_of
from fleet_tui.commands.route_checks import no_path, same_place, unknown_vertex
from fleet_tui.features.routines.blocks import (
    BatteryCondition,
    Block,
    CarryBlock,
    Condition,
    DayTime,
    GoBlock,
    IdleCondition,
    IfBlock,
    LanePlan,
    PlaceCondition,
    RepeatBlock,
    Routine,
    RoutineProblem,
    RunBlock,
    TimeSpan,
    WaitBlock,
)
from fleet_tui.model import kind
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import at_vertices
from fleet_tui.model.robot import Robot
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message, message_of

FindProgram = Callable[[Sequence[str]], str]
"""Returns the reason that a program can't be run, empty if it can."""


def robots_of(state: FleetState, routine: Routine) -> list[str]:
    """Return the robots of a routine as far as they exist."""
    found = list[str]()
    for lane in routine.lanes:
        try:
            found.append(find_robot(lane.robot, state).name)
        except CommandError:
            continue
    return list(dict.fromkeys(found))


def check_routine(state: FleetState, routine: Routine, program: FindProgram) -> list[RoutineProblem]:
    """Return every problem of a routine, in the order of its lines. Places of graphs that have not arrived
    are problems, too."""
    found = list[RoutineProblem]()
    seen: dict[str, int] = {}
    for lane in routine.lanes:
        try:
            robot = find_robot(lane.robot, state)
        except CommandError as problem:
            found.append(RoutineProblem(lane.line, message_of(problem)))
            continue
        if robot.name in seen:
            text = Message(
                "{name} has a lane from line {seen}: put all its instructions there",
                name=robot.name,
                seen=seen[robot.name],
            )
            found.append(RoutineProblem(lane.line, text))
        seen.setdefault(robot.name, lane.line)
        if not lane.body:
            found.append(
                RoutineProblem(
                    lane.line, Message("{name} has no instruction: add one before end", name=robot.name)
                )
            )
        found += _LaneCheck(state, robot, program).problems(lane)
    return sorted(dict.fromkeys(found), key=lambda problem: problem.line)


class _LaneCheck:
    """Follows the places of one robot through its blocks."""

    def __init__(self, state: FleetState, robot: Robot, program: FindProgram) -> None:
        self._state = state
        self._robot = robot
        self._program = program
        self._at: str | None = None
        """The vertex at which it is then, None if unknown."""

    def problems(self, lane: LanePlan) -> Iterator[RoutineProblem]:
        yield from self._blocks(lane.body)
        self._at = None
        yield from self._blocks(lane.on_failure)

    def _blocks(self, blocks: Iterable[Block]) -> Iterator[RoutineProblem]:
        for block in blocks:
            for text in self._texts(block):
                yield RoutineProblem(block.line, text)
            match block:
                case RepeatBlock(body=body):
                    yield from self._blocks(body)
                case IfBlock(body=body, otherwise=otherwise):
                    before = self._at
                    yield from self._blocks(body)
                    after, self._at = self._at, before
                    yield from self._blocks(otherwise)
                    self._at = self._at if self._at == after else None

    def _texts(self, block: Block) -> Iterator[Message]:
        match block:
            case GoBlock(place=place):
                yield from self._order([place], not self._takes_goals())
            case CarryBlock(start=start, end=end):
                yield from self._order([start, end], True)
            case WaitBlock(until=until):
                yield from self._condition(until)
            case IfBlock(condition=condition):
                yield from self._condition(condition)
            case RunBlock(arguments=arguments):
                if reason := self._program(arguments):
                    yield Message(reason)
            case RepeatBlock():
                yield from _rounds(block)
            case _:
                assert_never(block)

    def _takes_goals(self) -> bool:
        return kind.ORDER_TO in self._robot.kind.accepts

    def _order(self, places: Sequence[str], has_start: bool) -> Iterator[Message]:
        """Check the places of an order, and the way from one to the next."""
        robot = self._robot
        ability = kind.ORDER if has_start else kind.ORDER_TO
        if not robot.kind.can(ability):
            yield Message("{name}: {text}", name=robot.name, text=robot.kind.lack(ability))
            return
        vertices = list[str]()
        for place in places:
            try:
                vertices.append(vertex_of(robot, place)[0])
            except CommandError as problem:
                yield message_of(problem)
        if len(vertices) < len(places):
            self._at = None
            return
        order = PlaceOrder(robot.name, at_vertices(*vertices))
        for check in (unknown_vertex, same_place, no_path):
            yield from (problem.text for problem in check(self._state, robot, order))
        if self._at is not None and self._at != vertices[0]:
            before = PlaceOrder(robot.name, at_vertices(self._at, vertices[0]))
            yield from (problem.text for problem in no_path(self._state, robot, before))
        self._at = vertices[-1]

    def _condition(self, condition: Condition | TimeSpan | DayTime) -> Iterator[Message]:
        robot = self._robot
        match condition:
            case BatteryCondition() if "battery" not in robot.kind.reports:
                yield Message(
                    "{name}: this kind does not report its battery: use wait 30 min", name=robot.name
                )
            case IdleCondition() if not robot.kind.lists_orders:
                yield Message("{name}: this kind does not report its orders: use wait 30 s", name=robot.name)
            case PlaceCondition(place):
                try:
                    vertex_of(robot, place)
                except CommandError as problem:
                    yield message_of(problem)


def _rounds(block: RepeatBlock) -> Iterator[Message]:
    """Check that a repeat does something, and an endless one not without a rest."""
    if not block.body:
        yield Message("repeat without an instruction: add one before its end")
    elif block.times is None and not any(map(takes_time, block.body)):
        yield Message("endless repeat without a wait or an order in each round: add wait 30 s")


def takes_time(block: Block) -> bool:
    """Tell whether every way through a block has a wait or an order."""
    match block:
        case GoBlock() | CarryBlock() | WaitBlock():
            return True
        case RunBlock():
            return False
        case RepeatBlock(body=body):
            return any(map(takes_time, body))
        case IfBlock(body=body, otherwise=otherwise):
            return any(map(takes_time, body)) and any(map(takes_time, otherwise))
        case _:
            assert_never(block)
