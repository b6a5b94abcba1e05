"""Any frame of a robot with move_base, in any order: nothing raises, no end or owner of an order is made
up."""

from typing import Any

import msgspec
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.commands import PlaceOrder, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import at_vertices
from fleet_tui.robots.adapter import Feed, Site
from fleet_tui.robots.move_base.adapter import MoveBase
from fleet_tui.robots.profile import Profile
from fleet_tui.state.reducer import apply
from fleet_tui.text.language import Message
from tests.support.any_frames import assert_each_order_once, facts
from tests.support.fleets import R0, T0, fleet, graph, link_up, reduced, tick

ADAPTER = MoveBase(Profile(kind="move_base", topics={"floor": "/{robot}/floor"}), Site())
FEEDS = {feed.key: feed for feed in ADAPTER.feeds(R0, ["floor_0"]) if not feed.large}
OURS = "fleet-tui-01234567-89ab-cdef-0123-456789abcdef"
NAMES = (OURS, "/rviz-1-1700000000.5", "/rviz-2-1700000001.5", "x")

JSON = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**63), 2**63) | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=9), inner, max_size=4),
    max_leaves=12,
)
NUMBER = st.floats() | st.integers(-(2**40), 2**40) | st.none()
STAMP = st.fixed_dictionaries({"secs": st.integers(-9, 2**31), "nsecs": st.integers(0, 10**9)}) | JSON
HEADER = st.fixed_dictionaries({"stamp": STAMP, "frame_id": st.text(max_size=4)})
PLACE = st.fixed_dictionaries(
    {
        "position": st.fixed_dictionaries({"x": NUMBER, "y": NUMBER}),
        "orientation": st.fixed_dictionaries(dict.fromkeys("xyzw", NUMBER)),
    }
)
POSED = st.fixed_dictionaries({"header": HEADER, "pose": PLACE})
STATUS = st.fixed_dictionaries(
    {
        "goal_id": st.fixed_dictionaries(
            {"id": st.sampled_from(NAMES) | st.text(max_size=9), "stamp": STAMP}
        ),
        "status": st.integers(-1, 11) | JSON,
        "text": st.text(max_size=9),
    }
)
MESSAGES = {
    "status": st.fixed_dictionaries({"status_list": st.lists(STATUS | JSON, max_size=4)}),
    "target": POSED,
    "feedback": st.fixed_dictionaries({"feedback": st.fixed_dictionaries({"base_position": POSED})}),
}
FRAMES = st.sampled_from(sorted(FEEDS)).flatmap(
    lambda key: st.tuples(st.just(FEEDS[key]), MESSAGES.get(key, JSON) | JSON)
)


def begun(*vertices: str) -> FleetState:
    """An order to these vertices has just been sent."""
    state = fleet()
    robots = {R0: msgspec.structs.replace(state.robots[R0], kind=ADAPTER.kind)}
    state = reduced(msgspec.structs.replace(state, robots=robots), link_up(T0), graph(1, 2, 3), tick(T0))
    order = PlaceOrder(R0, at_vertices(*vertices))
    return reduced(
        state, CommandIssued(7, order, T0, T0), CommandAdvanced(7, Stage.SENT, T0, Message(""), OURS)
    )


@given(st.lists(FRAMES | st.none(), max_size=14))
def test_any_frames_in_any_order(frames: list[tuple[Feed, object] | None]) -> None:
    assert_each_order_once(ADAPTER, begun("1", "2"), frames)


LISTS = st.lists(st.tuples(st.integers(0, 3), st.integers(0, 9)), max_size=4)
"""Of some goals their status."""


def statuses(listed: list[tuple[int, int]]) -> dict[str, Any]:
    stamp = {"secs": 0, "nsecs": 0}
    return {
        "status_list": [
            {"goal_id": {"id": NAMES[n], "stamp": stamp}, "status": status, "text": ""}
            for n, status in dict(listed).items()
        ]
    }


@given(st.lists(LISTS | st.none(), max_size=12))
def test_only_the_goal_of_its_name_is_the_order_and_done_is_only_3(
    steps: list[list[tuple[int, int]] | None],
) -> None:
    state, at, told_of_ours = begun("2"), T0, list[int]()
    for step in steps:
        at += 0.3
        for fact in facts(ADAPTER, FEEDS["status"], statuses(step), at) if step is not None else [tick(at)]:
            state = apply(state, fact)
        told_of_ours += [dict(step)[0]] if step is not None and 0 in dict(step) else []
    for later in (0.1, 2.0, 9.0):
        state = apply(state, tick(at + later))
    (record,) = state.commands
    assert record.order_id in (None, "01234567")
    if not told_of_ours:
        assert record.stage is Stage.NOT_CONFIRMED
    if record.stage is Stage.DONE:
        assert 3 in told_of_ours
    if record.stage is Stage.REFUSED:
        assert 5 in told_of_ours
