"""Messages of the robots of the source, their names, and the good part of a bad graph."""

import math
from typing import Any

import pytest

from fleet_tui.model.events import Event, FrameReceived, GraphReceived, LabelsReceived, QueueReported
from fleet_tui.model.graph import Edge, Role, Vertex
from fleet_tui.model.order import Stop
from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.robots.profile import Profile
from tests.support.adapters import adapter_of, event_of

FIELDS = {f"{message}.{field}" for message, fields in VOCABULARY.fields.items() for field in fields}


def event(key: str, msg: object, profile: Profile | None = None) -> Event:
    return event_of(adapter_of(profile), key, msg, "r1", "ground", 1.0)


def test_letters_are_states_and_the_word_stays() -> None:
    orders = [{"id": n, "start": 1, "end": 2, "status": letter} for n, letter in enumerate("QWDCX")]
    got = event("queue", {"last_order_id": 4, "current_order_id": 1, "orders": orders})
    assert isinstance(got, QueueReported)
    states = [None if one.state is None else one.state.value for one in got.queue.orders]
    assert states == ["queued", "in process", "done", "cancelled", None]
    assert [one.state_text for one in got.queue.orders][-1] == "X"
    assert [(one.id, one.serial, one.word) for one in got.queue.orders][1] == ("1", 1, "W")
    assert got.queue.current is got.queue.orders[1]


def test_a_current_order_that_is_not_listed_is_none() -> None:
    for current in (-1, 0, 7):
        got = event("queue", {"last_order_id": 4, "current_order_id": current, "orders": []})
        assert isinstance(got, QueueReported) and got.queue.current_id == ""


def test_a_vertex_keeps_the_type_of_the_wire() -> None:
    kinds = ["way", "", "\x1b[2J", "z" * 5000]
    vertices = [{"id": n, "x": 0.0, "y": 0.0, "type": kind} for n, kind in enumerate(kinds)]
    got = event("graph", {"vertices": vertices, "edges": []})
    assert isinstance(got, GraphReceived)
    types = [vertex.type for vertex in got.graph.vertices.values()]
    assert types[:3] == kinds[:3] and len(types[3]) < 300


def test_messages_under_other_names() -> None:
    ours = {name for name in FIELDS if "_call" not in name}
    profile = Profile(fields={name: f"their_{name.partition('.')[2]}" for name in ours})
    order = {"their_id": 4, "their_start": 1, "their_end": 2, "their_status": "Q"}
    queue = event(
        "queue", {"their_last_order_id": 4, "their_current_order_id": -1, "their_orders": [order]}, profile
    )
    assert isinstance(queue, QueueReported) and queue.queue.orders[0].end == Stop("2")
    vertex = {"their_id": 1, "their_x": 2.0, "their_y": 3.0, "their_type": "elevator"}
    edge = {"their_id": 9, "their_start": 1, "their_end": 1}
    graph = event("graph", {"their_vertices": [vertex], "their_edges": [edge]}, profile)
    assert isinstance(graph, GraphReceived) and graph.faults == 0
    assert graph.graph.vertices == {"1": Vertex("1", 2.0, 3.0, Role.ELEVATOR, "elevator")}
    assert graph.graph.edges == (Edge("9", "1", "1"),)
    label = {"their_label": "Base", "their_vertex_id": 1}
    assert event("labels", {"their_vertices": [label]}, profile) == LabelsReceived(
        "r1", "ground", {"1": "Base"}
    )


def test_a_graph_keeps_its_good_parts_and_counts_the_bad_ones() -> None:
    vertices = [
        {"id": 1, "x": 0.0, "y": 0.0, "type": "way"},
        {"id": "two", "x": 0.0, "y": 0.0, "type": "way"},
        {"id": 3, "x": None, "y": 0.0, "type": "way"},
        {"id": 4, "x": math.nan, "y": 0.0, "type": "way"},
        {"id": 5, "x": 5.0, "y": 0.0},
        None,
    ]
    edges = [
        {"id": 1, "start": 1, "end": 5},
        {"id": 2, "start": 1, "end": 77},
        {"id": 3, "start": 4, "end": 1},
        7,
    ]
    got = event("graph", {"vertices": vertices, "edges": edges})
    assert isinstance(got, GraphReceived)
    assert list(got.graph.vertices) == ["1", "5"]
    assert got.graph.edges == (Edge("1", "1", "5"),)
    assert got.faults == 4 + 3
    assert got.fault.startswith("graph of ground: vertices[1]: ")


def test_an_edge_to_nowhere_is_said_with_its_vertex() -> None:
    got = event("graph", {"vertices": [], "edges": [{"id": 2, "start": 1, "end": 77}]})
    assert isinstance(got, GraphReceived)
    assert got.fault == "graph of ground: edge 2 names unknown vertex 1"


def test_roles_and_directions_come_from_the_profile() -> None:
    types = ["way", "label", "elevator", "charger", "", "lift", "\x1b[2J"]
    vertices = [{"id": n, "x": 0.0, "y": 0.0, "type": kind} for n, kind in enumerate(types)]
    plain = event("graph", {"vertices": vertices, "edges": []})
    assert isinstance(plain, GraphReceived) and not plain.graph.directed
    roles = [vertex.role.value for vertex in plain.graph.vertices.values()]
    assert roles == ["plain", "plain", "elevator", "docking", "plain", "plain", "plain"]
    profile = Profile(vertex_types={"lift": "elevator"}, directed=True)
    other = event("graph", {"vertices": vertices, "edges": []}, profile)
    assert isinstance(other, GraphReceived) and other.graph.directed
    assert [id_ for id_, vertex in other.graph.vertices.items() if vertex.role is Role.ELEVATOR] == ["5"]


@pytest.mark.parametrize("origin", ["ros", "added"])
def test_the_origin_is_taken_as_the_profile_says(origin: Any) -> None:
    place = {"position": {"x": 1.0, "y": 0.0}, "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}}
    metadata = {"resolution": 1.0, "width": 2, "height": 2, "origin": place}
    got = event("map_metadata", metadata, Profile(origin=origin))
    assert isinstance(got, FrameReceived)
    assert got.frame.to_pixel(0.0, 0.0)[0] == (1.0 if origin == "added" else -1.0)


def test_poses_are_asked_for_first_and_only_maps_are_heavy() -> None:
    feeds = list(adapter_of().feeds("r1", ["ground"]))
    assert feeds[0].key == "pose"
    assert [feed.key for feed in feeds if feed.large] == ["map"]
    assert [feed.key for feed in feeds if feed.fast] == ["pose"]
    assert {feed.key for feed in feeds if feed.latched} == {"graph", "labels", "map_metadata", "map"}


def test_a_place_farther_than_any_floor_is_left_out() -> None:
    """Two of them would make a picture of infinite size."""
    vertices = [
        {"id": 1, "x": 1.7e308, "y": 0.0},
        {"id": 2, "x": 0.0, "y": -1.7e308},
        {"id": 3, "x": 6e6, "y": 0.0},
    ]
    got = event("graph", {"vertices": vertices, "edges": []})
    assert isinstance(got, GraphReceived)
    assert (list(got.graph.vertices), got.faults) == (["3"], 2)
