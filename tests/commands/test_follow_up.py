"""Orders under a name of this console's, whose stops it gives one after the other."""

from fleet_tui.model.commands import CancelOrder, ClearOrders, PauseRobot, PlaceOrder, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import OdometryReported, TargetReported
from fleet_tui.model.order import Stop, at_vertices
from fleet_tui.model.request import given_now
from fleet_tui.orders.local_queue import foreign, next_to_send, orders_to_save
from fleet_tui.text.language import Message
from tests.support.fleets import F0, R0, T0, reduced, tick
from tests.support.legs import A_B, DONE, FAILED, KIND, OFF, REFUSED, goal, goals, lived, record, sent, site


def test_an_order_is_recognised_by_its_name_alone() -> None:
    state = sent(site(), T0 + 1, "our-name")
    state = lived(state, T0 + 1.2, goal("another1"), goal("our-name"))
    assert record(state).stage is Stage.CONFIRMED and record(state).order_id == "our-name"
    assert [one.id for one in foreign(state, state.robots[R0])] == ["another1"]


def test_no_other_new_goal_is_taken_for_it() -> None:
    state = lived(sent(site(), T0 + 1, "our-name"), T0 + 1.2, goal("another1"))
    state = lived(state, T0 + 20, goal("another1"))
    assert record(state).stage is Stage.NOT_CONFIRMED
    assert record(state).detail == "no answer; no new goal seen"


def test_its_rejection_ends_it_with_the_robots_words() -> None:
    state = lived(sent(site(), T0 + 1, "our-name"), T0 + 1.2, goal("our-name", REFUSED, "not now"))
    assert (record(state).stage, record(state).detail) == (Stage.REFUSED, "not now")


def test_its_failure_is_told_in_the_robots_words() -> None:
    state = sent(site(), T0 + 1, "our-name", PlaceOrder(R0, at_vertices("2")))
    state = lived(state, T0 + 1.2, goal("our-name"))
    state = lived(state, T0 + 2.0, goal("our-name", FAILED, "Failed to find a valid plan"))
    assert record(state).stage is Stage.FAILED
    assert record(state).detail == "Failed to find a valid plan"


def test_each_stop_is_a_goal_of_its_own() -> None:
    assert given_now(A_B, KIND) == PlaceOrder(R0, at_vertices("1"))
    assert given_now(A_B, KIND, 1) == PlaceOrder(R0, at_vertices("2"))
    state = lived(sent(site(), T0 + 1, "goal---1"), T0 + 1.2, goal("goal---1"))
    assert [stops for _, stops in orders_to_save(state, state.robots[R0])] == [at_vertices("2")]
    state = lived(state, T0 + 2, goal("goal---1", DONE))
    assert (record(state).stage, record(state).leg) == (Stage.WAITING, 1)
    assert [stops for _, stops in orders_to_save(state, state.robots[R0])] == [at_vertices("2")]
    following = next_to_send(state, state.robots[R0])
    assert following is not None and following.id == 7
    state = lived(sent(state, T0 + 2.1, "goal---2"), T0 + 2.3, goal("goal---1", DONE), goal("goal---2"))
    assert record(state).stage is Stage.CONFIRMED and record(state).order_id == "goal---2"
    assert not list(orders_to_save(state, state.robots[R0]))
    state = lived(state, T0 + 4, goal("goal---2", DONE))
    assert record(state).stage is Stage.DONE


def test_an_order_that_fails_at_its_first_stop_goes_to_no_other() -> None:
    state = lived(sent(site(), T0 + 1, "goal---1"), T0 + 1.2, goal("goal---1"))
    state = lived(state, T0 + 2, goal("goal---1", FAILED))
    assert record(state).stage is Stage.FAILED and not list(orders_to_save(state, state.robots[R0]))


def test_what_is_cancelled_on_its_first_leg_goes_no_further() -> None:
    for command in (CancelOrder(R0, "goal---1"), ClearOrders(R0)):
        state = lived(sent(site(), T0 + 1, "goal---1"), T0 + 1.2, goal("goal---1"))
        state = reduced(
            state, CommandIssued(8, command, T0 + 1.5, T0), CommandAdvanced(8, Stage.SENT, T0 + 1.5)
        )
        state = lived(state, T0 + 2, goal("goal---1", OFF))
        assert record(state).stage is Stage.CANCELLED and not list(orders_to_save(state, state.robots[R0]))


