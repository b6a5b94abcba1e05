"""Drawn graphs as messages: in the site's own names and units, and none that would come back as another."""

import json

import pytest
from msgspec.structs import replace

from fleet_tui.model.events import GraphReceived, LabelsReceived
from fleet_tui.model.graph import Edge, Vertex
from fleet_tui.model.set_up.commands import SendGraph
from fleet_tui.robots.adapter import Adapter, Publication
from fleet_tui.robots.profile import Profile
from fleet_tui.text.errors import CommandError
from tests.support.adapters import adapter_of, event_of
from tests.support.fleets import F0, R0, fleet

NAMED = Profile(
    topics={"graph_save": "/{robot}/{floor}/graph_save", "labels_save": "/{robot}/{floor}/labels_save"}
)
RENAMED = replace(
    NAMED,
    fields={"graph.vertices": "g.v", "vertex.x": "at.x", "label.label": "l.n", "label.vertex_id": "l.i"},
    scales={"vertex": 0.001},
)
VERTICES = Vertex("1", 0.5, -2.0, type="dock"), Vertex("2", 4.25, 1.0)
SENT = SendGraph(R0, F0, VERTICES, (Edge("7", "1", "2"),), labels=(("2", "Base"),))
BACK = Edge("8", "2", "1")


def sent(adapter: Adapter, command: SendGraph) -> tuple[Publication, Publication]:
    graph, labels = adapter.outgoing(command, 1, fleet().robots[R0])
    assert isinstance(graph, Publication) and isinstance(labels, Publication)
    return graph, labels


def test_the_graph_goes_first_and_its_labels_follow() -> None:
    graph, labels = sent(adapter_of(NAMED), SENT)
    assert (graph.address, graph.type) == (f"/{R0}/{F0}/graph_save", "OH_ressources/Graph")
    assert (labels.address, labels.type) == (f"/{R0}/{F0}/labels_save", "OH_ressources/LabeledVertices")
    assert json.loads(json.dumps(graph.message)) == {
        "vertices": [
            {"id": 1, "x": 0.5, "y": -2.0, "type": "dock"},
            {"id": 2, "x": 4.25, "y": 1.0, "type": ""},
        ],
        "edges": [{"id": 7, "start": 1, "end": 2}],
    }
    assert labels.message == {"vertices": [{"label": "Base", "vertex_id": 2}]}


@pytest.mark.parametrize("profile", [NAMED, RENAMED, replace(RENAMED, directed=True)])
def test_the_robots_reader_reads_what_is_sent(profile: Profile) -> None:
    adapter = adapter_of(profile)
    graph, labels = sent(adapter, SENT)
    read = event_of(adapter, "graph", graph.message, R0, F0, 1.0)
    named = event_of(adapter, "labels", labels.message, R0, F0, 1.0)
    assert isinstance(read, GraphReceived) and isinstance(named, LabelsReceived)
    assert not read.faults and SENT.is_graph(read.graph, named.labels)


def test_edges_are_sent_as_such_robots_have_them() -> None:
    both_ways = replace(SENT, edges=(*SENT.edges, BACK), directed=True)
    graph, _ = sent(adapter_of(NAMED), both_ways)
    assert graph.message["edges"] == [{"id": 7, "start": 1, "end": 2}]
    one_way_stack = adapter_of(replace(NAMED, directed=True))
    both = [{"id": 7, "start": 1, "end": 2}, {"id": 8, "start": 2, "end": 1}]
    assert sent(one_way_stack, SENT)[0].message["edges"] == both
    assert sent(one_way_stack, both_ways)[0].message["edges"] == both
    assert sent(one_way_stack, replace(SENT, directed=True))[0].message["edges"] == both[:1]
    with pytest.raises(CommandError, match="edge 7 leads one way only"):
        sent(adapter_of(NAMED), replace(SENT, directed=True))


@pytest.mark.parametrize(
    ("vertex", "reason"),
    [
        (Vertex("dock", 0.0, 0.0), "vertex 'dock' is not a number: these robots use numeric ids"),
        (Vertex("5000000000", 0.0, 0.0), "id 5000000000 exceeds the robot's 32 bits"),
        (Vertex("007", 0.0, 0.0), "vertex '007' would come back as 7: write it that way"),
        (Vertex("1", float("nan"), 0.0), "vertex 1 has no finite position"),
    ],
)
def test_a_vertex_that_does_not_fit_is_named(vertex: Vertex, reason: str) -> None:
    with pytest.raises(CommandError, match=reason):
        sent(adapter_of(NAMED), SendGraph(R0, F0, (vertex,)))


@pytest.mark.parametrize("own", ["graph", "labeled_vertices"])
def test_the_robots_own_topics_are_never_published_on(own: str) -> None:
    topic = f"/{{robot}}/{{floor}}/{own}"
    for key in ("graph_save", "labels_save"):
        profile = replace(NAMED, topics={**NAMED.topics, key: topic})
        with pytest.raises(CommandError, match=f"{own} is the robot's own topic: .* in profile.topics.{key}"):
            sent(adapter_of(profile), SENT)


def test_both_topics_are_needed() -> None:
    assert "graph" in adapter_of(NAMED).kind.accepts and "graph" not in adapter_of(NAMED).kind.unset
    half = adapter_of(replace(NAMED, topics={"graph_save": "/{robot}/{floor}/graph_save"}))
    assert half.kind.lack("graph") == "profile.topics.labels_save is empty: no sending of graphs"
    bare = adapter_of(Profile())
    assert bare.kind.lack("graph") == "profile.topics.graph_save is empty: no sending of graphs"
    assert "graph" not in bare.kind.accepts
    with pytest.raises(CommandError, match="graph_save is empty"):
        sent(bare, SENT)


def test_move_base_has_none() -> None:
    other = adapter_of(Profile(kind="move_base"))
    assert other.kind.lack("graph") == "this kind has no sending of graphs"
    robot = replace(fleet().robots[R0], kind=other.kind)
    with pytest.raises(CommandError, match="this kind has no sending of graphs"):
        other.outgoing(SENT, 1, robot)
