"""What robots themselves say they do: it comes before any guess from their poses."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.model.vehicles.vehicle import CurrentAction, Vehicle
from fleet_tui.text.durations import age

CRAWLS = 0.05
"""Metres per second above which a vehicle that only tells its speed drives."""


def _fresh(state: FleetState, robot: Robot) -> Vehicle | None:
    if robot.vehicle is None or not state.is_fresh(robot, "vehicle"):  # asked of every robot in every tick
        return None
    return robot.vehicle.value


def says_driving(state: FleetState, robot: Robot) -> bool | None:
    """Return what a robot says of its movement, None if it says nothing that still holds."""
    vehicle = _fresh(state, robot)
    if vehicle is None:
        return None
    if vehicle.driving is None and vehicle.speed is not None:
        return vehicle.speed > CRAWLS
    return vehicle.driving


def running_action(state: FleetState, robot: Robot) -> CurrentAction | None:
    """Return the action of its order that a robot carries out while it stands."""
    is_busy = robot.acting is not None and says_driving(state, robot) is not True
    return robot.acting if is_busy and _fresh(state, robot) is not None else None


def action_text(state: FleetState, current: CurrentAction) -> str:
    """Return an action with the time that it has taken so far, as far as that was seen."""
    text = f"{current.action.type or 'action'}, {age(state.now - current.since)}"
    return text if current.is_begin_seen else f"{text} (seen)"
