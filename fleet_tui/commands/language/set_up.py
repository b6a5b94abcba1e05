"""Set-up in the command language: poses in metres and degrees, goals, modes."""

import math
import re
from collections.abc import Sequence
from typing import assert_never

from fleet_tui.commands.language.words import quoted, vertex_of
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import (
    GOAL,
    LOCALISE,
    MAP_SAVE,
    MAPPING,
    ORDER_TO,
    POSE,
    POSE_GRAPH_SAVE,
    SETTLE,
    Kind,
)
from fleet_tui.model.order import Stop
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import (
    MOST_SETTLES,
    CancelGoal,
    Localise,
    SendGoal,
    SendGraph,
    SetMapping,
    SetPose,
    Settle,
    SetUp,
    StartCharging,
    StoreMap,
    StorePoseGraph,
)
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message

USAGE = {
    "goto": "goto ROBOT PLACE, or goto ROBOT X Y [YAW]",
    "set-pose": "set-pose ROBOT X Y YAW",
    "localise": "localise ROBOT",
    "settle": "settle ROBOT [CALLS], 1 to 5 calls",
    "mapping": "mapping ROBOT on, or mapping ROBOT off",
    "store-map": "store-map ROBOT NAME",
    "store-pose-graph": "store-pose-graph ROBOT NAME",
}
_ABILITIES = {
    "set-pose": POSE,
    "localise": LOCALISE,
    "settle": SETTLE,
    "mapping": MAPPING,
    "store-map": MAP_SAVE,
    "store-pose-graph": POSE_GRAPH_SAVE,
}
SETTLES = tuple(map(str, range(1, MOST_SETTLES + 1)))
"""The numbers of calls that `settle` takes."""
_NUMBER = re.compile(r"[-+]?([0-9]{1,9}(\.[0-9]{0,9})?|\.[0-9]{1,9})", re.ASCII)


def ability_of(verb: str, kind: Kind) -> str:
    """Return the ability that robots of a kind need for a verb of set-up."""
    if verb == "goto":
        return ORDER_TO if kind.keeps_goals else GOAL
    return _ABILITIES[verb]


def parse_set_up(verb: str, robot: Robot, values: Sequence[str]) -> Request | None:
    """Return the request of a verb, None for values that do not fit it. Raises CommandError."""
    match verb, values:
        case "set-pose", [_, _, _]:
            return Request((SetPose(robot.name, floor_of(robot), _pose(values)),))
        case "goto", [place]:
            return _to_place(robot, place)
        case "goto", [_, _] | [_, _, _]:
            return Request((to_pose(robot, _pose(values), turns_freely=len(values) == 2),), alone=True)
        case "localise", []:
            return Request((Localise(robot.name),))
        case "settle", []:
            return Request((Settle(robot.name),))
        case "settle", [calls] if calls in SETTLES:
            return Request((Settle(robot.name, int(calls)),))
        case "mapping", ["on" | "off" as mode]:
            return Request((SetMapping(robot.name, mode == "on"),))
        case "store-map", [name]:
            return Request((StoreMap(robot.name, name),))
        case "store-pose-graph", [name]:
            return Request((StorePoseGraph(robot.name, name),))
    return None


def floor_of(robot: Robot) -> str:
    """Return the floor that a robot is on. Raises CommandError if it is unknown."""
    if robot.floor is not None:
        return robot.floor
    if len(robot.maps) == 1:
        return next(iter(robot.maps))
    raise CommandError(
        Message("the floor of {name} is unknown: it has {maps}", name=robot.name, maps=", ".join(robot.maps))
    )


def _pose(values: Sequence[str]) -> Pose:
    for value in values:
        if not _NUMBER.fullmatch(value):
            raise CommandError(
                Message(
                    "{word} is not a number: metres, and degrees counter-clockwise", word=f"{value[:40]!r}"
                )
            )
    x, y, degrees = (*map(float, values), 0.0)[:3]
    return Pose(x, y, math.remainder(math.radians(degrees), math.tau))


def _to_place(robot: Robot, place: str) -> Request:
    """Return a goal at a vertex: an order where goals are orders, else a pose with the heading of the way
    there."""
    vertex, floor = vertex_of(robot, place)
    if ability_of("goto", robot.kind) == ORDER_TO:
        order = PlaceOrder(robot.name, (Stop(vertex),))
        return Request((order,), ((vertex, floor),) if floor else (), alone=True)
    if GOAL not in robot.kind.accepts:  # the check names the missing key
        return Request((SendGoal(robot.name, floor or floor_of(robot), Pose(0.0, 0.0)),))
    floor = floor or floor_of(robot)
    graph = robot.maps[floor].graph
    if graph is None or vertex not in graph.vertices:
        raise CommandError(Message("the position of {place} on {floor} is unknown", place=place, floor=floor))
    x, y = graph.vertices[vertex].x, graph.vertices[vertex].y
    here = robot.pose.value if robot.pose else Pose(x, y)
    yaw = math.atan2(y - here.y, x - here.x) if math.dist((x, y), (here.x, here.y)) > 0.1 else here.yaw
    return Request((SendGoal(robot.name, floor, Pose(x, y, yaw)),))


def to_pose(robot: Robot, pose: Pose, turns_freely: bool = False) -> PlaceOrder | SendGoal:
    """Return the goal at a pose: an order where goals are orders. Raises CommandError."""
    if ability_of("goto", robot.kind) == ORDER_TO:
        return PlaceOrder(robot.name, (Stop(pose=pose, turns_freely=turns_freely),))
    floor = floor_of(robot) if GOAL in robot.kind.accepts else ""
    return SendGoal(robot.name, floor, pose)


def written_pose(pose: Pose, turns_freely: bool = False) -> str:
    """Return a pose as it is typed, without its heading if nobody gave one."""
    values = (pose.x, pose.y) if turns_freely else (pose.x, pose.y, math.degrees(pose.yaw))
    return " ".join(f"{value:.6f}".rstrip("0").rstrip(".") for value in values)


def written_set_up(command: SetUp) -> str:
    """Return a command as a line that is parsed to it, empty for one that can't be typed."""
    match command:
        case SetPose(name, _, pose):
            return f"set-pose {name} {written_pose(pose)}"
        case SendGoal(name, _, pose):
            return f"goto {name} {written_pose(pose)}"
        case CancelGoal(name):
            return f"cancel {name} goal"
        case Localise(name):
            return f"localise {name}"
        case Settle(name, calls):
            return f"settle {name}" + (f" {calls}" if calls != MOST_SETTLES else "")
        case SetMapping(name, on):
            return f"mapping {name} {'on' if on else 'off'}"
        case StorePoseGraph(name, map_name):
            return f"store-pose-graph {name} {quoted(map_name)}"
        case StoreMap(name, map_name):
            return f"store-map {name} {quoted(map_name)}"
        case SendGraph() | StartCharging():
            return ""
        case _:
            assert_never(command)
