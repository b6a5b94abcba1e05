"""Goals of action servers as the orders of a robot: legs, replaced ones, ends, and whose each is."""

from msgspec.structs import replace

from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage
from fleet_tui.model.events import SubscriptionsAdvanced
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Progress
from fleet_tui.model.navigation_events import GoalAnswered, OdometryReported, PlanReported, ProgressReported
from fleet_tui.model.order import OrderState, Stop, at_vertices
from fleet_tui.orders.goals import LISTED_FOR
from fleet_tui.orders.local_queue import foreign
from fleet_tui.text.language import Message
from tests.support.fleets import LINK, R0, T0, commanded, reduced, tick
from tests.support.nav2_goals import (
    DONE,
    FAILED,
    ON,
    WAYPOINTS,
    goal,
    goals,
    localised,
    nav2,
    odometry,
    robot,
)

B, A_B = PlaceOrder(R0, at_vertices("2")), PlaceOrder(R0, at_vertices("1", "2"))
SENT = (Stage.SENT,)


def listed(state: FleetState) -> list[tuple[str, OrderState | None]]:
    return [(one.id, one.state) for one in robot(state).orders.orders]


def record(state: FleetState, id_: int = 7) -> CommandRecord:
    return next(one for one in state.commands if one.id == id_)


def test_goals_of_one_action_after_the_other_are_a_queue() -> None:
    state = reduced(nav2(), goals(T0, goal("a")), goals(T0 + 1, goal("a", DONE), goal("b")))
    assert listed(state) == [("a", DONE), ("b", ON)]
    assert robot(state).orders.current_id == "b"


def test_a_first_leg_that_is_listed_before_its_tour_is_no_lost_order() -> None:
    state = reduced(nav2(), goals(T0, goal("leg", stamp=T0)))
    state = reduced(state, goals(T0 + 0.1, goal("tour", stamp=T0), action=WAYPOINTS))
    assert listed(state) == [("tour", ON)] and not robot(state).gone
    state = reduced(state, goals(T0 + 9, goal("leg", DONE), goal("leg 2", stamp=T0 + 9)))
    state = reduced(state, goals(T0 + 20, goal("tour", DONE), action=WAYPOINTS))
    assert [(one.order.id, one.stage) for one in robot(state).gone] == [("tour", Stage.DONE)]


def test_a_goal_listed_while_other_topics_are_still_subscribed_is_not_lost() -> None:
    state = reduced(nav2(), goals(T0 + 1, goal("a")), SubscriptionsAdvanced(LINK, T0 + 4, 9, 9))
    state = reduced(state, odometry(T0 + 15), tick(T0 + 15))
    assert listed(state) == [("a", ON)] and not robot(state).gone


def test_what_had_ended_before_we_came_is_no_order() -> None:
    state = reduced(nav2(), goals(T0, goal("a", DONE), goal("b", FAILED), goal("c")))
    assert listed(state) == [("c", ON)]


def test_one_that_ended_stays_a_while_whatever_comes() -> None:
    state = reduced(nav2(), goals(T0, goal("a")), goals(T0 + 1, goal("a", DONE)))
    state = reduced(state, tick(T0 + LISTED_FOR))
    assert listed(state) == [("a", DONE)]
    state = reduced(state, tick(T0 + LISTED_FOR + 2))
    assert listed(state) == [] and robot(state).gone


def test_one_that_fails_as_a_newer_one_comes_was_replaced() -> None:
    state = reduced(nav2(), goals(T0, goal("a")), goals(T0 + 1, goal("a"), goal("b")))
    state = reduced(state, goals(T0 + 1.1, goal("a", FAILED), goal("b")))
    assert listed(state) == [("a", OrderState.REPLACED), ("b", ON)]
    state = reduced(state, goals(T0 + 2, goal("a", FAILED), goal("b", DONE)))
    assert listed(state)[0] == ("a", OrderState.REPLACED)


def test_one_that_failed_before_a_newer_one_came_has_failed() -> None:
    state = reduced(nav2(), goals(T0, goal("a")), goals(T0 + 1, goal("a", FAILED)))
    state = reduced(state, goals(T0 + 2, goal("a", FAILED), goal("b")))
    assert listed(state) == [("a", FAILED), ("b", ON)]


