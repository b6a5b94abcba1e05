"""Any frame of a robot with Nav2, in any order: nothing raises, no end or owner of an order is made up."""

import base64
from typing import Any

import msgspec
from hypothesis import example, given
from hypothesis import strategies as st

from fleet_tui.model.commands import PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation_events import GoalAnswered
from fleet_tui.model.order import at_vertices
from fleet_tui.robots.adapter import Feed, Site
from fleet_tui.robots.nav2.adapter import Nav2
from fleet_tui.robots.profile import Profile
from fleet_tui.state.reducer import apply
from tests.support.any_frames import assert_each_order_once, facts
from tests.support.fleets import R0, T0, commanded, fleet, graph, link_up, reduced, tick

ADAPTER = Nav2(Profile(kind="nav2", topics={"floor": "/{robot}/floor"}), Site())
FEEDS = {feed.key: feed for feed in ADAPTER.feeds(R0, ["floor_0"]) if not feed.large}
PLACES = {"navigate_to_pose": PlaceOrder(R0, at_vertices("2"))}

JSON = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**63), 2**63) | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=9), inner, max_size=4),
    max_leaves=12,
)
NUMBER = st.floats() | st.integers(-(2**40), 2**40) | st.none()
UUIDS = [base64.b64encode(bytes([n + 1]) * 16).decode() for n in range(4)]
UUID = st.sampled_from(UUIDS) | st.text(max_size=24)
STAMP = st.fixed_dictionaries({"sec": st.integers(-9, 2**31), "nanosec": st.integers(0, 10**9)}) | JSON
HEADER = st.fixed_dictionaries({"stamp": STAMP, "frame_id": st.text(max_size=4)})
PLACE = st.fixed_dictionaries(
    {
        "position": st.fixed_dictionaries({"x": NUMBER, "y": NUMBER}),
        "orientation": st.fixed_dictionaries(dict.fromkeys("xyzw", NUMBER)),
    }
)
LOCATED = st.fixed_dictionaries(
    {
        "header": HEADER,
        "pose": st.fixed_dictionaries({"pose": PLACE, "covariance": st.lists(NUMBER, max_size=9)}),
    }
)
STATUS = st.fixed_dictionaries(
    {
        "goal_info": st.fixed_dictionaries(
            {"goal_id": st.fixed_dictionaries({"uuid": UUID}), "stamp": STAMP}
        ),
        "status": st.integers(0, 7) | JSON,
    }
)
STATUSES = st.fixed_dictionaries({"status_list": st.lists(STATUS | JSON, max_size=4)})
FEEDBACK = st.fixed_dictionaries(
    {
        "goal_id": st.fixed_dictionaries({"uuid": UUID}),
        "feedback": st.fixed_dictionaries(
            {},
            optional={
                "distance_remaining": NUMBER,
                "estimated_time_remaining": STAMP,
                "number_of_recoveries": NUMBER,
                "current_waypoint": NUMBER,
            },
        ),
    }
)
MESSAGES = {
    "odometry": LOCATED,
    "pose": LOCATED,
    "battery": st.fixed_dictionaries({"percentage": NUMBER}),
    "blocked": st.fixed_dictionaries({"action_type": NUMBER, "polygon_name": st.text(max_size=4)}),
    "floor": st.fixed_dictionaries({"data": st.text(max_size=9)}),
    "plan": st.fixed_dictionaries(
        {"poses": st.lists(st.fixed_dictionaries({"pose": PLACE}) | JSON, max_size=2)}
    ),
}


def _message(key: str) -> st.SearchStrategy[Any]:
    usual = FEEDBACK if key.endswith("feedback") else MESSAGES.get(key, STATUSES)
    return usual | JSON


FRAMES = st.sampled_from(sorted(FEEDS)).flatmap(lambda key: st.tuples(st.just(FEEDS[key]), _message(key)))


def begun() -> FleetState:
    state = fleet()
    robots = {R0: msgspec.structs.replace(state.robots[R0], kind=ADAPTER.kind)}
    return reduced(msgspec.structs.replace(state, robots=robots), link_up(T0), graph(1, 2, 3), tick(T0))


@given(st.lists(FRAMES | st.none(), max_size=14))
def test_any_frames_in_any_order(frames: list[tuple[Feed, object] | None]) -> None:
    assert_each_order_once(
        ADAPTER, reduced(begun(), *commanded(7, PLACES["navigate_to_pose"], Stage.SENT)), frames
    )


STATES = st.lists(st.tuples(st.integers(0, 3), st.integers(1, 6)), max_size=4)
"""Of some goals their status."""


def statuses(states: list[tuple[int, int]]) -> dict[str, Any]:
    return {
        "status_list": [
            {
                "goal_info": {"goal_id": {"uuid": UUIDS[n]}, "stamp": {"sec": 0, "nanosec": 0}},
                "status": status,
            }
            for n, status in states
        ]
    }


@given(st.lists(STATES | st.just(None), max_size=12), st.booleans())
@example([[(0, 2)], [(0, 5)], [], [(0, 4)]], True)
def test_done_is_only_what_ended_with_4_and_of_two_new_ones_none_is_ours(
    steps: list[list[tuple[int, int]] | None], failed: bool
) -> None:
    feed, at = FEEDS["navigate_to_pose"], T0
    state = reduced(begun(), *commanded(7, PLACES["navigate_to_pose"], Stage.SENT))
    if failed:
        state = apply(state, GoalAnswered(7, Stage.FAILED, T0, "missed"))
    succeeded, recognised = set[str](), ""
    for step in steps:
        at += 0.3
        if step is None:
            state = apply(state, tick(at))
        else:
            for fact in facts(ADAPTER, feed, statuses(step), at):
                state = apply(state, fact)
        listed = {order.id for order in state.robots[R0].orders.orders}
        succeeded |= {order.id for order in state.robots[R0].orders.orders if order.word == "succeeded"}
        (record,) = state.commands
        if record.order_id and not recognised:
            recognised = record.order_id
            assert len(listed) == 1 or recognised not in listed, "two were new, and one was taken for ours"
    for later in (0.1, 2.0, 9.0):
        state = apply(state, tick(at + later))
    (record,) = state.commands
    if record.stage is Stage.DONE:
        assert record.order_id in succeeded and not failed
