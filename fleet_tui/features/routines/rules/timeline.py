"""A dry run: the instructions of each robot with estimated times."""

from collections.abc import Callable, Iterable
from typing import assert_never

from msgspec import Struct

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.language.words import vertex_of
from fleet_tui.commands.routes.order_draft import SPEED, Draft, draft_route
from fleet_tui.features.routines.blocks import (
    Block,
    CarryBlock,
    DayTime,
    GoBlock,
    IfBlock,
    LanePlan,
    Leaf,
    RepeatBlock,
    RunBlock,
    TimeSpan,
    WaitBlock,
)
from fleet_tui.model.robot import Robot
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message, joined, verbatim
from fleet_tui.text.units import age

MOST_ENTRIES = 200
"""Instructions of one robot in a timeline."""


NextTime = Callable[[DayTime, float], float]
"""Returns the Unix second at which the local clock next shows a time, from a Unix second on."""


class TimelineEntry(Struct, frozen=True):
    """An instruction of the timeline: `at` and `seconds` are its begin, from the start of the routine, and
    its duration. `is_least`: they are lower limits, since an earlier duration is unknown. `note` says why,
    or what is left out."""

    robot: str
    line: int
    text: str
    at: float
    seconds: float | None
    is_least: bool
    note: Message = EMPTY


def timeline(robot: Robot, lane: LanePlan, wall: float, next_time: NextTime) -> list[TimelineEntry]:
    """Return the timeline of a robot that starts at `wall`, Unix seconds; it ends in the first round of an
    endless repeat. A speed of 0.5 m/s is assumed."""
    drawn = _Drawing(robot, wall, next_time)
    drawn.blocks(lane.body)
    return drawn.entries


class _Drawing:
    """Follows the time and the place of one robot."""

    def __init__(self, robot: Robot, wall: float, next_time: NextTime) -> None:
        self.entries: list[TimelineEntry] = []
        self._robot = robot
        self._wall = wall
        self._next_time = next_time
        self._now = 0.0
        self._is_least = False
        self._at: Place | None = None

    def blocks(self, blocks: Iterable[Block], note: Message = EMPTY) -> bool:
        """Add blocks; tell whether anything can follow them."""
        for block in blocks:
            if len(self.entries) >= MOST_ENTRIES:
                self._add(block, None, Message("and so on"))
                return False
            match block:
                case RepeatBlock():
                    if not self._repeat(block):
                        return False
                case IfBlock():
                    if not self._if(block):
                        return False
                case GoBlock() | CarryBlock() | WaitBlock() | RunBlock():
                    seconds, why = self._estimate(block)
                    self._add(block, seconds, joined(", ", filter(None, (note, why))))
                case _:
                    assert_never(block)
        return True

    def _add(self, block: Block, seconds: float | None, note: Message) -> None:
        entry = TimelineEntry(
            self._robot.name, block.line, block.text, self._now, seconds, self._is_least, note
        )
        self.entries.append(entry)
        self._now += seconds or 0.0
        self._is_least = self._is_least or seconds is None

    def _repeat(self, block: RepeatBlock) -> bool:
        for _ in range(block.times or 1):
            before = len(self.entries)
            if not self.blocks(block.body):
                return False
            if len(self.entries) == before:
                break  # an empty round takes no time
        if block.times is None:
            self._add(block, None, Message("again and again, until it is stopped"))
        return block.times is not None

    def _if(self, block: IfBlock) -> bool:
        """Add both parts; the longer one counts."""
        began, at = self._now, self._at
        goes_on = self.blocks(block.body, verbatim(block.text))
        ended, end, self._now, self._at = self._now, self._at, began, at
        goes_on = (
            self.blocks(
                block.otherwise, Message("unless {condition}", condition=block.text.removeprefix("if "))
            )
            and goes_on
        )
        self._now = max(ended, self._now)
        self._at = self._at if self._at == end else None
        self._is_least = True
        return goes_on

    def _estimate(self, block: Leaf) -> tuple[float | None, Message]:
        match block:
            case WaitBlock(until=TimeSpan(seconds)):
                return seconds, EMPTY
            case WaitBlock(until=DayTime() as at):
                now = self._wall + self._now
                return self._next_time(at, now) - now, EMPTY
            case WaitBlock():
                return None, Message("unknown")
            case RunBlock(within=within):
                return None, Message("at most {age}", age=age(within))
            case GoBlock(place=place):
                return self._way(place)
            case CarryBlock(start=start, end=end):
                return self._way(start, end)
            case _:
                assert_never(block)

    def _way(self, *words: str) -> tuple[float | None, Message]:
        """Return the seconds of a way from the last place, else from that of the robot, by the graph."""
        try:
            found = [vertex_of(self._robot, word) for word in words]
        except CommandError:
            return None, Message("place unknown")
        places = [self._place(vertex, floor) for vertex, floor in found]
        stops = ([self._at] if self._at is not None else []) + places
        draft = Draft(self._robot.name, tuple(stops), starts_here=self._at is None)
        self._at = places[-1]
        if len(set(stops)) == 1 and not draft.starts_here:
            return 0.0, EMPTY
        route = draft_route(self._robot, draft)
        if route is None or route.metres is None:
            return None, Message("route unknown")
        return route.metres / SPEED, Message("{metres} m", metres=f"{route.metres:.0f}")

    def _place(self, vertex: str, floor: str) -> Place:
        floors = (name for name, one in self._robot.maps.items() if one.name_of(vertex) is not None)
        return Place(vertex, vertex, floor or next(floors, self._robot.floor or ""))
