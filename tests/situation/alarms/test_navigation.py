"""Alarms of navigating robots: blocked for long, lost on the map, orders held or failed."""

from msgspec.structs import replace

from fleet_tui.model.alarm import Condition, Priority, class_of
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation import Blocked
from fleet_tui.model.order import Order, Stop, at_vertices
from fleet_tui.model.order_life import GoneOrder
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.orders.local_queue import ANOTHER_CLIENT
from fleet_tui.situation.alarms.classes import CLASSES, action_of
from fleet_tui.situation.alarms.conditions import stop
from fleet_tui.situation.alarms.navigation import NO_POSE_AFTER, failed_order, held_orders, not_sure_where
from fleet_tui.situation.causes import HELD_FAST
from fleet_tui.situation.facts import NO_POSE
from fleet_tui.situation.failures import FAILED_FOR
from fleet_tui.situation.localisation import FOUND_BELOW, LOST_ABOVE
from fleet_tui.situation.navigation import NO_ODOMETRY
from fleet_tui.situation.why.robot import stale_pose
from fleet_tui.text.language import EMPTY, Message
from tests.support.fleets import (
    R0,
    T0,
    battery,
    commanded,
    fleet,
    link_up,
    of_kinds,
    place_order,
    pose,
    reduced,
    tick,
)

KEEPS = Kind("keeps", keeps_goals=True)


def known(state: FleetState | None = None, **values: object) -> tuple[FleetState, Robot]:
    state = state or reduced(fleet(), pose(T0), tick(T0))
    return state, replace(state.robots[R0], **values)


def test_a_stop_is_due_after_the_limit_from_its_first_report_and_slowing_down_is_none() -> None:
    state, robot = known(blocked=Reading(Blocked("stop", "front", T0 - 4), T0))
    found = stop(state, robot, {})
    assert found is not None
    assert (found.text, found.due) == ("blocked 4.0 s (seen)", T0 - 4 + state.limits.obstacle_after)
    for action in ("slowdown", ""):
        assert stop(*known(blocked=Reading(Blocked(action, "front", T0 - 4), T0)), {}) is None


def test_a_localisation_between_the_limits_stays_what_it_was() -> None:
    held = {(R0, "localisation"): Condition(R0, "localisation", Priority.MEDIUM, EMPTY, EMPTY)}
    between = (LOST_ABOVE + FOUND_BELOW) / 2
    for variance, before, after in (
        (LOST_ABOVE + 0.1, False, True),
        (between, False, False),
        (between, True, True),
        (FOUND_BELOW, True, False),
    ):
        found = not_sure_where(*known(variance=Reading(variance, T0)), held if before else {})
        assert (found is not None) is after
    lost = not_sure_where(*known(variance=Reading(1.0, T0)), {})
    assert lost is not None and lost.text == "localisation uncertain: within 2.0 m"


def test_a_robot_that_speaks_and_never_had_a_pose_is_an_alarm_after_the_delay_of_an_offline_one() -> None:
    begun = reduced(fleet(), link_up(T0), battery(T0), tick(T0))
    assert not_sure_where(*known(begun), {}) is not None and not begun.alarms
    late = T0 + begun.limits.offline_after
    soon = reduced(begun, battery(late), tick(late - 0.1))
    assert not [alarm for alarm in soon.alarms if alarm.key == (R0, "localisation")]
    later = reduced(soon, battery(late + 1), tick(late + 1))
    assert [alarm.text for alarm in later.alarms] == ["pose missing"]
    found = reduced(later, pose(late + 2), tick(late + 2), battery(late + 6), pose(late + 6), tick(late + 6))
    assert not found.alarms
    none_promised = of_kinds(begun, Kind(reports=("battery",)))
    assert not_sure_where(*known(none_promised), {}) is None


