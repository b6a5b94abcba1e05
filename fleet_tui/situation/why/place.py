"""The place of a robot, as one says it over the radio: by the nearest place with a name."""

import math

from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.situation.traffic import AT_VERTEX
from fleet_tui.text.language import EMPTY, Message


def place_text(robot: Robot) -> Message:
    """Return the labelled vertex nearest to the robot, and its floor if it has several, without a pose the
    node where it was last; empty without a label."""
    here = robot.maps.get(robot.floor or "", RobotMap())
    if robot.pose is None and robot.vehicle is not None and robot.vehicle.value.last_node:
        node = robot.vehicle.value.last_node
        return Message("at node {name_of}", name_of=robot.name_of(node) or node)
    if robot.pose is None or here.graph is None:
        return EMPTY
    pose, vertices = robot.pose.value, here.graph.vertices
    labelled = [vertices[id_] for id_ in here.labels if id_ in vertices]
    metres, label = min(
        ((math.dist((one.x, one.y), (pose.x, pose.y)), here.labels[one.id]) for one in labelled),
        default=(math.inf, ""),
    )
    if not math.isfinite(metres):
        return EMPTY
    floor = f", {robot.floor}" if len(robot.maps) > 1 else ""
    return (
        Message("at {label}{floor}", label=label, floor=floor)
        if metres <= AT_VERTEX
        else Message("{metres} m from {label}{floor}", metres=f"{metres:.0f}", label=label, floor=floor)
    )
