"""Facts that a vehicle of a master control reports about itself, by its last state."""

from collections.abc import Callable

from fleet_tui.model.alarm import Priority
from fleet_tui.model.robot import Robot
from fleet_tui.model.vehicles.vehicle import HIGH, MEDIUM, VehicleError
from fleet_tui.situation.fact import Fact, FactKind
from fleet_tui.situation.facts import BY_HAND, CLEARANCE, E_STOP, FAULT, MAP_DISABLED, UNLOCALISED
from fleet_tui.text.language import Message, counted, joined, verbatim
from fleet_tui.text.sanitize import sanitize

REPORTED = Message("reported by the vehicle")


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
    text = verbatim(f"{first.level.lower()} {told}" if first.level else told)
    if more:
        text = Message("{text}, and {count} more", text=text, count=len(more))
    fact = _reported(robot, FAULT, text, _priority_of(first))
    return fact._replace(
        remedy=sanitize(verbatim(first.hint)),
        short=verbatim(first.type),
        evidence=text,
        is_certain=first.level in HIGH,
        parts=frozenset(error.type for error in (first, *more)),
    )


def unlocalised(robot: Robot) -> Fact | None:
    """Find that a vehicle does not know its place."""
    if robot.vehicle is None or robot.vehicle.value.localised is not False:
        return None
    return _reported(robot, UNLOCALISED, UNLOCALISED.word, Priority.MEDIUM)


def by_hand(robot: Robot) -> Fact | None:
    """Find a mode in which no master control drives it."""
    if robot.vehicle is None or robot.vehicle.value.takes_orders:
        return None
    text = Message("mode {mode_text}", mode_text=robot.vehicle.value.mode_text)
    return _reported(robot, BY_HAND, text, Priority.LOW)._replace(evidence=Message("it takes no orders"))


def clearance(robot: Robot) -> Fact | None:
    """Find that it may not drive on until its master control releases the next nodes, or grants a request."""
    if robot.vehicle is None or not robot.vehicle.value.waits:
        return None
    left = robot.vehicle.value.horizon
    asked = joined(", ", robot.vehicle.value.asks)
    fact = _reported(robot, CLEARANCE, CLEARANCE.word, Priority.LOW)
    if asked:
        remedy = Message("Check the master control: it has to grant the vehicle's request")
        return fact._replace(
            evidence=Message("it asks its master control for {asked}", asked=asked), remedy=remedy
        )
    if not left:
        return fact._replace(evidence=Message("it asks its master control for more of its route"))
    evidence = counted(
        "at the end of the released route, {count} node of its order not released",
        "at the end of the released route, {count} nodes of its order not released",
        left,
    )
    return fact._replace(evidence=evidence)


def map_disabled(robot: Robot) -> Fact | None:
    """Find that the map of its position is not among those that it uses: that need not be what holds it."""
    if robot.vehicle is None or not robot.vehicle.value.map_off:
        return None
    used = ", ".join(robot.vehicle.value.maps)
    text = Message("map {map_off} is not enabled", map_off=robot.vehicle.value.map_off)
    evidence = (
        Message("the vehicle uses {used}", used=used)
        if used
        else Message("the vehicle uses none of its maps")
    )
    return _reported(robot, MAP_DISABLED, text, Priority.LOW)._replace(evidence=evidence, is_certain=False)


def _reported(robot: Robot, kind: FactKind, text: Message, priority: Priority) -> Fact:
    assert robot.vehicle is not None
    at = robot.vehicle.at
    return Fact(kind, robot.name, text, priority, at, short=text, evidence=REPORTED, seen=at)


def _priority_of(error: VehicleError) -> Priority:
    if error.level in HIGH:
        return Priority.HIGH
    return Priority.MEDIUM if error.level in MEDIUM else Priority.LOW


FINDERS: tuple[Callable[[Robot], Fact | None], ...] = (
    emergency_stop,
    fault,
    by_hand,
    clearance,
    unlocalised,
    map_disabled,
)
"""The likeliest cause of standing still first."""
