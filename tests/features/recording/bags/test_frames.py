"""Messages of a bag as frames: what rosbridge would have sent, for every type of field."""

import base64
import json
import math
from typing import Any, Literal

import cbor2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.recording.bags.convert import Framer
from fleet_tui.features.recording.bags.definitions import typestore
from fleet_tui.model import events
from fleet_tui.robots.ros import operations
from tests.support.adapters import adapter_of, event_of
from tests.support.bag_frames import LINE, Connection
from tests.support.bags import made, types
from tests.support.fleets import F0, R0, order

INTEGERS = {f"{sign}int{bits}": (sign, bits) for sign in ("", "u") for bits in (8, 16, 32, 64)}
FLOATS: dict[str, Literal[32, 64]] = {"float32": 32, "float64": 64}
# A string in CDR ends with a NUL, and is to hold no other.
TEXT = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"), max_size=8)


def numbers(kind: str) -> st.SearchStrategy[Any]:
    if kind == "bool":
        return st.booleans()
    if kind in FLOATS:
        return st.floats(width=FLOATS[kind])
    sign, bits = INTEGERS[kind]
    low, high = (0, 2**bits - 1) if sign else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)
    return st.integers(low, high)


@st.composite
def fields(draw: st.DrawFn, inner: str = "") -> tuple[str, Any, Any]:
    """A line of a definition without its name, a value for it, and how rosbridge writes that."""
    kinds = [*INTEGERS, *FLOATS, "bool", "string", "time", *([inner] if inner else [])]
    kind = draw(st.sampled_from(kinds))
    others = {"string": TEXT, "time": times(), inner: inners()}
    one = others[kind] if kind in others else numbers(kind)
    if not draw(st.booleans()):
        value = draw(one)
        return kind, value, written(kind, value)
    fixed = draw(st.sampled_from([0, 3]))
    values = draw(st.lists(one, min_size=fixed, max_size=fixed or 4))
    line = f"{kind}[{fixed or ''}]"
    if kind in ("uint8", "char"):
        return line, values, base64.b64encode(bytes(values)).decode()
    return line, values, [written(kind, value) for value in values]


def times() -> st.SearchStrategy[Any]:
    return st.fixed_dictionaries({"sec": st.integers(0, 2**31 - 1), "nanosec": st.integers(0, 10**9 - 1)})


def inners() -> st.SearchStrategy[Any]:
    return st.fixed_dictionaries({"words": TEXT, "import": st.integers(-5, 5)})


def written(kind: str, value: Any) -> Any:
    return None if isinstance(value, float) and not math.isfinite(value) else value


PARTS = f"\n{LINE}\nMSG: OH_ressources/Part\nstring words # what\n\nint8 LEFT=1\nint32 import\n"


def seconds(value: Any, is_ros1: bool) -> Any:
    """As the middleware writes times."""
    if isinstance(value, list):
        return [seconds(one, is_ros1) for one in value]
    if is_ros1 and isinstance(value, dict) and "sec" in value:
        return {"secs": value["sec"], "nsecs": value["nanosec"]}
    return value


@given(st.lists(fields("Part"), min_size=1, max_size=5), st.booleans())
def test_every_field_becomes_what_rosbridge_sends(parts: list[tuple[str, Any, Any]], is_ros1: bool) -> None:
    text = "\r\n".join(f"{line}\tfield_{n}  # {line}" for n, (line, _, _) in enumerate(parts)) + PARTS
    connection = Connection("OH_ressources/msg/Whole", text)
    store = typestore(connection)
    msg = made(store, connection.msgtype, {f"field_{n}": value for n, (_, value, _) in enumerate(parts)})
    raw = (store.serialize_ros1 if is_ros1 else store.serialize_cdr)(msg, connection.msgtype)
    frame = Framer(store, connection.msgtype, "/a", is_ros1, as_cbor=False).frame(bytes(raw))
    expected = {f"field_{n}": seconds(value, is_ros1) for n, (_, _, value) in enumerate(parts)}
    assert json.loads(frame) == {"op": "publish", "topic": "/a", "msg": expected}


@given(st.lists(st.tuples(*[st.integers(-(2**31), 2**31 - 1)] * 3, TEXT), max_size=5), st.booleans())
def test_our_decoders_get_back_what_was_said(orders: list[tuple[int, int, int, str]], is_ros1: bool) -> None:
    store = types("OH_ressources")
    listed = [dict(zip(("id", "start", "end", "status"), order, strict=True)) for order in orders]
    kind = "OH_ressources/msg/ActionQueue"
    msg = made(store, kind, {"last_order_id": 3, "current_order_id": -1, "orders": listed})
    raw = (store.serialize_ros1 if is_ros1 else store.serialize_cdr)(msg, kind)
    event = read("queue", Framer(store, kind, "/a", is_ros1, as_cbor=False).frame(bytes(raw)), False)
    assert isinstance(event, events.QueueReported)
    assert list(event.queue.orders) == [order(*one) for one in orders]


def read(key: str, frame: bytes, is_binary: bool) -> events.Event:
    operation = operations.decode_cbor(frame) if is_binary else operations.decode(frame)
    assert isinstance(operation, operations.Publish)
    return event_of(adapter_of(), key, operation.msg, R0, F0, 1.0)


@pytest.mark.parametrize("is_ros1", [True, False])
def test_a_map_goes_as_cbor_and_keeps_its_cells(is_ros1: bool) -> None:
    store, kind = types("OH_ressources"), "nav_msgs/msg/OccupancyGrid"
    cells = np.array([-1, 0, 100, 127, -128, 50], np.int8)
    info = {"resolution": 0.5, "width": 3, "height": 2, "origin": {"orientation": {"w": math.nan}}}
    msg = made(store, kind, {"info": info, "data": cells})
    raw = (store.serialize_ros1 if is_ros1 else store.serialize_cdr)(msg, kind)
    frame = Framer(store, kind, "/map", is_ros1, as_cbor=True).frame(bytes(raw))
    plain = cbor2.loads(frame)
    assert plain["msg"]["data"] == cbor2.CBORTag(72, cells.tobytes())
    assert math.isnan(plain["msg"]["info"]["origin"]["orientation"]["w"])
    event = read("map", frame, True)
    assert isinstance(event, events.GridReceived) and event.grid.frame.width == 3


def test_a_time_of_ros1_goes_on_after_2038() -> None:
    connection = Connection("a/msg/T", "time t\nduration d\n")
    store = typestore(connection)
    raw = (2**31 + 5).to_bytes(4, "little") + bytes(4) + (-3).to_bytes(4, "little", signed=True) + bytes(4)
    msg = json.loads(Framer(store, "a/msg/T", "/a", True, as_cbor=False).frame(raw))["msg"]
    assert msg == {"t": {"secs": 2**31 + 5, "nsecs": 0}, "d": {"secs": -3, "nsecs": 0}}
