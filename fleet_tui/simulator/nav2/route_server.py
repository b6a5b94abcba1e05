"""Nav2's route servers: each loads the graph of a file that is named to it, as the real one does."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

SET_GRAPH = "route_server/set_route_graph"
TYPE = "nav2_msgs/SetRouteGraph"
LARGEST = 20_000_000
"""Bytes of a file that is read."""
LINES = ("LineString", "MultiLineString")


class TakenGraph(NamedTuple):
    """The graph of a file: places of vertices by id, start and end of each edge."""

    path: str
    vertices: dict[int, tuple[float, float]]
    edges: tuple[tuple[int, int], ...]


class RouteServers:
    """The route servers of a fleet's robots. `graphs` are the ones that they took last, by robot."""

    def __init__(self) -> None:
        self.graphs: dict[str, TakenGraph] = {}

    def answer(self, robot: str, args: Mapping[str, Any]) -> dict[str, Any]:
        """Carry out a call to a robot's server."""
        return {"success": self.load(robot, args["graph_filepath"])}

    def load(self, robot: str, path: str) -> bool:
        """Load a file, and tell whether it is a graph; a bad one leaves that before in use."""
        try:
            self.graphs[robot] = _read(path)
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return False
        return True


def _read(path: str) -> TakenGraph:
    """Return the graph of a file. Raises OSError, ValueError, KeyError, TypeError, RecursionError."""
    if not Path(path).is_file():
        raise ValueError("no regular file")
    with Path(path).open("rb") as file:
        text = file.read(LARGEST + 1)
    if len(text) > LARGEST:
        raise ValueError("too large")
    features = json.loads(text)["features"]
    points = [one for one in features if one["geometry"]["type"] == "Point"]
    lines = [one["properties"] for one in features if one["geometry"]["type"] in LINES]
    vertices = {_id(one["properties"]["id"]): _place(one["geometry"]["coordinates"]) for one in points}
    edges = tuple((_id(one["startid"]), _id(one["endid"])) for one in lines)
    if not vertices or not edges or not {end for edge in edges for end in edge} <= vertices.keys():
        raise ValueError("no graph")
    return TakenGraph(path, vertices, edges)


def _id(value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or value < 0:
        raise ValueError("no id")
    return value


def _place(value: Any) -> tuple[float, float]:
    x, y, *_ = value
    return float(x), float(y)
