"""Files of maps, pose graphs and route graphs that a robot saves or loads: requests, and the meaning of their
answers."""

from collections.abc import Mapping
from typing import Any

from fleet_tui.model.commands import Stage
from fleet_tui.model.kind import GRAPH, MAP_SAVE, POSE_GRAPH_SAVE
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import MAP_NAME, SendGraph, StoreMap
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message, verbatim
from fleet_tui.text.limits import truncate

KEYS = {MAP_SAVE: "map_save", POSE_GRAPH_SAVE: "map_pose_graph", GRAPH: "graph_load"}
"""The services, by the ability that they give; not every kind has each."""
CODES = {1: "no map", 255: "failed"}
"""Results of slam_toolbox."""


def save_request(names: Names, command: StoreMap, robot: Robot) -> Mapping[str, Any]:
    """Return the fields of a request. Raises CommandError if a name has other characters than are allowed:
    slam_toolbox puts it into a shell command."""
    given = {"robot": robot.name, "floor": robot.floor or "", "name": command.name}
    harmless = {what: value for what, value in given.items() if MAP_NAME.fullmatch(value)}
    request = names.request(KEYS[command.ability], harmless)
    for what, value in given.items():
        if f"{{{what}}}" in str(request):
            text = Message(
                "{what} {map} is not a map name: up to 64 letters, digits, _ and -",
                what=what,
                map=f"{value!r}",
            )
            raise CommandError(text)
    return request


def load_request(names: Names, command: SendGraph) -> Mapping[str, Any]:
    """Return the fields of a request to load the file of a graph. Raises CommandError without a file: the
    robot would load another one."""
    if not command.path:
        raise CommandError(Message("no file of the graph was written: send it from the graph editor"))
    values = {"robot": command.robot, "floor": command.floor, "path": command.path}
    return names.request(KEYS[command.ability], values)


def judge_saved(names: Names, command: StoreMap | SendGraph, values: object) -> tuple[Stage, Message] | None:
    """Return the stage that an answer leads to, which is at most that the robot accepted the request; None if
    the profile names no fields for it, or it has none."""
    wanted = names.answer(KEYS[command.ability])
    if not wanted or not isinstance(values, Mapping) or not values:
        return None
    other = [f"{name} {_said(values.get(name))}" for name in wanted if values.get(name) != wanted[name]]
    return (Stage.REFUSED, verbatim(", ".join(other))) if other else (Stage.ACCEPTED, EMPTY)


def _said(value: object) -> str:
    meaning = CODES.get(value, "") if isinstance(value, int) and not isinstance(value, bool) else ""
    return truncate(f"{value} ({meaning})" if meaning else str(value))
