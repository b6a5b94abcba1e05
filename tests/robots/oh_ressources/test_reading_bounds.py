"""However much a robot says, so much is taken, in so much time, and what is left out is said."""

import json
from typing import Any

import cbor2
import msgspec
import pytest

from fleet_tui.config.start import initial_state
from fleet_tui.model import events
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.robots.ros import messages, operations
from fleet_tui.state.reducer import apply
from fleet_tui.text import limits as bounds
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import verbatim
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.selection import Selection
from fleet_tui.ui.view.tables.alarms import alarm_table
from fleet_tui.ui.view.tables.fleet import fleet_table
from fleet_tui.ui.view.tables.queue import queue_table
from tests.support.adapters import adapter_of, event_of
from tests.support.fleets import F0, LINK, R0, T0, fleet, link_lost, link_up, pose, reduced, tick
from tests.support.watched_store import config_of

MEGABYTE = "x\x1b[2J" * 200_000
ADAPTER = adapter_of()


def received(key: str, msg: object) -> events.Event:
    """The event of a message."""
    payload = msgspec.Raw(json.dumps(msg).encode())
    return event_of(ADAPTER, key, payload, R0, F0, T0)


def shown(state: FleetState) -> list[str]:
    """Every row of every pane."""
    tables = [fleet_table(state, R0, 60), alarm_table(state, str)]
    tables += [queue_table(state, R0, everybody, 60) for everybody in (False, True)]
    rows = ["".join(text for text, _ in row.runs) for table in tables for row in table.rows]
    floor_scene(state, Selection(R0, F0))
    return rows


def labels(count: int, text: str = "L") -> dict[str, Any]:
    return {"vertices": [{"label": f"{text}{n}", "vertex_id": n} for n in range(count)]}


def orders(count: int, current: int = -1) -> dict[str, Any]:
    listed = [{"id": n, "start": n, "end": n, "status": "Q"} for n in range(1, count + 1)]
    return {"last_order_id": count, "current_order_id": current, "orders": listed}


