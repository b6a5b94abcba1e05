"""Reasons to stand still of vehicles of a master control: stopped, faulty, or waiting for it."""

from collections.abc import Callable
from functools import partial

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.model.vehicles.vehicle import Vehicle
from fleet_tui.rules.why.reason import Reason, Strength
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.motion import action_text, running_action
from fleet_tui.situation.vehicles import REPORTED, emergency_stop, fault, unlocalised


def _reading(state: FleetState, robot: Robot) -> Reading[Vehicle] | None:
    return robot.vehicle if state.is_fresh(robot, "vehicle") else None


def _told(find: Callable[[Robot], Fact | None], state: FleetState, robot: Robot) -> Reason | None:
    fact = find(robot) if state.is_fresh(robot, "vehicle") else None
    if fact is None:
        return None
    strength = Strength.CERTAIN if fact.is_certain else Strength.POSSIBLE
    keys, remedy = fact.kind.keys, fact.action
    return Reason(fact.short, fact.evidence, strength, seen=fact.seen, keys=keys, remedy=remedy)


def by_hand(state: FleetState, robot: Robot) -> Reason | None:
    """Report a mode in which no master control drives it."""
    reading = _reading(state, robot)
    if reading is None or reading.value.takes_orders:
        return None
    remedy = "Switch it to automatic at the vehicle"
    return Reason(f"mode {reading.value.mode_text}", "it takes no orders", seen=reading.at, remedy=remedy)


def clearance(state: FleetState, robot: Robot) -> Reason | None:
    """Report that it may not drive on until its master control releases the next nodes."""
    reading = _reading(state, robot)
    if reading is None or not reading.value.waits:
        return None
    left = reading.value.horizon
    evidence = f"at the end of what is released, {left} node{'s' * (left != 1)} of its order not released"
    if not left:
        evidence = "it asks its master control for more of its route"
    if asked := ", ".join(reading.value.asks):
        evidence = f"it asks its master control for {asked}"
    remedy = "Look at the master control: it releases the next nodes"
    if asked:
        remedy = "Look at the master control: it grants what the vehicle asks for"
    return Reason("waits for clearance", evidence, seen=reading.at, remedy=remedy)


def acts(state: FleetState, robot: Robot) -> Reason | None:
    """Report the action of its order that it carries out where it stands."""
    action = running_action(state, robot)
    if action is None or robot.vehicle is None:
        return None
    text = action_text(state, action)
    return Reason(text, REPORTED, since=action.since, seen=robot.vehicle.at)


def map_disabled(state: FleetState, robot: Robot) -> Reason | None:
    """Report that the map of its position is not among those that it uses."""
    reading = _reading(state, robot)
    if reading is None or not reading.value.map_off:
        return None
    used = ", ".join(reading.value.maps)
    evidence = f"the vehicle uses {used}" if used else "the vehicle uses none of its maps"
    remedy = "Let the master control enable the map (enableMap)"
    return Reason(
        f"map {reading.value.map_off} is not enabled",
        evidence,
        Strength.POSSIBLE,
        seen=reading.at,
        remedy=remedy,
    )


VEHICLE_REASONS = (
    partial(_told, emergency_stop),
    by_hand,
    partial(_told, fault),
    acts,
    clearance,
    partial(_told, unlocalised),
    map_disabled,
)
