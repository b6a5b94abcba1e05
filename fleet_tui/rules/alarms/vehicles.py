"""Alarm rules for vehicles of a master control: their own errors, an emergency stop, a lost place."""

from fleet_tui.model.alarm import Condition, Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.model.vehicles.vehicle import HIGH, MEDIUM, Vehicle, VehicleError
from fleet_tui.rules.alarms.classes import CLASSES
from fleet_tui.rules.alarms.floods import ActiveConditions, was_active
from fleet_tui.text.sanitize import sanitize

LOCALISE = "Localise it at the vehicle: take it by hand to a place that it knows"


def _holds(state: FleetState, robot: Robot, active: ActiveConditions, kind: str) -> bool:
    """Tell whether its last state holds. An alarm that it began goes on when the vehicle is gone."""
    return state.is_fresh(robot, "vehicle") or was_active(active, robot.name, robot.link, kind)


def _reported(robot: Robot) -> Vehicle | None:
    return robot.vehicle.value if robot.vehicle is not None else None


def priority_of(error: VehicleError) -> Priority:
    """Return the priority of an error by its level."""
    if error.level in HIGH:
        return Priority.HIGH
    return Priority.MEDIUM if error.level in MEDIUM else Priority.LOW


def sorted_errors(vehicle: Vehicle) -> list[VehicleError]:
    """Return the errors of a vehicle, the most urgent first."""
    return sorted(vehicle.errors, key=lambda error: priority_of(error).value)


def fault_text(vehicle: Vehicle) -> str:
    """Return the most urgent error of a vehicle, and how many more there are. Its hint is the remedy."""
    first, *more = sorted_errors(vehicle)
    told = ": ".join(part for part in (first.type, first.text) if part)
    level = f"{first.level.lower()} " if first.level else ""
    return f"{level}{told}" + (f", and {len(more)} more" if more else "")


def fault_remedy(vehicle: Vehicle) -> str:
    """Return what to do about the most urgent error: its own hint, if it has one."""
    return sanitize(sorted_errors(vehicle)[0].hint) or CLASSES["fault"].action


def fault(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise for the errors that a vehicle reports about itself."""
    vehicle = _reported(robot)
    if vehicle is None or not vehicle.errors or not _holds(state, robot, active, "fault"):
        return None
    text, remedy, over = fault_text(vehicle), fault_remedy(vehicle), "no errors reported"
    priority = priority_of(sorted_errors(vehicle)[0])
    parts = frozenset(error.type for error in vehicle.errors)
    return Condition(robot.name, "fault", priority, text, over, parts=parts, remedy=remedy)


def emergency_stop(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise while an emergency stop is active."""
    vehicle = _reported(robot)
    if vehicle is None or not vehicle.e_stop or not _holds(state, robot, active, "e-stop"):
        return None
    return Condition(robot.name, "e-stop", Priority.HIGH, vehicle.e_stop_text, "e-stop released")


def unlocalised(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise for a vehicle that does not know its place."""
    vehicle = _reported(robot)
    if vehicle is None or vehicle.localised is not False or not _holds(state, robot, active, "localisation"):
        return None
    over = "localised again"
    return Condition(robot.name, "localisation", Priority.MEDIUM, "not localised", over, remedy=LOCALISE)


VEHICLE_RULES = (emergency_stop, fault, unlocalised)
