"""ROS messages against recordings of a real bridge: the same map in JSON and in CBOR, cell by cell."""

import base64
import json
from typing import Any

import cbor2
import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.operations import Publish, decode, decode_cbor
from fleet_tui.text.errors import WireError
from tests.support.changed import changed
from tests.support.fleets import recording

POSE: dict[str, Any] = {
    "header": {"seq": 1, "stamp": {"secs": 12, "nsecs": 500_000_000}, "frame_id": "ground"},
    "pose": {"position": {"x": 1.5, "y": -2, "z": 0.0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1.0}},
}
Struct = type[msgspec.Struct]
OF_TOPIC: dict[str, Struct] = {
    "pose": ros.PoseStamped,
    "battery": ros.Float32,
    "obstacle": ros.Float32,
    "cargo": ros.Bool,
    "queue": ros.ActionQueue,
    "map_metadata": ros.MapMetadata,
    "graph": ros.GraphMessage,
    "labeled_vertices": ros.LabeledVertices,
    "map": ros.OccupancyGridMessage,
}


def raw(value: object) -> msgspec.Raw:
    return msgspec.Raw(json.dumps(value).encode())


def holds(read: object, recorded: object) -> bool:
    """Tell whether every field that was read has the recorded value."""
    if isinstance(read, msgspec.Struct) and isinstance(recorded, dict):
        known = {name for name in read.__struct_fields__ if name in recorded}
        return bool(known) and all(holds(getattr(read, name), recorded[name]) for name in known)
    return read == recorded


@pytest.mark.parametrize("name", ["telemetry-and-orders.jsonl", "map-json.jsonl.gz"])
def test_every_recorded_message_is_read(name: str) -> None:
    count = 0
    for line in recording(name):
        operation = decode(line["text"].encode()) if line["dir"] == "in" else None
        if isinstance(operation, Publish):
            read = ros.reader(OF_TOPIC[operation.topic.rpartition("/")[2]])
            assert holds(read(operation.msg), json.loads(bytes(operation.msg))), operation.topic
            count += 1
    assert count


def test_a_map_as_json_equals_the_map_as_cbor_cell_by_cell() -> None:
    read = ros.reader(ros.OccupancyGridMessage)
    text = decode(recording("map-json.jsonl.gz")[1]["text"].encode())
    binary = decode_cbor(base64.b64decode(recording("map-cbor.jsonl.gz")[1]["binary"]))
    assert isinstance(text, Publish) and isinstance(binary, Publish)
    assert text.topic == binary.topic
    one, other = read(text.msg), read(binary.msg)
    assert isinstance(one.data, list) and isinstance(other.data, bytes)
    assert [cell & 0xFF for cell in one.data] == list(other.data)
    assert len(other.data) == 400 * 300 and set(one.data) == {-1, 0, 100}
    assert one.info == other.info


@pytest.mark.parametrize(
    ("stamp", "seconds"),
    [
        ({"secs": 12, "nsecs": 500_000_000}, 12.5),
        ({"sec": 12, "nanosec": 500_000_000}, 12.5),
        ({"secs": 0, "nsecs": 1}, 1e-9),
        ({"secs": 0, "nsecs": 0}, None),
        ({}, None),
    ],
)
def test_stamps_of_both_generations(stamp: dict[str, int], seconds: float | None) -> None:
    assert ros.reader(ros.Stamp)(raw(stamp)).seconds == seconds


def test_a_stamp_that_was_never_set_is_none() -> None:
    message = ros.reader(ros.PoseStamped)(raw({**POSE, "header": {"frame_id": "a"}}))
    assert message.header.stamp.seconds is None


@pytest.mark.parametrize("number", [10**30, 10**400, -(10**400), 2**63])
@pytest.mark.parametrize("field", ["secs", "nsecs", "sec", "nanosec"])
def test_a_stamp_too_large_for_any_clock_is_refused(field: str, number: int) -> None:
    for msg in ({field: number}, raw({field: number})):
        with pytest.raises(WireError):
            ros.reader(ros.Stamp)(msg)


