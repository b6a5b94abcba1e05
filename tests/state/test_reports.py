"""The values of one robot and their ages: late ones never look new, and a wrong clock makes none late."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.model.commands import Command, PauseRobot, Stage
from fleet_tui.model.events import Event, GraphReceived, PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.text.language import Message
from tests.support.fleets import (
    F0,
    R0,
    T0,
    battery,
    commanded,
    fleet,
    graph,
    labels,
    pose,
    queue,
    reduced,
    tick,
)

HOURS = 3600.0


def of_one_frame(state: FleetState) -> FleetState:
    """Return the fleet with robots whose frames do not name their floor."""
    robots = {
        name: replace(one, kind=replace(one.kind, frames_are_floors=False))
        for name, one in state.robots.items()
    }
    return replace(state, robots=robots)


def test_localisation_in_place_of_odometry_is_no_movement() -> None:
    stands = reduced(of_one_frame(fleet()), pose(T0, frame="odom"), pose(T0 + 2, frame="odom"))
    placed = reduced(stands, pose(T0 + 3, x=8.0, frame="map"))
    assert robot(placed).still_for == 3.0
    assert robot(reduced(placed, pose(T0 + 4, x=8.5, frame="map"))).still_for == 0.0
    assert robot(reduced(fleet(), pose(T0), pose(T0 + 3, frame="floor_1"))).still_for == 0.0


def robot(state: FleetState) -> Robot:
    return state.robots[R0]


def age_of_pose(state: FleetState, at: float) -> float:
    reading = robot(state).pose
    assert reading is not None
    return at - reading.at


def live(start: float, clock: float, seconds: int = 3) -> list[Event]:
    """Ten poses a second from a robot whose clock is `clock` ahead of ours."""
    return [pose(start + n / 10, stamp=start + n / 10 + clock) for n in range(10 * seconds)]


@pytest.mark.parametrize("clock", [0.0, -7 * HOURS, 7 * HOURS, 1.7e9])
def test_a_clock_hours_off_makes_nothing_old(clock: float) -> None:
    state = reduced(fleet(), *live(T0, clock))
    assert age_of_pose(state, T0 + 2.9) == pytest.approx(0.0, abs=1e-3)
    assert reduced(state, tick(T0 + 3.0)).is_online(robot(state))


@pytest.mark.parametrize("clock", [0.0, -7 * HOURS, 7 * HOURS])
def test_a_burst_of_late_poses_never_looks_new(clock: float) -> None:
    """A server froze for a minute; then everything comes at once."""
    state = reduced(fleet(), *live(T0, clock))
    thaw = T0 + 63.0
    for n in range(30):
        sent = T0 + 3.0 + n / 10
        state = reduced(state, pose(thaw, stamp=sent + clock), tick(thaw))
        assert age_of_pose(state, thaw) == pytest.approx(thaw - sent, abs=0.2)
        assert not state.is_online(robot(state))


def test_a_clock_set_back_is_a_new_clock() -> None:
    state = reduced(fleet(), *live(T0, 0.0), *live(T0 + 3.0, -2 * HOURS))
    assert age_of_pose(state, T0 + 5.9) == pytest.approx(0.0, abs=1e-3)


def test_a_clock_set_forward_is_believed_again_when_it_is_set_right() -> None:
    state = reduced(fleet(), *live(T0, 0.0), *live(T0 + 3.0, HOURS), *live(T0 + 6.0, 0.0))
    assert age_of_pose(state, T0 + 8.9) == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("drift", [-1e-4, 1e-4])
def test_a_clock_that_drifts_for_days_does_not_take_a_robot_offline(drift: float) -> None:
    state = fleet()
    for minute in range(3 * 24 * 60):
        at = T0 + 60.0 * minute
        state = reduced(state, pose(at, stamp=at * (1.0 + drift)))
    assert age_of_pose(state, at) < 1.0


def test_jitter_of_the_network_is_an_age_of_its_own() -> None:
    state = reduced(fleet(), *live(T0, 0.0), pose(T0 + 3.4, stamp=T0 + 3.0))
    assert age_of_pose(state, T0 + 3.4) == pytest.approx(0.4, abs=1e-2)


@given(st.lists(st.tuples(st.floats(0.0, 30.0), st.floats(0.0, 30.0)), min_size=1, max_size=30))
def test_no_pose_is_ever_from_the_future(steps: list[tuple[float, float]]) -> None:
    """Whatever comes with whatever delay; stamps of one robot run forward."""
    state, at, stamp = fleet(), T0, 5.0
    for wait, sent_after in steps:
        at, stamp = at + wait, stamp + sent_after
        state = reduced(state, pose(at, stamp=stamp))
        assert age_of_pose(state, at) >= -1e-6
        assert (robot(state).last_received or 0.0) <= at + 1e-6


def test_a_stamp_beyond_all_measure_makes_nothing_new() -> None:
    """So large a sum is right to the nearest quarter of an hour."""
    for at in range(int(T0), int(T0) + 2000, 100):
        state = reduced(fleet(), pose(float(at), stamp=2.0**63))
        assert age_of_pose(state, float(at)) >= 0.0
        assert (robot(state).last_received or 0.0) <= at


def test_without_a_stamp_arrival_counts() -> None:
    state = reduced(fleet(), pose(T0 + 1.0), battery(T0 + 4.0))
    assert age_of_pose(state, T0 + 4.0) == 3.0
    assert robot(state).last_received == T0 + 4.0


def test_a_late_pose_does_not_take_back_what_was_heard() -> None:
    state = reduced(fleet(), battery(T0 + 10.0), *live(T0, 0.0))
    assert robot(state).last_received == T0 + 10.0


def test_a_leading_slash_of_a_frame_is_nothing() -> None:
    state = reduced(fleet(), pose(T0, frame="/floor_0"))
    assert robot(state).floor == F0
    lost = reduced(state, pose(T0, frame="attic"))
    assert robot(lost).floor is None


def accepted(command: Command, id_: int = 1) -> tuple[Event, ...]:
    return commanded(id_, command, Stage.SENT, Stage.ACCEPTED)


def test_paused_by_us_until_it_moves() -> None:
    state = reduced(fleet(), pose(T0, 5.0, 5.0), *accepted(PauseRobot(R0)))
    assert state.is_paused(robot(state)) and robot(state).paused_by_us
    braking = reduced(state, pose(T0 + 1, 5.3, 5.0), pose(T0 + 2, 5.4, 5.0))
    assert braking.is_paused(robot(braking))
    driving = reduced(braking, pose(T0 + 3, 5.9, 5.0))
    assert not driving.is_paused(robot(driving))


@pytest.mark.parametrize("says", [True, False])
def test_the_robots_own_word_counts_more_than_our_pause(says: bool) -> None:
    state = reduced(fleet(), *accepted(PauseRobot(R0)), PausedReported(R0, T0, says))
    assert state.is_paused(robot(state)) is says


ORDERS = ((1, 10, 11, "W"), (2, 11, 99, "Q"))


@pytest.mark.parametrize("graph_first", [True, False])
def test_an_order_to_nowhere_is_counted_once_in_whatever_order_things_come(graph_first: bool) -> None:
    facts = [queue(T0, *ORDERS), graph(10, 11)]
    state = reduced(fleet(), *(reversed(facts) if graph_first else facts))
    assert robot(state).faults == 1
    assert robot(state).last_fault == "order 2 names unknown vertex 99"
    again = reduced(state, queue(T0 + 1, *ORDERS), graph(10, 11), queue(T0 + 2, *ORDERS))
    assert robot(again).faults == 1
    more = reduced(again, queue(T0 + 3, *ORDERS, (3, 98, 10, "Q")))
    assert (robot(more).faults, robot(more).last_fault) == (2, "order 3 names unknown vertex 98")


def test_a_vertex_is_unknown_only_when_every_graph_has_come() -> None:
    state = reduced(fleet(1, 2), graph(10, 11), queue(T0, *ORDERS))
    assert robot(state).faults == 0
    assert robot(reduced(state, graph(99, floor="floor_1"))).faults == 0
    assert robot(reduced(state, graph(98, floor="floor_1"))).faults == 1


def test_what_a_graph_left_out_is_counted_at_every_arrival() -> None:
    bad = GraphReceived(R0, F0, RouteGraph(), 3, Message("graph of floor_0: edge 4 names unknown vertex 7"))
    state = reduced(fleet(), bad)
    assert (robot(state).faults, robot(state).last_fault) == (3, bad.fault)


def test_a_vertex_has_the_name_of_the_floor_the_robot_is_on() -> None:
    """Ids of two floors may be the same."""
    facts = (graph(1), labels({1: "Base"}), graph(1, 2, floor="floor_1"), labels({1: "Attic"}, "floor_1"))
    state = reduced(fleet(1, 2), *facts)
    assert robot(state).name_of("1") == "Base"
    upstairs = reduced(state, pose(T0, frame="floor_1"))
    assert robot(upstairs).name_of("1") == "Attic"
    assert robot(upstairs).name_of("2") == "2"
    assert robot(upstairs).name_of("3") is None


def test_a_reading_keeps_the_moment_at_which_it_was_true() -> None:
    state = reduced(fleet(), battery(T0 + 2.0, 55.0), pose(T0 + 9.0))
    assert robot(state).battery == Reading(55.0, T0 + 2.0)
