"""Goals replaced, cancelled, missed, aborted. No wire, no clock."""

import math
from itertools import pairwise
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.messages import stamped
from fleet_tui.simulator.nav2.navigation import DOCK, THROUGH, TO_POSE, WAYPOINTS, SimNavigation
from fleet_tui.simulator.navigating.world import NavigatingWorld
from fleet_tui.simulator.ros.goals import ABORTED, CANCELED, EXECUTING, SUCCEEDED, ServedGoal

NO_ROBOTS = bytes(16)
FAR, NEAR = (35.0, 20.0), (8.0, 0.0)


def world() -> tuple[NavigatingWorld[SimNavigation], SimNavigation]:
    it = NavigatingWorld(SimNavigation, 1, 1, seed=1, quiet=True)
    return it, it.navigation["robot_0"]


def waypoints(*spots: tuple[float, float]) -> dict[str, Any]:
    poses = [stamped(Pose(*spot)) for spot in spots]
    return {"number_of_loops": 0, "goal_index": 0, "poses": poses}


def given_to(navigation: SimNavigation, verb: str, request: dict[str, Any]) -> ServedGoal:
    goal = navigation.take(verb, request)
    assert goal is not None
    return goal


def driven(navigation: SimNavigation, *spot: float) -> ServedGoal:
    goal = navigation.give(*spot)
    assert goal is not None
    return goal


def finish(it: NavigatingWorld[SimNavigation], goal: ServedGoal, limit: float = 300.0) -> None:
    end = it.time + limit
    while not goal.over:
        it.step(0.1)
        assert it.time < end


def test_a_goal_is_reached_with_its_heading() -> None:
    it, navigation = world()
    goal = driven(navigation, *FAR, 1.0)
    robot = navigation.robot
    assert (robot.distance_remaining, robot.time_remaining) == (0.0, 0.0)
    it.step(1.5)  # it turns first
    left = robot.distance_remaining
    assert left > math.dist((robot.pose.x, robot.pose.y), FAR)
    finish(it, goal)
    assert (goal.status, goal.result) == (SUCCEEDED, {"error_code": 0, "error_msg": ""})
    assert (robot.pose.x, robot.pose.y, robot.pose.yaw) == pytest.approx((*FAR, 1.0))
    assert (robot.odom.x, robot.odom.y) != pytest.approx((robot.pose.x, robot.pose.y), abs=0.1)


def test_a_new_goal_replaces_the_running_one_at_once() -> None:
    it, navigation = world()
    first = driven(navigation, *FAR)
    it.step(3.0)
    second = driven(navigation, *NEAR)
    assert (first.status, second.status) == (ABORTED, EXECUTING)
    finish(it, second)
    assert second.status == SUCCEEDED


def test_of_two_navigators_the_second_is_accepted_and_aborted_at_once() -> None:
    it, navigation = world()
    first = driven(navigation, *FAR)
    it.step(1.0)
    second = given_to(navigation, THROUGH, {"poses": [stamped(Pose(*NEAR))], "behavior_tree": ""})
    assert (first.status, second.status) == (EXECUTING, ABORTED)
    finish(it, first)
    third = given_to(navigation, THROUGH, {"poses": [stamped(Pose(*NEAR)), stamped(Pose(*FAR))]})
    finish(it, third)
    assert third.status == SUCCEEDED and (navigation.robot.pose.x, navigation.robot.pose.y) == FAR


def test_waypoints_are_driven_to_as_goals_of_their_own() -> None:
    it, navigation = world()
    tour = given_to(navigation, WAYPOINTS, waypoints(NEAR, (8.0, 7.0)))
    it.step(0.1)
    (leg,) = navigation.servers[TO_POSE].running
    finish(it, leg)
    assert not tour.over
    finish(it, tour)
    assert (tour.status, tour.result["missed_waypoints"]) == (SUCCEEDED, [])


def test_an_intruder_costs_a_waypoint_and_is_replaced_by_the_next() -> None:
    it, navigation = world()
    tour = given_to(navigation, WAYPOINTS, waypoints(FAR, NEAR))
    it.step(2.0)
    intruder = driven(navigation, 0.0, 7.0)
    it.step(0.2)
    assert intruder.status == ABORTED
    finish(it, tour)
    (missed,) = tour.result["missed_waypoints"]
    assert tour.status == SUCCEEDED and missed["index"] == 0
    assert (navigation.robot.pose.x, navigation.robot.pose.y) == NEAR