@pytest.mark.parametrize("value", [None, "1.0", True, [], {}, ...], ids=repr)
@pytest.mark.parametrize("field", ["pose.position.x", "pose.orientation.w"])
def test_a_bad_number_is_refused_by_name(field: str, value: object) -> None:
    last = field.rpartition(".")[2]
    for msg in (changed(POSE, field, value), raw(changed(POSE, field, value))):
        with pytest.raises(WireError, match=last if value is ... else rf"\$\.{field}"):
            ros.reader(ros.PoseStamped)(msg)


@pytest.mark.parametrize(
    "msg", [None, 7, "x", [], {}, {"data": None}, {"data": cbor2.CBORTag(72, "x")}], ids=repr
)
def test_what_is_no_such_message_is_refused(msg: object) -> None:
    with pytest.raises(WireError):
        ros.reader(ros.Float32)(msg)


@pytest.mark.parametrize("data", [cbor2.CBORTag(64, b"\0"), [128], [-129], [0.5], "%%%", None], ids=repr)
def test_map_data_of_another_kind_is_refused(data: object) -> None:
    pose = {"position": POSE["pose"]["position"], "orientation": POSE["pose"]["orientation"]}
    info = {"resolution": 1.0, "width": 1, "height": 1, "origin": pose}
    read = ros.reader(ros.OccupancyGridMessage)
    assert read({"info": info, "data": cbor2.CBORTag(72, b"\xff")}).data == b"\xff"
    with pytest.raises(WireError):
        read({"info": info, "data": data})


@pytest.mark.parametrize("number", [-(2**31), 2**31 - 1])
def test_ids_are_int32(number: int) -> None:
    order = {"id": number, "start": 1, "end": 2, "status": "Q"}
    assert ros.reader(ros.QueuedOrder)(order).id == number
    beyond = number + (1 if number > 0 else -1)
    for bad in (beyond, 10**40, 7.0, "7", None, True):
        with pytest.raises(WireError):
            ros.reader(ros.QueuedOrder)({**order, "id": bad})


# Messages whose field names a profile may change.
RENAMEABLE: dict[str, type[msgspec.Struct]] = {
    "graph": ros.GraphMessage,
    "vertex": ros.GraphVertex,
    "edge": ros.GraphEdge,
    "labels": ros.LabeledVertices,
    "label": ros.LabeledVertex,
    "queue": ros.ActionQueue,
    "order": ros.QueuedOrder,
}


@pytest.mark.parametrize("message", list(RENAMEABLE))
def test_every_field_of_ours_can_have_another_name(message: str) -> None:
    struct = RENAMEABLE[message]
    samples: dict[str, object] = {"x": 1.5, "y": 2.5, "status": "Q", "label": "Base", "type": "way"}
    lists = ("vertices", "edges", "orders")
    plain = {
        name: [] if name in lists else samples.get(name, number)
        for number, name in enumerate(struct.__struct_fields__)
    }
    renamed = {f"{name}_theirs": value for name, value in plain.items()}
    read = ros.reader(struct, {name: (name, f"{name}_theirs") for name in plain})
    for msg in (renamed, raw(renamed)):
        assert {name: getattr(read(msg), name) for name in plain} == plain
    with pytest.raises(WireError, match="theirs"):
        read(plain)


def test_a_field_with_a_default_keeps_it_under_another_name() -> None:
    read = ros.reader(ros.GraphVertex, {"type": ("type", "kind")})
    assert read({"id": 1, "x": 0.0, "y": 0.0}).type == ""
    assert read({"id": 1, "x": 0.0, "y": 0.0, "kind": "lift"}).type == "lift"


ANYTHING = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=4) | st.binary(max_size=4),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from([*POSE, "data", "position", "x", "info", "vertices"]), inner)
        | st.builds(cbor2.CBORTag, st.sampled_from([64, 72, 29]), inner)
    ),
    max_leaves=10,
)


@given(ANYTHING, st.sampled_from(list(OF_TOPIC.values())))
def test_any_object_is_a_message_or_refused(msg: object, struct: Struct) -> None:
    try:
        assert isinstance(ros.reader(struct)(msg), struct)
    except WireError as refused:
        assert str(refused)


@given(st.binary(max_size=50), st.sampled_from(list(OF_TOPIC.values())))
def test_any_bytes_are_a_message_or_refused(payload: bytes, struct: Struct) -> None:
    try:
        assert isinstance(ros.reader(struct)(msgspec.Raw(payload)), struct)
    except WireError as refused:
        assert str(refused)