class TestLegs:
    def test_goals_that_a_tour_gives_are_no_orders(self) -> None:
        state = reduced(nav2(), goals(T0, goal("t", stamp=T0), action=WAYPOINTS))
        state = reduced(state, goals(T0 + 0.1, goal("l", stamp=T0 + 0.1)))
        assert listed(state) == [("t", ON)]
        state = reduced(state, goals(T0 + 3, goal("l", DONE, T0 + 0.1), goal("m", stamp=T0 + 3)))
        assert listed(state) == [("t", ON)]
        state = reduced(state, goals(T0 + 6, goal("t", DONE, T0), action=WAYPOINTS))
        assert listed(state) == [("t", DONE)]

    def test_a_leg_that_is_told_before_its_tour_was_no_order_of_ours(self) -> None:
        state = reduced(nav2(), *commanded(7, A_B, *SENT))
        state = reduced(state, goals(T0 + 0.1, goal("l", stamp=T0 + 0.1)), tick(T0 + 0.2))
        assert record(state).stage is Stage.SENT
        state = reduced(state, goals(T0 + 0.3, goal("t", stamp=T0), action=WAYPOINTS), tick(T0 + 0.4))
        assert (record(state).stage, record(state).order_id) == (Stage.CONFIRMED, "t")
        assert listed(state) == [("t", ON)]

    def test_a_goal_that_was_there_before_the_tour_is_none(self) -> None:
        state = reduced(nav2(), goals(T0, goal("a", stamp=T0 - 1)))
        state = reduced(state, goals(T0 + 1, goal("t", stamp=T0), action=WAYPOINTS))
        assert listed(state) == [("a", ON), ("t", ON)]

    def test_their_progress_is_that_of_the_tour(self) -> None:
        state = reduced(
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
        state = reduced(nav2(), goals(T0, goal("old", DONE)), *commanded(7, B, *SENT, at=T0 + 1))
        state = reduced(state, goals(T0 + 1.1, goal("old", DONE), goal("new")), tick(T0 + 1.2))
        assert (record(state).stage, record(state).order_id) == (Stage.CONFIRMED, "new")
        assert robot(state).orders.orders[0].stops == B.stops
        assert not foreign(state, robot(state))

    def test_of_two_new_ones_nobody_can_tell(self) -> None:
        state = reduced(nav2(), *commanded(7, B, *SENT))
        state = reduced(state, goals(T0 + 0.1, goal("a"), goal("b")), tick(T0 + 0.2))
        assert record(state).stage is Stage.SENT
        state = reduced(state, tick(T0 + 6))
        assert record(state).stage is Stage.NOT_CONFIRMED
        assert record(state).detail == "no answer; ambiguous: several new goals"
        assert {one.id for one in foreign(state, robot(state))} == {"a", "b"}

    def test_one_that_was_there_but_comes_late_is_not_ours_by_its_stamp(self) -> None:
        state = reduced(nav2(), *commanded(7, B, *SENT, at=T0 + 30))
        state = reduced(
            state, odometry(T0 + 30), goals(T0 + 30.1, goal("old", stamp=T0 + 3)), tick(T0 + 30.2)
        )
        assert record(state).stage is Stage.SENT
        state = reduced(state, goals(T0 + 31, goal("old", stamp=T0 + 3), goal("new", stamp=T0 + 30)))
        state = reduced(state, tick(T0 + 31.1))
        assert record(state).order_id == "new"

    def test_a_robot_whose_clock_is_wrong_is_compared_by_its_own(self) -> None:
        state = reduced(nav2(), OdometryReported(R0, T0 + 1, Pose(0, 0), 9e8))
        state = reduced(state, *commanded(7, B, *SENT, at=T0 + 2))
        state = reduced(state, OdometryReported(R0, T0 + 2, Pose(0, 0), 9e8 + 1))
        state = reduced(state, goals(T0 + 2.2, goal("new", stamp=9e8 + 1.1)), tick(T0 + 2.3))
        assert record(state).order_id == "new"

    def test_a_goal_of_a_tour_is_no_order_to_a_place_alone(self) -> None:
        state = reduced(nav2(), *commanded(7, B, *SENT))
        state = reduced(state, goals(T0 + 0.1, goal("t"), action=WAYPOINTS), tick(T0 + 0.2))
        assert record(state).stage is Stage.SENT


class TestEnds:
    def ours(self) -> FleetState:
        state = reduced(nav2(), *commanded(7, B, *SENT))
        return reduced(state, goals(T0 + 0.1, goal("a")), tick(T0 + 0.2))

    def test_status_then_result(self) -> None:
        state = reduced(self.ours(), goals(T0 + 5, goal("a", FAILED)), tick(T0 + 5.1))
        assert record(state).stage is Stage.CONFIRMED
        state = reduced(state, GoalAnswered(7, Stage.FAILED, T0 + 5.2, "error 208"), tick(T0 + 5.3))
        assert (record(state).stage, record(state).detail) == (Stage.FAILED, "error 208")

    def test_result_then_status(self) -> None:
        state = reduced(self.ours(), GoalAnswered(7, Stage.FAILED, T0 + 5, "error 208"), tick(T0 + 5.1))
        assert record(state).stage is Stage.CONFIRMED
        state = reduced(state, goals(T0 + 5.2, goal("a", FAILED)), tick(T0 + 5.3))
        assert (record(state).stage, record(state).detail) == (Stage.FAILED, "error 208")

    def test_without_a_result_the_status_decides_soon(self) -> None:
        state = reduced(self.ours(), goals(T0 + 5, goal("a", DONE)), tick(T0 + 5.5))
        assert record(state).stage is Stage.CONFIRMED
        state = reduced(state, tick(T0 + 6.1))
        assert (record(state).stage, record(state).detail) == (
            Stage.DONE,
            "order a: as reported by the robot",
        )

    def test_stops_that_were_missed_make_it_failed(self) -> None:
        state = reduced(self.ours(), GoalAnswered(7, Stage.FAILED, T0 + 5, Message("1 stop missed")))
        state = reduced(state, goals(T0 + 5.1, goal("a", DONE)), tick(T0 + 5.2))
        assert record(state).stage is Stage.FAILED

    def test_one_that_is_listed_no_more_is_lost_unless_its_result_tells(self) -> None:
        state = reduced(self.ours(), goals(T0 + 5), tick(T0 + 7))
        assert record(state).stage is Stage.LOST
        state = reduced(self.ours(), GoalAnswered(7, Stage.DONE, T0 + 5), goals(T0 + 5.1), tick(T0 + 7))
        assert record(state).stage is Stage.DONE

    def test_what_its_result_told_holds_against_a_status_that_comes_later(self) -> None:
        state = reduced(self.ours(), GoalAnswered(7, Stage.FAILED, T0 + 5, Message("1 stop missed")))
        state = reduced(state, goals(T0 + 5.1), tick(T0 + 7))
        assert record(state).stage is Stage.LOST
        state = reduced(state, goals(T0 + 8, goal("a", DONE)), tick(T0 + 8.1))
        assert (record(state).stage, record(state).detail) == (
            Stage.FAILED,
            "order a: 1 stop missed; corrects: lost",
        )

    def test_the_first_end_of_a_goal_holds(self) -> None:
        cancelled = replace(goal("a", OrderState.CANCELLED), word="cancelled")
        state = reduced(self.ours(), goals(T0 + 5, cancelled))
        state = reduced(state, goals(T0 + 6, replace(goal("a", DONE), word="succeeded")), tick(T0 + 7))
        (order,) = robot(state).orders.orders
        assert (order.state, order.word) == (OrderState.CANCELLED, "cancelled")

    def test_a_bad_entry_of_the_list_loses_no_order(self) -> None:
        state = reduced(self.ours(), goals(T0 + 5, fault="status_list[0]: bad"), tick(T0 + 7))
        assert record(state).stage is Stage.CONFIRMED and robot(state).last_fault == "status_list[0]: bad"
        state = reduced(state, goals(T0 + 8, goal("a", DONE)), tick(T0 + 10))
        assert record(state).stage is Stage.DONE

    def test_one_that_ends_between_two_looks_is_ours_all_the_same(self) -> None:
        state = reduced(nav2(), goals(T0), *commanded(7, B, *SENT))
        state = reduced(state, goals(T0 + 0.05, goal("a")), goals(T0 + 0.06, goal("a", DONE)), tick(T0 + 0.1))
        state = reduced(state, tick(T0 + 2))
        assert record(state).stage is Stage.DONE


def test_a_path_ends_at_the_vertex_that_is_near() -> None:
    state = reduced(nav2(), localised(T0, 0.0), odometry(T0), goals(T0, goal("a")))
    at_vertex = reduced(state, PlanReported(R0, T0 + 1, Pose(1.1, 0.2)))
    assert robot(at_vertex).orders.orders[0].stops == (Stop("2"),)
    elsewhere = reduced(state, PlanReported(R0, T0 + 1, Pose(1.1, 5.0)))
    assert robot(elsewhere).orders.orders[0].stops == (Stop(pose=Pose(1.1, 5.0)),)
