"""What the robots of the source are told, under which names, and what of a bad graph is kept."""

import json
import math
import re
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from fleet_tui.adapters.adapter import ServiceCall
from fleet_tui.adapters.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.adapters.profile import Profile
from fleet_tui.errors import CommandError
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.events import Event, FrameReceived, GraphReceived, LabelsReceived, QueueReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, Role, Vertex
from fleet_tui.model.order import Stop, at_vertices
from fleet_tui.model.robot import Robot
from tests.support.adapters import adapter_of, event_of
from tests.support.fleets import WIRE, place_order, recording

FIELDS = {f"{message}.{field}" for message, fields in VOCABULARY.fields.items() for field in fields}
ORDER = place_order("r1", 0, 7)
DIED = "transport error completing service call: unable to receive data from sender, check sender's logs"
THREW = "service [/r1/x] responded with an error: b'error processing request: division by zero'"
TIMED_OUT = "Timeout exceeded while waiting for service response"
UNREACHED = "Unable to communicate with service [/r1/x], address [rosrpc://host:1]"
INT32 = st.integers(-(2**31), 2**31 - 1)
SERVICE = "/r1/Application_layout/"


def call(command: Command, request_id: int = 5, profile: Profile | None = None) -> ServiceCall:
    (made,) = adapter_of(profile).outgoing(command, request_id, Robot("r1", 1, "", {}))
    assert isinstance(made, ServiceCall)
    return made


def event(key: str, msg: object, profile: Profile | None = None) -> Event:
    return event_of(adapter_of(profile), key, msg, "r1", "ground", 1.0)


@pytest.mark.parametrize(
    ("command", "service", "args"),
    [
        (place_order("r1", 0, 7), "Execute_order", {"request_id": 5, "initial_point": 0, "end_point": 7}),
        (
            place_order("r1", 7),
            "Execute_order_with_cargo",
            {"request_id": 5, "agent": "r1", "end_point": 7},
        ),
        (CancelOrder("r1", "3"), "Cancel_order", {"robot": "r1", "ind": 3}),
        (ClearOrders("r1"), "Clear_orders", {"robot": "r1", "ind": 0}),
        (PauseRobot("r1"), "Pause", {}),
        (ResumeRobot("r1"), "Resume", {}),
    ],
)
def test_every_request_is_complete_and_typed(command: Command, service: str, args: dict[str, Any]) -> None:
    """A bridge fills what is missing with zeros and takes it for an order 0 -> 0."""
    made = call(command)
    assert (made.address, dict(made.args)) == (SERVICE + service, args)
    assert {name: type(value) for name, value in made.args.items()} == {
        name: type(value) for name, value in args.items()
    }


@pytest.mark.parametrize("order_id", [0, -1, -(2**31)])
def test_a_cancel_that_would_mean_all_is_refused(order_id: int) -> None:
    with pytest.raises(CommandError, match="clear"):
        call(CancelOrder("r1", str(order_id)))


@pytest.mark.parametrize("beyond", [2**31, -(2**31) - 1, 10**30])
def test_what_does_not_fit_the_robots_ids_is_refused(beyond: int) -> None:
    for command in (
        place_order("r1", beyond, 1),
        place_order("r1", 1, beyond),
        place_order("r1", beyond),
    ):
        with pytest.raises(CommandError, match=str(beyond)):
            call(command)
    with pytest.raises(CommandError):
        call(CancelOrder("r1", str(beyond)))
    with pytest.raises(CommandError):
        call(place_order("r1", 1, 2), request_id=beyond)


@given(st.text(max_size=12).filter(lambda id_: not re.fullmatch(r"-?[0-9]{1,100}", id_, re.ASCII)))
@example("dock A")
@example("٣")
@example("3f2a77")
@example("1_0")
@example("1" * 5000)
def test_an_id_that_is_no_number_never_leaves_for_these_robots(id_: str) -> None:
    for command in (place_order("r1", id_, 1), place_order("r1", 1, id_), place_order("r1", id_)):
        with pytest.raises(CommandError, match="is not a number"):
            call(command)
    with pytest.raises(CommandError, match="is not a number"):
        call(CancelOrder("r1", id_))


def test_what_these_robots_can_not_drive_never_leaves() -> None:
    with pytest.raises(CommandError, match="to vertices, not to poses"):
        call(PlaceOrder("r1", (Stop(pose=Pose(1.0, 2.0)),)))
    for stops, count in (((), 0), (at_vertices("1", "2", "3"), 3)):
        with pytest.raises(CommandError, match=f"one or two stops, not {count}"):
            call(PlaceOrder("r1", stops))


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


@given(INT32, INT32, st.integers(1, 2**31 - 1))
def test_whatever_fits_is_sent_as_it_is(start: int, end: int, order_id: int) -> None:
    assert dict(call(place_order("r1", start, end)).args) == {
        "request_id": 5,
        "initial_point": start,
        "end_point": end,
    }
    assert call(CancelOrder("r1", str(order_id))).args["ind"] == order_id


def test_calls_under_other_names() -> None:
    names = {
        "order_call.request_id": "rid",
        "order_call.initial_point": "from",
        "order_call.end_point": "to",
        "cargo_call.agent": "who",
        "cancel_call.robot": "name",
        "cancel_call.ind": "number",
    }
    profile = Profile(fields=names, services={"order": "/fleet/{robot}/go"})
    made = call(place_order("r1", 0, 7), profile=profile)
    assert (made.address, made.args) == ("/fleet/r1/go", {"rid": 5, "from": 0, "to": 7})
    assert call(place_order("r1", 7), profile=profile).args == {
        "request_id": 5,
        "who": "r1",
        "end_point": 7,
    }
    assert call(CancelOrder("r1", "3"), profile=profile).args == {"name": "r1", "number": 3}
    assert call(ClearOrders("r1"), profile=profile).args == {"name": "r1", "number": 0}


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


