"""Goals of action servers as the orders of a robot: legs, replaced ones, ends, and whose each is."""

import math

import pytest
from msgspec.structs import replace

from fleet_tui.adapters.adapter import Site
from fleet_tui.adapters.nav2.adapter import Nav2
from fleet_tui.adapters.profile import Profile
from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal, Progress
from fleet_tui.model.navigation_events import (
    GoalAnswered,
    GoalsReported,
    LocalisationReported,
    OdometryReported,
    PlanReported,
    ProgressReported,
)
from fleet_tui.model.order import OrderState, Stop, at_vertices
from fleet_tui.model.robot import Robot
from fleet_tui.rules.commands.goals import LISTED_FOR
from fleet_tui.rules.commands.local_queue import foreign
from tests.support.fleets import F0, R0, T0, commanded, fleet, graph, link_up, tick, told

NAV2 = Nav2(Profile(kind="nav2"), Site()).kind
TO_POSE, WAYPOINTS = "navigate_to_pose", "follow_waypoints"
ON, DONE, FAILED, OFF = (
    OrderState.IN_PROCESS,
    OrderState.DONE,
    OrderState.FAILED,
    OrderState.CANCELLED,
)
B, A_B = PlaceOrder(R0, at_vertices("2")), PlaceOrder(R0, at_vertices("1", "2"))
SENT = (Stage.SENT,)


def unheard() -> FleetState:
    """A robot with Nav2 of which nothing has come."""
    state = fleet()
    return told(replace(state, robots={R0: replace(state.robots[R0], kind=NAV2)}), link_up(T0))


def nav2() -> FleetState:
    """A robot with Nav2 in the middle of its life, at T0."""
    return told(unheard(), graph(1, 2, 3), odometry(T0), tick(T0))


def odometry(at: float, x: float = 0.0, y: float = 0.0, yaw: float = 0.0) -> OdometryReported:
    return OdometryReported(R0, at, Pose(x, y, yaw), at)


def localised(at: float, x: float, y: float = 0.0, yaw: float = 0.0) -> LocalisationReported:
    return LocalisationReported(R0, at, Pose(x, y, yaw), "map", at, 0.01)


def goal(id_: str, state: OrderState | None = ON, stamp: float | None = None) -> Goal:
    return Goal(id_, f"uuid of {id_}", "", state, state.value if state else "?", stamp)


def goals(at: float, *listed: Goal, action: str = TO_POSE, fault: str = "") -> GoalsReported:
    return GoalsReported(
        R0, at, action, tuple(replace(one, action=action, leads=action == WAYPOINTS) for one in listed), fault
    )


def robot(state: FleetState) -> Robot:
    return state.robots[R0]


def listed(state: FleetState) -> list[tuple[str, OrderState | None]]:
    return [(one.id, one.state) for one in robot(state).orders.orders]


def record(state: FleetState, id_: int = 7) -> CommandRecord:
    return next(one for one in state.commands if one.id == id_)


def test_goals_of_one_action_after_the_other_are_a_queue() -> None:
    state = told(nav2(), goals(T0, goal("a")), goals(T0 + 1, goal("a", DONE), goal("b")))
    assert listed(state) == [("a", DONE), ("b", ON)]
    assert robot(state).orders.current_id == "b"


def test_what_had_ended_before_we_came_is_no_order() -> None:
    state = told(nav2(), goals(T0, goal("a", DONE), goal("b", FAILED), goal("c")))
    assert listed(state) == [("c", ON)]


def test_one_that_ended_stays_a_while_whatever_comes() -> None:
    state = told(nav2(), goals(T0, goal("a")), goals(T0 + 1, goal("a", DONE)))
    state = told(state, tick(T0 + LISTED_FOR))
    assert listed(state) == [("a", DONE)]
    state = told(state, tick(T0 + LISTED_FOR + 2))
    assert listed(state) == [] and robot(state).gone


def test_one_that_fails_as_a_newer_one_comes_was_replaced() -> None:
    state = told(nav2(), goals(T0, goal("a")), goals(T0 + 1, goal("a"), goal("b")))
    state = told(state, goals(T0 + 1.1, goal("a", FAILED), goal("b")))
    assert listed(state) == [("a", OrderState.REPLACED), ("b", ON)]
    state = told(state, goals(T0 + 2, goal("a", FAILED), goal("b", DONE)))
    assert listed(state)[0] == ("a", OrderState.REPLACED)


def test_one_that_failed_before_a_newer_one_came_has_failed() -> None:
    state = told(nav2(), goals(T0, goal("a")), goals(T0 + 1, goal("a", FAILED)))
    state = told(state, goals(T0 + 2, goal("a", FAILED), goal("b")))
    assert listed(state) == [("a", FAILED), ("b", ON)]


