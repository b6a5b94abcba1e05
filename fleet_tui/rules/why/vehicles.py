"""Reasons to stand still of vehicles of a master control: stopped, faulty, or waiting for it."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.model.vehicles.vehicle import HIGH, Vehicle
from fleet_tui.rules.alarms.classes import CLASSES
from fleet_tui.rules.alarms.vehicles import LOCALISE, fault_remedy, fault_text, sorted_errors
from fleet_tui.rules.why.reason import LOOK_AT, Reason, Strength
from fleet_tui.situation.motion import action_text, running_action


def _reading(state: FleetState, robot: Robot) -> Reading[Vehicle] | None:
    return robot.vehicle if state.is_fresh(robot, "vehicle") else None


def stopped(state: FleetState, robot: Robot) -> Reason | None:
    """Report an active emergency stop."""
    reading = _reading(state, robot)
    if reading is None or not reading.value.e_stop:
        return None
    text, go = reading.value.e_stop_text, CLASSES["e-stop"].action
    return Reason(text, "reported by the vehicle", seen=reading.at, keys=LOOK_AT, remedy=go)


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


def faulty(state: FleetState, robot: Robot) -> Reason | None:
    """Report the errors of a vehicle: only the worst level means that it can't drive."""
    reading = _reading(state, robot)
    if reading is None or not reading.value.errors:
        return None
    worst = sorted_errors(reading.value)[0]
    strength = Strength.CERTAIN if worst.level in HIGH else Strength.POSSIBLE
    evidence, remedy = fault_text(reading.value), fault_remedy(reading.value)
    return Reason(worst.type, evidence, strength, seen=reading.at, keys=LOOK_AT, remedy=remedy)


def acts(state: FleetState, robot: Robot) -> Reason | None:
    """Report the action of its order that it carries out where it stands."""
    action = running_action(state, robot)
    if action is None or robot.vehicle is None:
        return None
    text = action_text(state, action)
    return Reason(text, "reported by the vehicle", since=action.since, seen=robot.vehicle.at)


def unlocalised(state: FleetState, robot: Robot) -> Reason | None:
    """Report that it does not know its place."""
    reading = _reading(state, robot)
    if reading is None or reading.value.localised is not False:
        return None
    keys = ("pose", *LOOK_AT)
    return Reason("not localised", "reported by the vehicle", seen=reading.at, keys=keys, remedy=LOCALISE)


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


VEHICLE_REASONS = (stopped, by_hand, faulty, acts, clearance, unlocalised, map_disabled)