def graph(count: int) -> dict[str, Any]:
    vertices = [{"id": n, "x": n % 300, "y": n // 300, "type": "way"} for n in range(count)]
    edges = [{"id": n, "start": n, "end": n // 2} for n in range(count)]
    return {"vertices": vertices, "edges": edges}


def test_a_label_of_a_megabyte() -> None:
    event = received("labels", {"vertices": [{"label": MEGABYTE, "vertex_id": 1}]})
    assert isinstance(event, events.LabelsReceived)
    assert event.labels["1"] == f"{MEGABYTE[: bounds.LONGEST_NAME]}… (1,000,000 characters)"
    assert not event.faults


def test_a_hundred_thousand_labels() -> None:
    event = received("labels", labels(100_000))
    assert isinstance(event, events.LabelsReceived)
    assert (len(event.labels), event.faults) == (bounds.MOST_LABELS, 1)
    assert event.fault == "labels of floor_0: 100,000 labels: only the first 20,000 used"
    state = reduced(fleet(), link_up(T0), pose(T0), event, tick(T0), tick(T0 + 5))
    assert any("100,000 labels: only the first" in row for row in shown(state))


def test_as_many_labels_as_are_taken_are_no_fault() -> None:
    event = received("labels", labels(bounds.MOST_LABELS))
    assert isinstance(event, events.LabelsReceived)
    assert (len(event.labels), event.faults, event.fault) == (bounds.MOST_LABELS, 0, "")


def test_a_queue_of_a_hundred_thousand_orders_keeps_the_current_one_wherever_it_is() -> None:
    event = received("queue", orders(100_000, current=77_777))
    assert isinstance(event, events.QueueReported)
    assert len(event.queue.orders) == bounds.MOST_ORDERS + 1
    assert event.queue.current is not None and event.queue.current.id == "77777"
    assert (event.queue.last_serial, event.queue.orders[0].id) == (100_000, "1")
    state = reduced(
        fleet(2), link_up(T0), pose(T0), received("graph", graph(20_000)), event, tick(T0), tick(T0 + 5)
    )
    rows = shown(state)
    assert any("100,000 orders: only the first 500 used" in row for row in rows)


def test_a_queue_that_fits_is_no_fault() -> None:
    event = received("queue", orders(bounds.MOST_ORDERS, current=3))
    assert isinstance(event, events.QueueReported)
    assert (len(event.queue.orders), event.fault) == (bounds.MOST_ORDERS, "")


def test_a_graph_beyond_the_bound() -> None:
    event = received("graph", graph(60_000))
    assert isinstance(event, events.GraphReceived)
    assert len(event.graph.vertices) == bounds.MOST_VERTICES
    assert event.fault == "graph of floor_0: 60,000 vertices: only the first 20,000 used"
    shown(reduced(fleet(), link_up(T0), event, received("labels", labels(20_000)), pose(T0), tick(T0)))


def test_a_hundred_thousand_vertices_are_more_than_is_read_at_all() -> None:
    with pytest.raises(WireError, match=r"bytes: the limit is 8,388,608"):
        received("graph", graph(100_000))


def test_a_status_and_a_frame_id_of_a_megabyte() -> None:
    event = received("queue", {**orders(0), "orders": [{"id": 1, "start": 1, "end": 1, "status": MEGABYTE}]})
    assert isinstance(event, events.QueueReported)
    assert len(event.queue.orders[0].word) < bounds.LONGEST_NAME + 30
    state = reduced(fleet(), link_up(T0), event, pose(T0, frame=MEGABYTE), tick(T0))
    assert len(state.robots[R0].frame_id) < bounds.LONGEST_NAME + 30 and state.robots[R0].floor is None
    shown(state)


def longest(value: object) -> int:
    """The characters of the longest text anywhere in a state."""
    match value:
        case str():
            return len(value)
        case dict():
            return max(map(longest, value.values()), default=0)
        case tuple() | list():
            return max(map(longest, value), default=0)
    fields = getattr(value, "__struct_fields__", ())
    return max((longest(getattr(value, name)) for name in fields), default=0)


def test_no_text_from_outside_is_kept_longer_than_its_bound() -> None:
    command = events.CommandIssued(1, PauseRobot(R0), T0, T0)
    state = reduced(
        fleet(),
        link_up(T0),
        events.MessageRejected(R0, verbatim(MEGABYTE)),
        events.FrameRejected(LINK, MEGABYTE),
        events.CommandPathChanged(LINK, CommandPath.DEAD, verbatim(MEGABYTE)),
        events.FloorMapLoaded(F0, None, verbatim(MEGABYTE)),
        command,
        events.CommandAdvanced(1, Stage.SENT, T0),
        events.CommandAdvanced(1, Stage.REFUSED, T0, verbatim(MEGABYTE)),
        tick(T0),
        link_lost(T0, MEGABYTE),
        tick(T0 + 60),
    )
    assert bounds.LONGEST_WORDS < longest(state) < 2 * bounds.LONGEST_WORDS
    assert state.robots[R0].last_fault.endswith("… (1,000,000 characters)")
    shown(state)


@pytest.mark.parametrize(
    "values",
    [MEGABYTE, {"success": False, "status": MEGABYTE}, {"x": MEGABYTE}, [[]] * 100_000, None],
    ids=lambda values: type(values).__name__,
)
@pytest.mark.parametrize("result", [True, False])
def test_what_is_kept_of_an_answer_is_short(values: object, result: bool) -> None:
    _, detail = ADAPTER.outcome(PauseRobot("robot_0"), values, result)
    assert len(detail) < 2 * bounds.LONGEST_WORDS


def test_an_answer_as_long_as_it_may_be_is_judged_soon() -> None:
    stage, _ = ADAPTER.outcome(
        PauseRobot("robot_0"), {"success": True, "status": "no " * (operations.LARGEST_ANSWER // 3)}, True
    )
    assert stage is Stage.ACCEPTED


def test_an_answer_nested_too_deep_is_none() -> None:
    nested: list[Any] = []
    for _ in range(100_000):
        nested = [nested]
    stage, detail = ADAPTER.outcome(PauseRobot("robot_0"), nested, True)
    assert (stage, detail) == (Stage.UNKNOWN, "unrecognised reply: nested too deep")


def test_an_answer_beyond_the_bound_is_not_read() -> None:
    frame = {"op": "service_response", "id": "1", "values": {"a": "x" * operations.LARGEST_ANSWER}}
    answer = operations.decode(json.dumps(frame).encode())
    assert isinstance(answer, operations.ServiceResponse)
    stage, detail = ADAPTER.outcome(PauseRobot("robot_0"), answer.values, True)
    assert stage is Stage.UNKNOWN and "4,194,313 bytes, too large to read" in detail


def test_what_a_bridge_says_beyond_the_bound_is_not_read() -> None:
    said = operations.decode(b'{"op":"status","level":"error","msg":[%s1]}' % (b"{}," * 6_000_000))
    assert said == operations.Status("error", "18,000,003 bytes, too large to read")


HEAD = b"\xa3\x62op\x67publish\x65topic\x62/a\x63msg"
LONG = b"\x5a" + (2**21).to_bytes(4, "big") + bytes(2**21)


def test_a_large_binary_message_holds_the_cells_of_a_map_and_little_else() -> None:
    read = operations.decode_cbor(HEAD + b"\xa2\x61x\x5a\0\0\0\1Z\x64data\xd8\x48" + LONG)
    assert isinstance(read, operations.Publish)
    assert read.msg == {"x": b"Z", "data": cbor2.CBORTag(72, bytes(2**21))}
    lists = b"\x9a" + (2**21).to_bytes(4, "big") + b"\x80" * 2**21
    for hostile in (lists, b"\x82" + lists + LONG, b"\x82\x78\x05" + LONG[:5] + lists):
        with pytest.raises(WireError, match=r"^binary frame of "):
            operations.decode_cbor(HEAD + hostile)


def test_a_map_may_be_larger_than_other_messages() -> None:
    read = messages.reader(messages.OccupancyGridMessage)
    still = {"position": {"x": 0, "y": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}
    info = {"resolution": 1, "width": 1, "height": 1, "origin": still}
    data = [0] * (messages.LARGEST // 2)
    assert len(read(msgspec.Raw(json.dumps({"info": info, "data": data}).encode())).data) == len(data)


def test_who_is_not_in_the_config_adds_nothing() -> None:
    before = initial_state(config_of("ws://site:9090"), T0)
    state = before
    for n in range(1000):
        for event in (
            pose(T0, robot=f"stranger_{n}"),
            events.LabelsReceived(f"stranger_{n}", F0, {"1": "a"}),
        ):
            state = apply(state, event)
    assert state.robots == before.robots
    for n in range(1000):
        state = apply(state, pose(T0 + n, frame=f"floor_{n}"))
    assert set(state.robots[R0].maps) == set(before.robots[R0].maps) and set(state.floors) == {F0}
