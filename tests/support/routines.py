"""Routines as text and at random, and a lane that is led through its events."""

from collections.abc import Callable, Sequence

from hypothesis import strategies as st

from fleet_tui.features.routines.blocks import Condition, DayTime, LanePlan
from fleet_tui.features.routines.lane import (
    BEGUN,
    ENDED,
    LEFT,
    GiveOrder,
    Lane,
    LaneAction,
    LaneEvent,
    LaneFacts,
    LaneNote,
    LanePaused,
    LaneResumed,
    LaneSkipped,
    LaneStepped,
    LaneStopped,
    OrderEnded,
    OrderWithheld,
    ProgramEnded,
    Ticked,
)
from fleet_tui.features.routines.rules.parsing import parse_routine
from fleet_tui.features.routines.rules.stepping import step
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.language import EMPTY, Message
from tests.support.fleets import R0, T0, battery, fleet, graph, labels, link_up, pose, queue, reduced, tick

MORNING = """\
every weekday 06:30
for robot_0 robot_1
  go Base
  repeat 2
    carry Base Consumidores
    if battery < 30
      wait until battery > 80
    else
      run check.sh
    end
  end
  on failure
    go Base
  end
end
"""


def two_robots() -> FleetState:
    """Two robots with a graph of three places in a row and one apart, the first one at Base with a queue."""
    rows = [graph(1, 2, 3, robot=name) for name in (R0, "robot_1")]
    names = [
        labels({1: "Base", 2: "Consumidores", 3: "Packing area"}, robot=name) for name in (R0, "robot_1")
    ]
    return reduced(fleet(2), link_up(T0), *rows, *names, pose(T0), battery(T0), queue(T0), tick(T0))


def plan_of(*lines: str) -> LanePlan:
    """The lane of instructions."""
    parsed = parse_routine("\n".join(["for robot_0", *lines, "end"]))
    assert parsed.problems == ()
    return parsed.routine.lanes[0]


def facts(
    wall: float = 0.0, no_link: Message = EMPTY, holds: Callable[[Condition], bool | None] = lambda _: True
) -> LaneFacts:
    """The world; the local clock shows minute N at N * 60 seconds."""

    def next_time(at: DayTime) -> float:
        return at.minute * 60.0

    return LaneFacts(wall, no_link, holds, next_time)


class LedLane:
    """A lane with everything that it did."""

    def __init__(self, plan: LanePlan) -> None:
        self.plan, self.lane = plan, Lane(R0)
        self.actions = list[LaneAction]()

    def after(self, *events: LaneEvent) -> Lane:
        for event in events:
            self.lane, actions = step(self.plan, self.lane, event)
            self.actions += actions
        return self.lane

    def ticked(self, wall: float = 0.0) -> Lane:
        return self.after(Ticked(facts(wall)))

    @property
    def ordered(self) -> list[int]:
        """The lines whose orders were given."""
        return [action.block.line for action in self.actions if isinstance(action, GiveOrder)]

    @property
    def notes(self) -> list[tuple[str, int]]:
        return [(note.change, note.line) for note in self.actions if isinstance(note, LaneNote)]

    def open_blocks(self) -> list[int]:
        """The lines of the blocks that have begun and not ended; fails where an end fits no begin."""
        opened = list[int]()
        for change, line in self.notes:
            if not line:
                continue
            if change == BEGUN:
                opened.append(line)
            elif change in (ENDED, LEFT):
                assert opened and opened.pop() == line
        return opened


_LEAVES = (
    "go A",
    "carry A B C",
    "wait 30 s",
    "wait until 06:30",
    "wait until idle",
    "run x",
    "wait until at A",
)
_CONDITIONS = ("battery < 30", "battery > 80", "idle", "at A")


def _nested(inner: st.SearchStrategy[list[str]]) -> st.SearchStrategy[list[str]]:
    blocks = st.lists(inner, max_size=3).map(lambda parts: [line for part in parts for line in part])
    repeats = st.tuples(st.sampled_from(("repeat", "repeat 1", "repeat 3")), blocks)
    choices = st.tuples(st.sampled_from(_CONDITIONS), blocks, blocks)
    return st.one_of(
        repeats.map(lambda one: [one[0], *one[1], "end"]),
        choices.map(lambda one: [f"if {one[0]}", *one[1], "else", *one[2], "end"]),
    )


blocks = st.recursive(st.sampled_from(_LEAVES).map(lambda leaf: [leaf]), _nested, max_leaves=8)
bodies = st.lists(blocks, max_size=4).map(lambda parts: [line for part in parts for line in part])
plans: st.SearchStrategy[LanePlan] = st.tuples(bodies, bodies).map(
    lambda both: plan_of(*both[0], "on failure", *both[1], "end")
)


def _ticks() -> st.SearchStrategy[LaneEvent]:
    known = st.sampled_from((True, True, False, None))
    made = st.tuples(st.floats(0.0, 1e6), st.sampled_from((EMPTY, EMPTY, EMPTY, Message("no link"))), known)
    return made.map(lambda one: Ticked(facts(one[0], one[1], lambda _: one[2])))


_OTHERS: Sequence[LaneEvent] = (
    OrderEnded(True),
    OrderEnded(True),
    OrderEnded(False, Message("lost")),
    OrderWithheld(Message("paused")),
    ProgramEnded(True),
    ProgramEnded(False, Message("exit status 1")),
    LanePaused(),
    LaneResumed(),
    LaneStepped(),
    LaneSkipped(),
)
lane_events = st.lists(st.one_of(_ticks(), _ticks(), st.sampled_from(_OTHERS)), max_size=60)
STOP = LaneStopped()
