"""Set-up commands in words."""

import math
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.set_up.commands import (
    Localise,
    SendGoal,
    SendGraph,
    SetMapping,
    SetPose,
    counts_text,
    heading_text,
)


def test_each_says_what_it_does() -> None:
    pose = Pose(1.0, -2.5, math.pi / 2)
    assert SetPose("r", "hall", pose).text == "set pose (1.00, -2.50) 90°"
    assert SendGoal("r", "hall", pose).text == "go to (1.00, -2.50) 90°"
    assert (Localise("r").text, Localise("r").place) == ("localise", None)
    assert [SetMapping("r", on).text for on in (True, False)] == ["mapping on", "mapping off"]


@given(st.floats(), st.floats(), st.floats())
def test_any_pose_has_a_text(x: float, y: float, yaw: float) -> None:
    assert heading_text(Pose(x, y, yaw)).endswith("°")


VERTICES = Vertex("1", 0.0, 0.0), Vertex("2", 1.0, 0.0)
SENT = SendGraph("r", "hall", VERTICES, (Edge("7", "1", "2"),), labels=(("2", "Base"),))
LABELS = {"2": "Base"}


def graph(
    *edges: Edge, at: float = 1.0, directed: bool = False, vertices: tuple[Vertex, ...] = VERTICES
) -> RouteGraph:
    placed = {vertex.id: vertex for vertex in vertices} | {"2": Vertex("2", at, 0.0, type="dock")}
    return RouteGraph(placed, edges or SENT.edges, directed)


def test_a_graph_is_counted() -> None:
    assert SENT.text == "send graph of hall: 2 vertices, 1 edge, 1 label"
    assert counts_text(1, 0, 2) == "1 vertex, 0 edges, 2 labels"
    assert hash(SENT) == hash(SendGraph("r", "hall", VERTICES, SENT.edges, labels=SENT.labels))


def test_a_robots_graph_is_the_one_sent_whatever_its_notation() -> None:
    both_ways = graph(Edge("1", "2", "1"), Edge("2", "1", "2"), directed=True)
    for same in (graph(), graph(at=1.0009), graph(Edge("9", "2", "1")), both_ways):
        assert SENT.is_graph(same, LABELS)
    more = graph(vertices=(*VERTICES, Vertex("3", 0.0, 0.0)))
    for other in (graph(at=1.0011), graph(directed=True), graph(Edge("7", "1", "1")), more, RouteGraph()):
        assert not SENT.is_graph(other, LABELS)
    assert not SENT.is_graph(graph(), {}) and not SENT.is_graph(graph(), {"2": "Store"})


def test_a_graph_is_compared_once() -> None:
    class Counted(dict[str, Vertex]):
        asked = 0

        def get(self, *args: Any) -> Any:
            self.asked += 1
            return super().get(*args)

    command = SendGraph("r", "hall", VERTICES, SENT.edges, labels=SENT.labels)
    known = Counted(graph().vertices)
    there = RouteGraph(known, SENT.edges)
    assert all(command.is_graph(there, LABELS) for _ in range(9)) and known.asked == 2
    assert command.is_graph(there, dict(LABELS)) and known.asked == 4
