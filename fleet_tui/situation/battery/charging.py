"""Low batteries, and robots that stand at a charger, where the charge is on its way up."""

import math

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.member import CHARGING, Member
from fleet_tui.model.graph import Vertex
from fleet_tui.model.order import DOCKING
from fleet_tui.model.robot import Reading, Robot, RobotMap
from fleet_tui.model.vehicles.vehicle import Vehicle
from fleet_tui.text.language import EMPTY, Message

ON_ITS_WAY = Message("Wait: it is on its way to a charger")
"""The action at a low battery of a robot that needs no further order."""
CHARGES = Message("Wait: it is charging")
"""The action at a low battery of a robot that says so, or stands at a charger."""
LOOK_AT_CHARGER = Message("Check the robot and its charger")
"""The action if waiting did not help."""
STANDS_FROM = 5.0
"""Seconds without movement from which a robot at a charger does not only pass it."""
AT_CHARGER = 0.5
"""Metres within which a robot is at a charger."""


def has_low_battery(state: FleetState, robot: Robot) -> bool:
    """Tell whether its last report was a charge below the limit."""
    return robot.battery is not None and robot.battery.value < state.limits.battery_low


def charger_of(state: FleetState, robot: Robot) -> Vertex | None:
    """Return the charger that a robot without a current order is at."""
    return charger_at(state, robot) if robot.orders.current is None else None


def charger_at(state: FleetState, robot: Robot) -> Vertex | None:
    """Return the charger that a robot is at, by a pose that still holds."""
    graph = robot.maps.get(robot.floor or "", RobotMap()).graph
    if graph is None or robot.pose is None:
        return None
    here = robot.pose.value
    near = (one for one in graph.chargers if math.dist((one.x, one.y), (here.x, here.y)) <= AT_CHARGER)
    charger = next(near, None)
    return charger if charger is not None and state.is_fresh(robot, "pose") else None


def charging_reported(state: FleetState, robot: Robot) -> Reading[Vehicle] | Reading[Member] | None:
    """Return the report that still holds of a vehicle, or of a fleet's driver, that it charges."""
    vehicle, member = robot.vehicle, robot.member
    if vehicle is not None and vehicle.value.charging and state.is_fresh(robot, "vehicle"):
        return vehicle
    is_charging = member is not None and member.value.mode == CHARGING and state.is_fresh(robot, "member")
    return member if is_charging else None


def charger_used(state: FleetState, robot: Robot) -> Vertex | None:
    """Return the charger at which a robot is taken to charge: the one that it is at, unless it says that it
    does not."""
    vehicle = robot.vehicle
    denies = vehicle is not None and vehicle.value.charging is False and state.is_fresh(robot, "vehicle")
    return None if denies else charger_of(state, robot)


def charging_remedy(state: FleetState, robot: Robot) -> Message:
    """Return what to do at a low battery, empty for the action of its class: it may charge, or one of its
    orders may end at a charger."""
    if charging_reported(state, robot) is not None or charger_used(state, robot) is not None:
        return CHARGES
    if charger_at(state, robot) is not None and (
        robot.orders.current is None or robot.still_for >= STANDS_FROM
    ):
        return LOOK_AT_CHARGER
    graphs = (one.graph for one in robot.maps.values() if one.graph is not None)
    chargers = {vertex.id for graph in graphs for vertex in graph.chargers}
    for order in robot.orders.open:
        if order.label == DOCKING or (order.end is not None and order.end.vertex in chargers):
            return ON_ITS_WAY
    return EMPTY
