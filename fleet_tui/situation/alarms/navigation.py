"""Alarm rules for navigating robots: lost on its map, silent, orders held or failed."""

from fleet_tui.model.alarm import Condition, Priority
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.orders.local_queue import HELD_BY_OTHERS, orders_to_save
from fleet_tui.situation.alarms.floods import ActiveConditions, was_active
from fleet_tui.situation.causes import cause_of_end, remedy_of
from fleet_tui.situation.facts import MISPLACED, UNCERTAIN
from fleet_tui.situation.failures import FAILED_FOR
from fleet_tui.situation.localisation import FOUND_BELOW, LOST_ABOVE, no_pose, uncertain
from fleet_tui.situation.navigation import inactive, silent_navigation
from fleet_tui.situation.pose_checks.misplaced import misplaced_for_long
from fleet_tui.situation.robots import absence, adrift, drives_on
from fleet_tui.text.language import Message, counted
from fleet_tui.text.units import age

STARTS_WITHIN = 10.0
"""Seconds in which a navigation becomes active by itself."""
ADRIFT_AFTER = 10.0
"""Seconds for which a robot may drive by its wheels alone."""
NO_POSE_AFTER = 30.0
"""Seconds without a pose from a robot that reports and had one, until it counts as driving unseen."""


def not_sure_where(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise if its localisation is too uncertain to drive by, or its poses are none, or ceased."""
    if (lost := _pose_lost(state, robot, active)) is not None:
        return lost
    if (fact := adrift(state, robot)) is not None:
        return fact.condition(fact.since + ADRIFT_AFTER)
    was_lost = was_active(active, robot.name, robot.link, UNCERTAIN.name)
    if (fact := uncertain(robot, FOUND_BELOW if was_lost else LOST_ABOVE)) is not None:
        return fact.condition()
    if (since := misplaced_for_long(state, robot)) is None or robot.misplaced is None:
        return None
    text = Message(
        "{word} for {age}: {fault}",
        word=MISPLACED.word,
        age=age(state.now - since),
        fault=Message(robot.misplaced.value),
    )
    return Condition(robot.name, MISPLACED.name, Priority.MEDIUM, text, MISPLACED.over)


def _pose_lost(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    fact = no_pose(state, robot) if robot.kind.expects("pose") else None
    if fact is None:
        return None
    if not state.is_online(robot):
        return fact.condition() if was_active(active, robot.name, robot.link, fact.kind.name) else None
    if robot.pose is None:
        return fact.condition(fact.since + state.patience(robot))
    fact = absence(state, robot) or fact
    return None if fact.priority is Priority.LOW else fact.condition(robot.pose.at + NO_POSE_AFTER)


def held_orders(state: FleetState, robot: Robot, _active: ActiveConditions) -> Condition | None:
    """Raise for orders held here until the operator releases them."""
    if not robot.held:
        return None
    kept = sum(1 for _ in orders_to_save(state, robot))
    if not kept:
        return None
    text = counted(
        "{held}: {count} order waiting here, resume to continue",
        "{held}: {count} orders waiting here, resume to continue",
        kept,
        held=robot.held,
    )
    priority = Priority.MEDIUM if robot.held in HELD_BY_OTHERS else Priority.LOW
    # Also by a clear, or by an order in their place.
    return Condition(robot.name, "held", priority, text, Message("no orders held"))


def silent(state: FleetState, robot: Robot, _active: ActiveConditions) -> Condition | None:
    """Raise while its navigation is not active, or once it says nothing of the current order any more."""
    if (fact := inactive(state, robot)) is not None:
        return fact.condition(fact.since + STARTS_WITHIN)
    fact = silent_navigation(state, robot)
    return None if fact is None else fact.condition()


def failed_order(state: FleetState, robot: Robot, _active: ActiveConditions) -> Condition | None:
    """Raise shortly after an order of another client failed: those of this console are commands."""
    last = robot.gone[-1] if robot.gone else None
    if last is None or last.stage is not Stage.FAILED or state.now - last.at >= FAILED_FOR:
        return None
    if any(record.order_id == last.order.id for record in state.commands):
        return None
    text = Message("{order_text} failed", order_text=robot.order_text(last.order))
    cause, parts = cause_of_end(robot, last), frozenset({last.order.id})
    found = Message("{text}: {cause}", text=text, cause=cause or Message("no reason reported"))
    fact = drives_on(state, robot)
    remedy = fact.action if fact is not None else remedy_of(cause)
    return Condition(robot.name, "order", Priority.MEDIUM, found, text, parts=parts, remedy=remedy)


NAVIGATION_RULES = (not_sure_where, silent, held_orders, failed_order)