class TestLegs:
    def test_goals_that_a_tour_gives_are_no_orders(self) -> None:
        state = told(nav2(), goals(T0, goal("t", stamp=T0), action=WAYPOINTS))
        state = told(state, goals(T0 + 0.1, goal("l", stamp=T0 + 0.1)))
        assert listed(state) == [("t", ON)]
        state = told(state, goals(T0 + 3, goal("l", DONE, T0 + 0.1), goal("m", stamp=T0 + 3)))
        assert listed(state) == [("t", ON)]
        state = told(state, goals(T0 + 6, goal("t", DONE, T0), action=WAYPOINTS))
        assert listed(state) == [("t", DONE)]

    def test_a_leg_that_is_told_before_its_tour_was_no_order_of_ours(self) -> None:
        state = told(nav2(), *commanded(7, A_B, *SENT))
        state = told(state, goals(T0 + 0.1, goal("l", stamp=T0 + 0.1)), tick(T0 + 0.2))
        assert record(state).stage is Stage.SENT
        state = told(state, goals(T0 + 0.3, goal("t", stamp=T0), action=WAYPOINTS), tick(T0 + 0.4))
        assert (record(state).stage, record(state).order_id) == (Stage.CONFIRMED, "t")
        assert listed(state) == [("t", ON)]

    def test_a_goal_that_was_there_before_the_tour_is_none(self) -> None:
        state = told(nav2(), goals(T0, goal("a", stamp=T0 - 1)))
        state = told(state, goals(T0 + 1, goal("t", stamp=T0), action=WAYPOINTS))
        assert listed(state) == [("a", ON), ("t", ON)]

    def test_their_progress_is_that_of_the_tour(self) -> None:
        state = told(
            nav2(),
            goals(T0, goal("t"), action=WAYPOINTS),
            goals(T0, goal("l")),
            ProgressReported(R0, T0, Progress("t", stop=1)),
            ProgressReported(R0, T0, Progress("l", metres=4.0, recoveries=1)),
        )
        progress = robot(state).progress
        assert progress is not None
        assert progress.value == Progress("t", metres=4.0, recoveries=1, stop=1)


class TestWhose:
    """The one new goal since an order was sent is that order."""

    def test_the_one_new_goal_is_ours(self) -> None:
        state = told(nav2(), goals(T0, goal("old", DONE)), *commanded(7, B, *SENT, at=T0 + 1))
        state = told(state, goals(T0 + 1.1, goal("old", DONE), goal("new")), tick(T0 + 1.2))
        assert (record(state).stage, record(state).order_id) == (Stage.CONFIRMED, "new")
        assert robot(state).orders.orders[0].stops == B.stops
        assert not foreign(state, robot(state))

    def test_of_two_new_ones_nobody_can_tell(self) -> None:
        state = told(nav2(), *commanded(7, B, *SENT))
        state = told(state, goals(T0 + 0.1, goal("a"), goal("b")), tick(T0 + 0.2))
        assert record(state).stage is Stage.SENT
        state = told(state, tick(T0 + 6))
        assert record(state).stage is Stage.NOT_CONFIRMED
        assert record(state).words == "no answer; ambiguous: several new goals"
        assert {one.id for one in foreign(state, robot(state))} == {"a", "b"}

    def test_one_that_was_there_but_comes_late_is_not_ours_by_its_stamp(self) -> None:
        state = told(nav2(), *commanded(7, B, *SENT, at=T0 + 30))
        state = told(state, odometry(T0 + 30), goals(T0 + 30.1, goal("old", stamp=T0 + 3)), tick(T0 + 30.2))
        assert record(state).stage is Stage.SENT
        state = told(state, goals(T0 + 31, goal("old", stamp=T0 + 3), goal("new", stamp=T0 + 30)))
        state = told(state, tick(T0 + 31.1))
        assert record(state).order_id == "new"

    def test_a_robot_whose_clock_is_wrong_is_compared_by_its_own(self) -> None:
        state = told(nav2(), OdometryReported(R0, T0 + 1, Pose(0, 0), 9e8))
        state = told(state, *commanded(7, B, *SENT, at=T0 + 2))
        state = told(state, OdometryReported(R0, T0 + 2, Pose(0, 0), 9e8 + 1))
        state = told(state, goals(T0 + 2.2, goal("new", stamp=9e8 + 1.1)), tick(T0 + 2.3))
        assert record(state).order_id == "new"

    def test_a_goal_of_a_tour_is_no_order_to_a_place_alone(self) -> None:
        state = told(nav2(), *commanded(7, B, *SENT))
        state = told(state, goals(T0 + 0.1, goal("t"), action=WAYPOINTS), tick(T0 + 0.2))
        assert record(state).stage is Stage.SENT


