"""Set-up commands: the pose of a robot, a goal beside its orders, its mapping mode, its route graph."""

import math
import re
from collections.abc import Mapping
from typing import ClassVar

from msgspec import Struct

from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.kind import (
    CHARGE,
    GOAL,
    GOAL_CANCEL,
    GRAPH,
    LOCALISE,
    MAP_SAVE,
    MAPPING,
    POSE,
    POSE_GRAPH_SAVE,
    SETTLE,
)
from fleet_tui.text.language import EMPTY, Message, counted

MAP_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_-]{0,63}", re.ASCII)
"""Names of maps on a robot, where some programs put them into a shell command. None begins like an option."""
SAME_PLACE = 0.001
"""Metres within which a vertex is where it was sent to."""
MOST_SETTLES = 5
"""Calls that a particle filter at rest needs at most to find the best pose near its own."""


def heading_text(pose: Pose) -> str:
    """Return a pose with its heading: metres, and degrees counter-clockwise."""
    degrees = round(math.degrees(math.remainder(pose.yaw, math.tau))) if math.isfinite(pose.yaw) else pose.yaw
    return f"({pose.x:.2f}, {pose.y:.2f}) {degrees}°"


class SetUpCommand(Struct, frozen=True):
    """Any set-up command. `ability` is the one that a robot needs for it, `what` its name in the audit
    log; `within`: seconds that its evidence may take, if longer than that of other commands."""

    ability: ClassVar[str] = ""
    what: ClassVar[Message] = EMPTY
    within: ClassVar[float] = 0.0

    robot: str

    @property
    def place(self) -> Pose | None:
        """Return the pose that it names, None for none."""
        return None

    @property
    def text(self) -> Message:
        """Return the command in words, without the robot."""
        return (
            Message("{what} {heading_text}", what=self.what, heading_text=heading_text(self.place))
            if self.place
            else self.what
        )


class PoseCommand(SetUpCommand, frozen=True):
    """A command that names a pose on the map of a floor."""

    floor: str
    pose: Pose

    @property
    def place(self) -> Pose:
        """Return the pose that it names."""
        return self.pose


class SetPose(PoseCommand, frozen=True, tag=True):
    """Tell a robot its pose on the map of a floor."""

    ability: ClassVar[str] = POSE
    what: ClassVar[Message] = Message("set pose")


class Localise(SetUpCommand, frozen=True, tag=True):
    """Let a robot find its pose again, anywhere on its map."""

    ability: ClassVar[str] = LOCALISE
    what: ClassVar[Message] = Message("localise")


class Settle(SetUpCommand, frozen=True, tag=True):
    """Let a robot at rest refine its pose by its laser: up to `calls` times, until the pose no longer
    changes."""

    ability: ClassVar[str] = SETTLE
    what: ClassVar[Message] = Message("settle")

    calls: int = MOST_SETTLES


class SendGoal(PoseCommand, frozen=True, tag=True):
    """Send a robot to a pose, beside the queue of orders that it keeps."""

    ability: ClassVar[str] = GOAL
    what: ClassVar[Message] = Message("go to")


class CancelGoal(SetUpCommand, frozen=True, tag=True):
    """Stop a robot that drives to a goal beside its queue, whoever sent it: such a goal has no id."""

    ability: ClassVar[str] = GOAL_CANCEL
    what: ClassVar[Message] = Message("cancel goal")


class StartCharging(SetUpCommand, frozen=True, tag=True):
    """Let a vehicle charge where it stands, once it has driven its orders."""

    ability: ClassVar[str] = CHARGE
    what: ClassVar[Message] = Message("start charging")


class SetMapping(SetUpCommand, frozen=True, tag=True):
    """Switch the mapping mode of a robot."""

    ability: ClassVar[str] = MAPPING
    what: ClassVar[Message] = Message("mapping")

    on: bool

    @property
    def text(self) -> Message:
        """Return the command in words, without the robot."""
        return Message("mapping on") if self.on else Message("mapping off")


class StoreMap(SetUpCommand, frozen=True, tag=True):
    """Let a robot save the map of its floor under a name, on its own disk."""

    ability: ClassVar[str] = MAP_SAVE
    what: ClassVar[Message] = Message("store map")

    name: str

    @property
    def text(self) -> Message:
        """Return the command in words, without the robot."""
        return Message("{what} {name}", what=self.what, name=self.name)


class StorePoseGraph(StoreMap, frozen=True, tag=True):
    """Let a robot save the pose graph behind its map, from which mapping can go on."""

    ability: ClassVar[str] = POSE_GRAPH_SAVE
    what: ClassVar[Message] = Message("store pose graph")


class SendGraph(SetUpCommand, frozen=True, tag=True, dict=True):
    """Replace the route graph of a floor in a robot. `labels` are pairs of vertex id and label; edges go both
    ways unless `directed`. `path`: the file that has it, for a robot that loads files; `is_kept`: the file
    before stays beside it."""

    ability: ClassVar[str] = GRAPH
    what: ClassVar[Message] = Message("send graph")
    within: ClassVar[float] = 10.0

    floor: str
    vertices: tuple[Vertex, ...] = ()
    edges: tuple[Edge, ...] = ()
    directed: bool = False
    labels: tuple[tuple[str, str], ...] = ()
    path: str = ""
    is_kept: bool = False

    @property
    def text(self) -> Message:
        """Return the command in words, without the robot."""
        counts = counts_text(len(self.vertices), len(self.edges), len(self.labels))
        return Message("{what} of {floor}: {counts}", what=self.what, floor=self.floor, counts=counts)

    def is_graph(self, graph: RouteGraph, labels: Mapping[str, str]) -> bool:
        """Tell whether a robot's graph and labels are the ones sent; the types of vertices don't count.

        The last comparison is kept: hardly any report changes a graph, and each is checked.
        """
        last: tuple[object, object, bool] | None = self.__dict__.get("_compared")
        if last is None or last[0] is not graph or last[1] is not labels:
            last = graph, labels, self._equals(graph, labels)
            self.__dict__["_compared"] = last
        return last[2]

    def _equals(self, graph: RouteGraph, labels: Mapping[str, str]) -> bool:
        if len(graph.vertices) != len(self.vertices) or dict(self.labels) != labels:
            return False
        for sent in self.vertices:
            there = graph.vertices.get(sent.id)
            if there is None or math.dist((sent.x, sent.y), (there.x, there.y)) > SAME_PLACE:
                return False
        return _ways(self.edges, self.directed) == _ways(graph.edges, graph.directed)


def _ways(edges: tuple[Edge, ...], directed: bool) -> set[tuple[str, str]]:
    """Return start and end of each way along edges, both ways along those without a direction."""
    ways = {(edge.start, edge.end) for edge in edges}
    return ways if directed else ways | {(end, start) for start, end in ways}


def counts_text(vertices: int, edges: int, labels: int) -> Message:
    """Return the size of a graph in words."""
    return Message(
        "{vertices}, {edges}, {labels}",
        vertices=counted("{count} vertex", "{count} vertices", vertices),
        edges=counted("{count} edge", "{count} edges", edges),
        labels=counted("{count} label", "{count} labels", labels),
    )


SetUp = (
    SetPose
    | Localise
    | Settle
    | SendGoal
    | CancelGoal
    | StartCharging
    | SetMapping
    | StoreMap
    | StorePoseGraph
    | SendGraph
)
