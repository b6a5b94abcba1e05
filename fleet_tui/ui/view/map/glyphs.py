"""The characters of the map, each with its plain ASCII substitute."""

import math
from functools import lru_cache

from fleet_tui.model.graph import Role
from fleet_tui.text.units import age
from fleet_tui.ui.view.map.scene import SceneRobot
from fleet_tui.ui.view.roles import StyleRole

# East first, then counter-clockwise in steps of 45 degrees. A loaded robot is a filled arrow.
_EMPTY = "→↗↑↖←↙↓↘"
_LOADED = "▶◥▲◤◀◣▼◢"
_PLAIN = (">", "/^", "^", "^\\", "<", "v/", "v", "\\v")


def robot_glyph(robot: SceneRobot, turned: float, plain: bool) -> str:
    """Return the robot's arrow; turned: radians by which the map's picture is turned in the world."""
    heading = robot.pose.yaw - turned
    eighth = round(heading / (math.pi / 4)) % 8 if math.isfinite(heading) else 0
    if plain:
        return _PLAIN[eighth]
    return (_LOADED if robot.cargo else _EMPTY)[eighth]


def robot_number(robot: SceneRobot) -> str:
    return robot.mark or str(robot.number)


def robot_tag(robot: SceneRobot, plain: bool, has_age: bool = True) -> str:
    """Return the text beside the arrow: the number, then the robot's special states; the age of an old pose,
    or without it (`has_age`) a sign."""
    tag = robot_number(robot)
    if plain and robot.cargo:
        tag += "+"
    if robot.obstacle or robot.alarmed or robot.acknowledged or robot.waits:
        tag += "!"
    if robot.paused:
        tag += "=" if plain else "‖"
    if robot.jumped or robot.misplaced:
        tag += "?"
    if robot.estimated:
        tag += "*" if plain else "±"
    if robot.other_map:
        tag += "~" if plain else "≈"
    if robot.online:
        return tag
    # In brackets: "0 18 s" would read as two numbers.
    return f"{tag} ({age(robot.age)})" if has_age else tag + ("-" if plain else "○")


def is_special(robot: SceneRobot) -> bool:
    """Tell whether a robot is the selected one, or in a state that its tag shows."""
    states = robot.obstacle, robot.alarmed, robot.acknowledged, robot.waits, robot.paused, robot.jumped
    return robot.selected or not robot.online or robot.other_map or robot.misplaced or any(states)


def robot_roles(robot: SceneRobot) -> tuple[StyleRole, StyleRole]:
    """Return the roles of the arrow and of the tag: the first shows selection, both show trouble."""
    if robot.alarmed:
        state = StyleRole.ROBOT_ALARM
    elif not robot.online:
        state = StyleRole.ROBOT_OFFLINE
    elif robot.is_odd:
        state = StyleRole.ROBOT_WARN
    elif robot.selected:
        state = StyleRole.ROBOT_SELECTED
    else:
        return (StyleRole.CARGO if robot.cargo else StyleRole.ROBOT), StyleRole.ROBOT
    return (StyleRole.ROBOT_SELECTED if robot.selected else state), state


@lru_cache(maxsize=32)
def vertex_glyph(role: Role, is_labelled: bool, plain: bool) -> tuple[str, StyleRole]:
    """Return the glyph of a vertex by its role; without a role by whether it has a label."""
    if role is Role.ELEVATOR:
        return ("E" if plain else "↕"), StyleRole.ELEVATOR
    if role is Role.DOCKING:
        return ("D" if plain else "⌂"), StyleRole.DOCKING
    if is_labelled:
        return "o", StyleRole.VERTEX_LABELLED
    return ("'" if plain else "·"), StyleRole.VERTEX