class TestEnds:
    def ours(self) -> FleetState:
        state = told(nav2(), *commanded(7, B, *SENT))
        return told(state, goals(T0 + 0.1, goal("a")), tick(T0 + 0.2))

    def test_status_then_result(self) -> None:
        state = told(self.ours(), goals(T0 + 5, goal("a", FAILED)), tick(T0 + 5.1))
        assert record(state).stage is Stage.CONFIRMED
        state = told(state, GoalAnswered(7, Stage.FAILED, T0 + 5.2, "error 208"), tick(T0 + 5.3))
        assert (record(state).stage, record(state).words) == (Stage.FAILED, "order a: error 208")

    def test_result_then_status(self) -> None:
        state = told(self.ours(), GoalAnswered(7, Stage.FAILED, T0 + 5, "error 208"), tick(T0 + 5.1))
        assert record(state).stage is Stage.CONFIRMED
        state = told(state, goals(T0 + 5.2, goal("a", FAILED)), tick(T0 + 5.3))
        assert (record(state).stage, record(state).words) == (Stage.FAILED, "order a: error 208")

    def test_without_a_result_the_status_decides_soon(self) -> None:
        state = told(self.ours(), goals(T0 + 5, goal("a", DONE)), tick(T0 + 5.5))
        assert record(state).stage is Stage.CONFIRMED
        state = told(state, tick(T0 + 6.1))
        assert (record(state).stage, record(state).words) == (Stage.DONE, "order a: as reported by the robot")

    def test_stops_that_were_missed_make_it_failed(self) -> None:
        state = told(self.ours(), GoalAnswered(7, Stage.FAILED, T0 + 5, "1 stops missed"))
        state = told(state, goals(T0 + 5.1, goal("a", DONE)), tick(T0 + 5.2))
        assert record(state).stage is Stage.FAILED

    def test_one_that_is_listed_no_more_is_lost_unless_its_result_tells(self) -> None:
        state = told(self.ours(), goals(T0 + 5), tick(T0 + 7))
        assert record(state).stage is Stage.LOST
        state = told(self.ours(), GoalAnswered(7, Stage.DONE, T0 + 5), goals(T0 + 5.1), tick(T0 + 7))
        assert record(state).stage is Stage.DONE

    def test_a_bad_entry_of_the_list_loses_no_order(self) -> None:
        state = told(self.ours(), goals(T0 + 5, fault="status_list[0]: bad"), tick(T0 + 7))
        assert record(state).stage is Stage.CONFIRMED and robot(state).last_fault == "status_list[0]: bad"
        state = told(state, goals(T0 + 8, goal("a", DONE)), tick(T0 + 10))
        assert record(state).stage is Stage.DONE

    def test_one_that_ends_between_two_looks_is_ours_all_the_same(self) -> None:
        state = told(nav2(), goals(T0), *commanded(7, B, *SENT))
        state = told(state, goals(T0 + 0.05, goal("a")), goals(T0 + 0.06, goal("a", DONE)), tick(T0 + 0.1))
        state = told(state, tick(T0 + 2))
        assert record(state).stage is Stage.DONE


class TestPlacing:
    """Odometry, placed on the map by the localisation."""

    def place(self, *facts: Event) -> Pose | None:
        pose = robot(told(unheard(), *facts)).pose
        return pose.value if pose else None

    def test_without_a_localisation_it_lives_but_nobody_knows_where(self) -> None:
        state = told(nav2(), odometry(T0 + 1, 3.0), tick(T0 + 1))
        assert robot(state).pose is None and state.is_online(robot(state))

    def test_it_goes_on_by_its_wheels_from_where_it_was_found(self) -> None:
        turned = math.pi / 2
        facts = odometry(T0 + 1, 5.0), localised(T0 + 1, 10.0, 10.0, turned), odometry(T0 + 2, 7.0)
        found = self.place(*facts)
        assert found is not None
        assert (found.x, found.y, found.yaw) == pytest.approx((10.0, 12.0, turned))

    def test_a_localisation_that_comes_first_waits_for_the_wheels(self) -> None:
        assert self.place(localised(T0, 10.0), odometry(T0 + 1, 5.0)) == Pose(10.0, 0.0)

    def test_drift_is_taken_back(self) -> None:
        facts = odometry(T0, 0.0), localised(T0, 0.0), odometry(T0 + 9, 10.3), localised(T0 + 9, 10.0)
        assert self.place(*facts) == Pose(10.0, 0.0)
        assert self.place(*facts, odometry(T0 + 10, 11.3)) == pytest.approx(Pose(11.0, 0.0))

    def test_it_is_no_sign_of_life(self) -> None:
        state = told(nav2(), localised(T0 + 60, 1.0), tick(T0 + 60))
        assert not state.is_online(robot(state))

    def test_without_odometry_it_is_where_it_was_found(self) -> None:
        state = told(unheard(), localised(T0 + 1, 4.0), tick(T0 + 1))
        pose = robot(state).pose
        assert pose is not None and pose.value == Pose(4.0, 0.0) and robot(state).floor == F0

    def test_a_path_ends_at_the_vertex_that_is_near(self) -> None:
        state = told(nav2(), localised(T0, 0.0), odometry(T0), goals(T0, goal("a")))
        at_vertex = told(state, PlanReported(R0, T0 + 1, Pose(1.1, 0.2)))
        assert robot(at_vertex).orders.orders[0].stops == (Stop("2"),)
        elsewhere = told(state, PlanReported(R0, T0 + 1, Pose(1.1, 5.0)))
        assert robot(elsewhere).orders.orders[0].stops == (Stop(pose=Pose(1.1, 5.0)),)