def test_cancelled_waypoints_cancel_their_leg() -> None:
    it, navigation = world()
    tour = given_to(navigation, WAYPOINTS, waypoints(FAR, NEAR))
    it.step(2.0)
    (leg,) = navigation.servers[TO_POSE].running
    navigation.servers[WAYPOINTS].cancel(NO_ROBOTS, 0)
    it.step(0.2)
    assert (tour.status, leg.status) == (CANCELED, CANCELED)
    assert not navigation.robot.driving


@pytest.mark.parametrize(
    ("spot", "code"), [((-99.0, 3.0), 204), ((math.nan, 3.0), 204), ((4.0, 3.5), 208), ((37.4, 10.0), 206)]
)
def test_a_goal_without_a_way_is_aborted_with_the_planners_code(spot: tuple[float, float], code: int) -> None:
    it, navigation = world()
    goal = driven(navigation, *spot)
    assert goal.status == EXECUTING
    finish(it, goal, 1.0)
    assert (goal.status, goal.result["error_code"]) == (ABORTED, code)
    assert "failed to plan" in goal.result["error_msg"]


def test_who_gets_nowhere_tries_and_gives_up() -> None:
    it, navigation = world()
    goal = driven(navigation, *FAR)
    it.step(5.0)
    assert navigation.robot.time_remaining > 0.0
    navigation.robot.block()
    it.step(15.0)
    assert (navigation.robot.recoveries, navigation.robot.time_remaining) == (1, 0.0)
    assert navigation.robot.distance_remaining > 1.0
    finish(it, goal, 40.0)
    assert (goal.status, goal.result["error_code"]) == (ABORTED, 105)


def test_the_next_goal_is_rejected_and_a_drive_aborted_on_request() -> None:
    it, navigation = world()
    navigation.reject = 1
    assert navigation.give(*FAR) is None
    goal = driven(navigation, *FAR)
    it.step(1.0)
    navigation.abort(106, "no valid control")
    finish(it, goal, 1.0)
    assert goal.result == {"error_code": 106, "error_msg": "no valid control"}
    assert len(navigation.received) == 2


def test_it_docks_and_charges() -> None:
    it, navigation = world()
    goal = given_to(navigation, DOCK, {"use_dock_id": True, "dock_id": "charger"})
    finish(it, goal)
    assert goal.status == SUCCEEDED and goal.result["success"] and navigation.robot.docked
    before = navigation.robot.battery
    it.step(2.0)
    assert navigation.robot.battery > before


SPOTS = st.sampled_from([FAR, NEAR, (0.0, 7.0), (17.0, 13.0), (-99.0, 0.0), (4.0, 3.5)])
VERBS = st.sampled_from([TO_POSE, THROUGH, WAYPOINTS, DOCK])
DEEDS = st.lists(
    st.one_of(
        st.tuples(st.just("give"), VERBS, st.lists(SPOTS, max_size=3)),
        st.tuples(st.just("cancel"), VERBS, st.booleans()),
        st.tuples(st.just("wait"), st.just(""), st.floats(0.0, 20.0)),
    ),
    max_size=12,
)


@given(DEEDS)
def test_whatever_is_asked_goals_only_get_on(deeds: list[tuple[str, str, Any]]) -> None:
    it, navigation = world()
    told: dict[bytes, list[int]] = {}
    for deed, verb, what in deeds:
        if deed == "wait":
            it.step(what)
        elif deed == "cancel":
            navigation.servers[verb].cancel(NO_ROBOTS, 0 if what else 10**18)
        elif verb == TO_POSE:
            navigation.give(*(what[0] if what else NEAR))
        else:
            navigation.take(verb, waypoints(*what))
        assert sum(len(navigation.servers[one].running) for one in (TO_POSE, THROUGH)) <= 1
        for server in navigation.servers.values():
            while server.reports:
                for id_, _, status in server.reports.popleft():
                    told.setdefault(id_, []).append(status)
    for seen in told.values():
        assert seen[0] == 1 and all(before <= after for before, after in pairwise(seen))
        assert len({status for status in seen if status >= SUCCEEDED}) <= 1