def test_poses_that_cease_while_the_robot_speaks_are_an_alarm_until_they_come_again() -> None:
    begun = reduced(fleet(), link_up(T0), pose(T0), battery(T0))
    later = reduced(begun, battery(T0 + 40), tick(T0 + 40))
    found = not_sure_where(*known(later), {})
    assert found is not None and (found.text, found.due) == ("pose 40 s old", T0 + NO_POSE_AFTER)
    assert not_sure_where(*known(reduced(later, pose(T0 + 41), tick(T0 + 41))), {}) is None
    silent = reduced(later, tick(T0 + 99))
    assert not_sure_where(*known(silent), {}) is None, "then it is offline"
    held = {(R0, "localisation"): found}
    assert not_sure_where(*known(silent), held) is not None, "offline is no recovery"
    moves_only = of_kinds(begun, Kind(reports=("pose",), silence={"pose": float("inf")}))
    assert not_sure_where(*known(reduced(moves_only, battery(T0 + 40), tick(T0 + 40))), {}) is None


def test_a_robot_placed_by_odometry_that_sends_none_is_looked_for_there() -> None:
    place = Pose(0.0, 0.0)
    known_place = {"located": place, "odometry_at": T0}
    by_wheels = of_kinds(fleet(), Kind(reports=("pose",), odometry_topic="/{robot}/odom"))
    state = reduced(by_wheels, link_up(T0), pose(T0), battery(T0 + 40), tick(T0 + 40))
    found = not_sure_where(*known(state, **known_place), {})
    assert found is not None and action_of(found) == NO_ODOMETRY
    reason = stale_pose(*known(state, **known_place))
    assert reason is not None and reason.remedy == NO_ODOMETRY
    assert reason.evidence == "no odometry on /robot_0/odom: the robot may have moved since"
    for other in (
        {"odometry_at": T0 + 40, "located": Pose(0.0, 0.0)},
        {"odometry_at": None, "located": None},
    ):
        found, reason = not_sure_where(*known(state, **other), {}), stale_pose(*known(state, **other))
        assert found is not None and reason is not None
        assert action_of(found) == reason.remedy == NO_POSE.action


def test_held_orders_are_counted_and_those_held_by_others_matter_more() -> None:
    orders = (commanded(n, place_order(R0, 1), Stage.WAITING) for n in range(2))
    state = reduced(of_kinds(fleet(), KEEPS), *(fact for order in orders for fact in order))
    found = held_orders(*known(state, held="previous order: failed"), {})
    assert found is not None and found.priority is Priority.LOW
    assert found.text == "previous order: failed: 2 orders waiting here, resume to continue"
    other = held_orders(*known(state, held=ANOTHER_CLIENT), {})
    assert other is not None and other.priority is Priority.MEDIUM
    assert other.over == "no orders held", "also where they were cleared or replaced"
    assert held_orders(*known(held=ANOTHER_CLIENT), {}) is None and held_orders(*known(state), {}) is None


def failed(stage: Stage = Stage.FAILED, at: float = T0, stops: tuple[Stop, ...] = ()) -> GoneOrder:
    return GoneOrder(Order("7", stops, None, "", 1), at, stage, Message("aborted by the robot"))


def test_an_order_of_another_client_that_failed_is_told_for_a_while() -> None:
    found = failed_order(*known(gone=(failed(),)), {})
    assert found is not None
    assert (found.kind, found.text) == ("order", "order 7 failed: aborted by the robot")
    assert class_of(found.kind) == "command"
    found = failed_order(*known(gone=(failed(stops=at_vertices("1", "2")),)), {})
    assert found is not None and found.text == "order 1 -> 2 failed: aborted by the robot"
    assert action_of(found) == CLASSES["command"].action
    stuck = failed_order(*known(gone=(replace(failed(), reason="Failed to make progress"),)), {})
    assert stuck is not None and action_of(stuck) == HELD_FAST
    assert failed_order(*known(gone=(failed(at=T0 - FAILED_FOR),)), {}) is None
    assert failed_order(*known(gone=(failed(), failed(Stage.DONE))), {}) is None
    assert failed_order(*known(), {}) is None


def test_an_order_of_this_console_that_failed_is_its_command() -> None:
    ours = reduced(fleet(), *commanded(1, place_order(R0, 1, 2), Stage.SENT), tick(T0))
    record = replace(ours.commands[0], order_id="7")
    assert failed_order(*known(replace(ours, commands=(record,)), gone=(failed(),)), {}) is None
