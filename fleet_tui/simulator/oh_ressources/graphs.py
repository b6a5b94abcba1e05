"""Graphs that consoles send to the source's robots, which all drive on one graph for each floor."""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.graph import SimEdge, SimGraph, SimVertex
from fleet_tui.simulator.messages import Message, graph_of, labels_of
from fleet_tui.simulator.oh_ressources.world import World

GRAPH_SAVE = "graph_save"
LABELS_SAVE = "labels_save"


class SentGraphs:
    """Takes graphs and labels of floors; one that a robot could not drive on is dropped silently."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._redrawn: set[str] = set()

    def subscriptions(self) -> Mapping[str, tuple[str, Callable[[Message], None]]]:
        """The topics of each robot and floor on which a graph and its labels are sent."""
        taken = {
            GRAPH_SAVE: ("OH_ressources/Graph", self._take_graph),
            LABELS_SAVE: ("OH_ressources/LabeledVertices", self._take_labels),
        }
        return {
            f"/{robot}/{floor.name}/{topic}": (type_, partial(take, number))
            for robot in self._world.robots
            for number, floor in enumerate(self._world.building.floors)
            for topic, (type_, take) in taken.items()
        }

    def news(self) -> Iterator[tuple[str, Payload]]:
        """Return the graphs and labels of floors that were redrawn since the last call."""
        for floor in self._world.building.floors:
            if floor.name in self._redrawn:
                for topic, message in (("graph", graph_of(floor)), ("labeled_vertices", labels_of(floor))):
                    payload = Payload(message)
                    yield from ((f"/{robot}/{floor.name}/{topic}", payload) for robot in self._world.robots)
        self._redrawn.clear()

    def _take_graph(self, number: int, message: Message) -> None:
        """Take a graph; labels without a vertex, and edges to one that is unknown, are dropped."""
        floors = self._world.building.floors
        floor, vertices = floors[number], {one["id"]: _vertex(one) for one in message["vertices"]}
        others = {id_ for other in floors if other is not floor for id_ in other.graph.vertices}
        places = [metres for one in vertices.values() for metres in (one.x, one.y)]
        # The ids of a building are unique: robots plan across its floors.
        if not vertices or others & vertices.keys() or not all(map(math.isfinite, places)):
            return
        edges = [SimEdge(one["id"], one["start"], one["end"]) for one in message["edges"]]
        known = tuple(edge for edge in edges if edge.start in vertices and edge.end in vertices)
        types = {one["id"]: one["type"] for one in message["vertices"]}
        labels = {id_: label for id_, label in floor.labels.items() if id_ in vertices}
        graph = SimGraph(vertices, known)
        self._world.redraw(replace(floor, graph=graph, types=types, labels=labels))
        self._redrawn.add(floor.name)

    def _take_labels(self, number: int, message: Message) -> None:
        """Take labels, all of them or, if one names an unknown vertex, none."""
        floor = self._world.building.floors[number]
        labels = {one["vertex_id"]: one["label"] for one in message["vertices"]}
        if labels.keys() <= floor.graph.vertices.keys():
            self._world.building.redraw(replace(floor, labels=labels))
            self._redrawn.add(floor.name)


def _vertex(given: Mapping[str, Any]) -> SimVertex:
    return SimVertex(given["id"], given["x"], given["y"])