def test_a_pause_keeps_the_leg() -> None:
    state = lived(sent(site(), T0 + 1, "goal---1"), T0 + 1.2, goal("goal---1"))
    state = lived(state, T0 + 2, goal("goal---1", DONE))
    state = lived(sent(state, T0 + 2.1, "goal---2"), T0 + 2.3, goal("goal---2"))
    pause = PauseRobot(R0)
    state = reduced(state, CommandIssued(8, pause, T0 + 3, T0), CommandAdvanced(8, Stage.SENT, T0 + 3))
    state = reduced(state, CommandAdvanced(8, Stage.ACCEPTED, T0 + 3, Message("no reply expected")))
    state = lived(state, T0 + 3.2, goal("goal---2", OFF))
    assert (record(state).stage, record(state).leg) == (Stage.WAITING, 1)
    assert next_to_send(state, state.robots[R0]) is None
    assert record(state, 8).stage is Stage.CONFIRMED


def test_a_paused_robot_that_is_pushed_is_still_paused() -> None:
    state = lived(sent(site(), T0 + 1, "goal---1"), T0 + 1.2, goal("goal---1"))
    pause = PauseRobot(R0)
    state = reduced(state, CommandIssued(8, pause, T0 + 3, T0), CommandAdvanced(8, Stage.SENT, T0 + 3))
    state = lived(reduced(state, CommandAdvanced(8, Stage.ACCEPTED, T0 + 3)), T0 + 3.2, goal("goal---1", OFF))
    for n in range(1, 6):
        state = lived(reduced(state, OdometryReported(R0, T0 + 3 + n, Pose(2.0 * n, 0.0), T0)), T0 + 3 + n)
    assert state.is_paused(state.robots[R0]) and next_to_send(state, state.robots[R0]) is None


def test_serials_never_start_over_though_lists_become_empty() -> None:
    state = lived(site(), T0 + 1, goal("first---"))
    state = lived(lived(state, T0 + 2, goal("first---", DONE)), T0 + 8)
    state = lived(state, T0 + 9, goal("second--"))
    (order,) = state.robots[R0].orders.open
    assert order.serial == 2


def test_a_goal_that_is_no_longer_listed_is_lost() -> None:
    state = lived(sent(site(), T0 + 1, "our-name"), T0 + 1.2, goal("our-name"))
    state = reduced(lived(state, T0 + 2), tick(T0 + 3))
    assert record(state).stage is Stage.LOST


def test_a_goal_whose_end_is_reported_after_it_was_lost_has_that_end() -> None:
    """Its link was away: the list that comes then has it no more, a later one has its end."""
    to_one = PlaceOrder(R0, at_vertices("2"))
    state = lived(sent(site(), T0 + 1, "our-name", to_one), T0 + 1.2, goal("our-name"))
    state = reduced(lived(state, T0 + 2), tick(T0 + 3))
    assert record(state).stage is Stage.LOST
    state = lived(state, T0 + 60, goal("our-name", DONE))
    assert record(state).stage is Stage.DONE
    assert record(state).detail == "order our-name: as reported by the robot; corrects: lost"


def test_a_stop_that_was_reached_is_not_the_end_of_a_lost_order() -> None:
    state = lived(sent(site(), T0 + 1, "our-name"), T0 + 1.2, goal("our-name"))
    state = reduced(lived(state, T0 + 2), tick(T0 + 3))
    state = lived(state, T0 + 60, goal("our-name", DONE))
    assert record(state).stage is Stage.LOST


def test_a_target_is_that_of_the_goal_that_begins() -> None:
    pose, at = Pose(10.0, 0.0), T0 + 1.05
    before = reduced(site(), goals(T0 + 1), TargetReported(R0, at, pose), goals(T0 + 1.3, goal("another1")))
    after = reduced(site(), goals(T0 + 1, goal("another1")), TargetReported(R0, at, pose))
    for state in (before, after):
        (order,) = state.robots[R0].orders.open
        assert order.stops and order.stops == _near(state, pose)


def _near(state: FleetState, pose: Pose) -> tuple[Stop, ...]:
    vertices = state.robots[R0].maps[F0].graph
    assert vertices is not None
    found = [one.id for one in vertices.vertices.values() if abs(one.x - pose.x) + abs(one.y - pose.y) < 0.5]
    return (Stop(found[0]),) if found else (Stop(pose=pose),)


def test_a_target_of_long_ago_is_nobodys() -> None:
    state = reduced(site(), TargetReported(R0, T0 + 0.5, Pose(1.0, 1.0)), goals(T0 + 1), goals(T0 + 2))
    state = reduced(state, goals(T0 + 3, goal("another1")))
    assert state.robots[R0].orders.open[0].stops == ()
    running = reduced(site(), goals(T0 + 1, goal("another1")), TargetReported(R0, T0 + 5, Pose(1.0, 1.0)))
    assert running.robots[R0].orders.open[0].stops == ()
