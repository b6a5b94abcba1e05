"""The way of a robot to a charger, as an order proposes it."""

import math

from fleet_tui.model.graph import Vertex
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.rules.language.lookup import Place


def way_to_charger(robot: Robot) -> tuple[Place, ...]:
    """Return the vertex nearest to a robot and the nearest charger on its floor; empty without one, or if it
    is there."""
    floor = robot.floor or ""
    here = robot.maps.get(floor, RobotMap())
    if here.graph is None or robot.pose is None or not here.graph.chargers:
        return ()
    pose = robot.pose.value

    def metres(vertex: Vertex) -> float:
        return math.dist((vertex.x, vertex.y), (pose.x, pose.y))

    way = min(here.graph.vertices.values(), key=metres), min(here.graph.chargers, key=metres)
    places = tuple(Place(one.id, here.name_of(one.id) or one.id, floor) for one in way)
    return places if places[0] != places[1] else ()
