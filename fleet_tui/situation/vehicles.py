"""Facts that a vehicle of a master control reports about itself, by its last state."""

from collections.abc import Callable

from fleet_tui.model.alarm import Priority
from fleet_tui.model.robot import Robot
from fleet_tui.model.vehicles.vehicle import HIGH, MEDIUM, VehicleError
from fleet_tui.situation.fact import Fact, FactKind
from fleet_tui.situation.facts import E_STOP, FAULT, UNLOCALISED
from fleet_tui.text.sanitize import sanitize

REPORTED = "reported by the vehicle"


def emergency_stop(robot: Robot) -> Fact | None:
    """Find an active emergency stop."""
    if robot.vehicle is None or not robot.vehicle.value.e_stop:
        return None
    return _reported(robot, E_STOP, robot.vehicle.value.e_stop_text, Priority.HIGH)


def fault(robot: Robot) -> Fact | None:
    """Find the most urgent error, with how many more there are. Its hint is the remedy; only one of the worst
    level means that the vehicle can't drive."""
    if robot.vehicle is None or not robot.vehicle.value.errors:
        return None
    first, *more = sorted(robot.vehicle.value.errors, key=lambda error: _priority_of(error).value)
    told = ": ".join(part for part in (first.type, first.text) if part)
    level = f"{first.level.lower()} " if first.level else ""
    text = f"{level}{told}" + (f", and {len(more)} more" if more else "")
    fact = _reported(robot, FAULT, text, _priority_of(first))
    return fact._replace(
        remedy=sanitize(first.hint),
        short=first.type,
        evidence=text,
        is_certain=first.level in HIGH,
        parts=frozenset(error.type for error in (first, *more)),
    )


def unlocalised(robot: Robot) -> Fact | None:
    """Find that a vehicle does not know its place."""
    if robot.vehicle is None or robot.vehicle.value.localised is not False:
        return None
    return _reported(robot, UNLOCALISED, UNLOCALISED.word, Priority.MEDIUM)


def _reported(robot: Robot, kind: FactKind, text: str, priority: Priority) -> Fact:
    assert robot.vehicle is not None
    at = robot.vehicle.at
    return Fact(kind, robot.name, text, priority, at, short=text, evidence=REPORTED, seen=at)


def _priority_of(error: VehicleError) -> Priority:
    if error.level in HIGH:
        return Priority.HIGH
    return Priority.MEDIUM if error.level in MEDIUM else Priority.LOW


FINDERS: tuple[Callable[[Robot], Fact | None], ...] = (emergency_stop, fault, unlocalised)