@pytest.mark.parametrize(
    ("values", "result", "outcome", "words"),
    [
        ({"request_id": 1, "status": "ACCEPTED"}, True, Stage.ACCEPTED, "ACCEPTED"),
        ({"request_id": 1, "status": "executed"}, True, Stage.ACCEPTED, "executed"),
        ({"status": "REJECTED: unknown vertex 77"}, True, Stage.REFUSED, "REJECTED: unknown vertex 77"),
        ({"status": "Error 5"}, True, Stage.REFUSED, "Error 5"),
        ({"status": "order failed"}, True, Stage.REFUSED, "order failed"),
        ({"status": "terror"}, True, Stage.ACCEPTED, "terror"),
        ({"success": False, "message": "no"}, True, Stage.REFUSED, "no"),
        ({"success": False, "status": ""}, True, Stage.REFUSED, ""),
        ({"success": True, "message": "paused"}, True, Stage.ACCEPTED, "paused"),
        ("Service /x does not exist", False, Stage.REFUSED, "Service /x does not exist"),
        (DIED, False, Stage.UNKNOWN, DIED),
        (THREW, False, Stage.UNKNOWN, THREW),
        (TIMED_OUT, False, Stage.UNKNOWN, TIMED_OUT),
        (UNREACHED, False, Stage.REFUSED, UNREACHED),
        ("Unable to communicate with master!", False, Stage.REFUSED, "Unable to communicate with master!"),
        ({"status": "ACCEPTED"}, False, Stage.UNKNOWN, "{'status': 'ACCEPTED'}"),
        (None, True, Stage.UNKNOWN, "unrecognised reply: None"),
        ({}, True, Stage.UNKNOWN, "unrecognised reply: {}"),
        ({"status": None}, True, Stage.UNKNOWN, "unrecognised reply: {'status': None}"),
        ([1], True, Stage.UNKNOWN, "unrecognised reply: [1]"),
        ({"success": 0}, True, Stage.UNKNOWN, "unrecognised reply: {'success': 0}"),
        ({"success": True, "message": None}, True, Stage.ACCEPTED, ""),
        ({"status": "unknown vertex 77"}, True, Stage.REFUSED, "unknown vertex 77"),
        ({"status": "executed without error"}, True, Stage.ACCEPTED, "executed without error"),
    ],
)
def test_an_answer_is_judged_by_its_words(values: object, result: bool, outcome: Stage, words: str) -> None:
    assert adapter_of(Profile()).outcome(ORDER, values, result) == (outcome, words)


@pytest.mark.parametrize(
    ("command", "message", "outcome"),
    [
        (ResumeRobot("robot_1"), "already running", Stage.ACCEPTED),
        (ResumeRobot("robot_1"), "The robot is not paused", Stage.ACCEPTED),
        (PauseRobot("robot_1"), "Already paused", Stage.ACCEPTED),
        (PauseRobot("robot_1"), "not running", Stage.REFUSED),
        (PauseRobot("robot_1"), "already running", Stage.REFUSED),
        (ORDER, "already running", Stage.REFUSED),
    ],
)
def test_a_robot_that_is_as_it_was_asked_to_be_does_not_refuse(
    command: Command, message: str, outcome: Stage
) -> None:
    answer = {"success": False, "message": message}
    assert adapter_of(Profile()).outcome(command, answer, True) == (outcome, message)


REACHED_NOBODY = [
    "does not exist",
    "does not have a field",
    "message requires",
    "not a primitive type",
    "not supported between",
]


@pytest.mark.parametrize("name", sorted(path.name for path in WIRE.glob("*.jsonl*")))
def test_each_recorded_failure_of_a_call_is_told_apart(name: str) -> None:
    """Only what never reached a node was refused."""
    frames = [
        json.loads(frame["text"]) for frame in recording(name) if frame["dir"] == "in" and "text" in frame
    ]
    for frame in frames:
        if frame["op"] == "service_response" and not frame["result"]:
            stage, words = adapter_of(Profile()).outcome(ORDER, frame["values"], False)
            refused = any(part in words for part in REACHED_NOBODY)
            assert stage is (Stage.REFUSED if refused else Stage.UNKNOWN), words


@pytest.mark.parametrize(
    "said",
    [
        "'<' not supported between instances of 'NoneType' and 'int'",
        "Message type Graph does not have a field vertex",
        "field data message requires an int",
    ],
)
def test_what_a_handler_throws_is_no_refusal_whatever_its_words(said: str) -> None:
    text = f'service [/r1/x] responded with an error: b"error processing request: {said}"'
    assert adapter_of(Profile()).outcome(ORDER, text, False)[0] is Stage.UNKNOWN
    assert adapter_of(Profile()).outcome(ORDER, said, False)[0] is Stage.REFUSED


def test_which_words_refuse_is_the_profiles() -> None:
    judge = adapter_of(Profile(refusals=("^no$",))).outcome
    assert judge(ORDER, {"status": "no"}, True)[0] is Stage.REFUSED
    assert judge(ORDER, {"status": "REJECTED"}, True)[0] is Stage.ACCEPTED


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
