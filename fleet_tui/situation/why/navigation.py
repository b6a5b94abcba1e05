"""Reasons to stand still of navigating robots: blocked, lost, recovering, orders held here."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation import blocked_text
from fleet_tui.model.robot import Robot
from fleet_tui.orders.local_queue import orders_to_save
from fleet_tui.situation.causes import HELD_FAST
from fleet_tui.situation.localisation import uncertain
from fleet_tui.situation.navigation import inactive, silent_navigation
from fleet_tui.situation.robots import adrift, drives_on
from fleet_tui.situation.why.reason import LOOK_AT, Reason, Strength, mission, reason_of
from fleet_tui.text.language import EMPTY, Message, counted


def blocked(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its collision monitor holds it back."""
    if robot.blocked is None or not robot.blocked.value.action:
        return None
    found, fresh = robot.blocked.value, state.is_fresh(robot, "blocked")
    zone = Message(" in {polygon}", polygon=found.polygon) if found.polygon else EMPTY
    strength = Strength.CERTAIN if fresh and found.is_stopped else Strength.POSSIBLE
    cause = Message("collision monitor triggered{zone}", zone=zone)
    if robot.vehicle is not None:
        cause = Message("{polygon} violated", polygon=found.polygon)
    return Reason(
        blocked_text(found, state.now),
        Message("{cause}: clear the path at the robot", cause=cause),
        strength,
        since=found.since,
        seen=robot.blocked.at,
        keys=(*LOOK_AT, "cancel") if robot.orders.open else LOOK_AT,
    )


def not_sure_where(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its localisation is uncertain."""
    fact = uncertain(robot)
    return None if fact is None else reason_of(fact, Strength.LIKELY)


def estimated(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its localisation is silent while its wheels count on."""
    fact = adrift(state, robot)
    return None if fact is None else reason_of(fact, Strength.LIKELY)


def still_driving(state: FleetState, robot: Robot) -> Reason | None:
    """Report that it drives on without the order that failed."""
    fact = drives_on(state, robot)
    return None if fact is None else reason_of(fact, since=fact.since)


def not_active(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its navigation is not active, and what it waits for."""
    fact = inactive(state, robot)
    return None if fact is None else reason_of(fact, since=fact.since)


def silent(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its navigation says nothing of the current order any more."""
    fact = silent_navigation(state, robot)
    return None if fact is None else reason_of(fact, Strength.LIKELY, fact.since)


def recovering(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its navigation repeatedly tries to recover."""
    current = robot.orders.current
    if robot.progress is None or current is None or not robot.progress.value.recoveries:
        return None
    count = robot.progress.value.recoveries
    evidence = counted(
        "{count} recovery during {mission}",
        "{count} recoveries during {mission}",
        count,
        mission=mission(robot, current),
    )
    seen, keys = robot.progress.at, (*LOOK_AT, "cancel", "diagnostics")
    return Reason(
        Message("recovering"), evidence, Strength.LIKELY, seen=seen, keys=keys, remedy=HELD_FAST, page="log"
    )


def held(state: FleetState, robot: Robot) -> Reason | None:
    """Report that orders are held here for the operator."""
    kept = sum(1 for _ in orders_to_save(state, robot))
    if not kept or not robot.held:
        return None
    evidence = counted(
        "{count} order waiting here: resume to continue",
        "{count} orders waiting here: resume to continue",
        kept,
    )
    return Reason(Message("held: {held}", held=robot.held), evidence, Strength.CERTAIN, keys=("resume",))


NAVIGATION_REASONS = (blocked, not_active, held, silent, not_sure_where, recovering)
