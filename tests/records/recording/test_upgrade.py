"""Files of format 1, from before ids became text, still mean what they meant.

of_version_1/ was made by the last program that wrote that format: a console on a simulator with two robots
(25 times as fast, a keyframe every 4 s) that placed orders, one of them from a vertex that does not exist
and one for cargo on board, cancelled, cleared, paused and resumed. meaning.json.gz is what that program
itself then read from both files: the queue pane, each command and the alarms at each keyframe and at the end,
and the lines and the CSV of the audit log.
"""

import gzip
import json
import math
import re
from pathlib import Path
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.commands.language.grammar import written
from fleet_tui.model.events import GraphReceived, LabelsReceived, QueueReported
from fleet_tui.model.fleet import FleetState, Limits
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.records.audit.line import line_text
from fleet_tui.records.recording import upgrade
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.play.cursor import RecordingCursor
from fleet_tui.records.recording.records import EventRecord, RecordingError, decode
from fleet_tui.ui.view.tables.queue import queue_table
from tests.support.fleets import order, order_queue, text_of

FILES = Path(__file__).parent / "of_version_1"
RECORDING = FILES / "recording.jsonl.gz"
MEANING: dict[str, Any] = json.loads(gzip.decompress((FILES / "meaning.json.gz").read_bytes()))


def shown(state: FleetState) -> dict[str, Any]:
    """The rows that an operator sees of a state, without the padding and the commas of their columns."""
    rows = [text_of(row.runs) for row in queue_table(state, "robot_0", True, 56).rows]
    rows = [" ".join(row.replace(",", "").split()) for row in rows]
    commands = [
        [written(one.command, state), one.stage.value, one.detail, one.order_id] for one in state.commands
    ]
    return {"queue": rows, "commands": commands, "alarms": [alarm.text for alarm in state.alarms]}


def expected(meant: dict[str, Any]) -> dict[str, Any]:
    """Today the position is left out, and the robot's letter where its state is known."""
    rows = [re.sub(r"^(\S+) +\d+ +", r"\1 #", row) for row in meant["queue"]]
    return meant | {"queue": [" ".join(row.replace("W in process", "in process").split()) for row in rows]}


def causes_first(meant: dict[str, Any]) -> dict[str, Any]:
    """Today an alarm that is raised begins with its cause."""
    parts = r"^(\w+): (order .*) \((.*)\)$"
    return meant | {"alarms": [re.sub(parts, r"\1: \3 (\2)", text) for text in meant["alarms"]]}


def test_a_recording_plays_as_it_did() -> None:
    recording = open_recording(RECORDING)
    assert recording.header.version == 1 and not recording.note
    head = RecordingCursor(recording)
    while head.take() is not None:
        pass
    assert shown(head.state) == causes_first(expected(MEANING["end"]))
    assert not any(robot.faults for robot in head.state.robots.values())
    for moment, meant in zip(recording.keyframes, MEANING["keyframes"], strict=True):
        head.seek(moment.at)
        assert shown(head.state) == expected(meant)


def test_facts_of_an_old_recording_that_no_frame_brought_are_read() -> None:
    """A converted bag has none; a program of that version could have told them."""
    orders = [{"id": 4, "start": 1, "end": 2, "status": "W"}, {"id": -5, "start": 2, "end": 1, "status": "?"}]
    listed = (order(4, 1, 2, "W"), order(-5, 2, 1, "?"))
    queue = {"last_order_id": 5, "current_order_id": 4, "orders": orders, "request_id": 9}
    vertices = {"1": {"id": 1, "x": 0.0, "y": "inf", "role": "docking"}}
    routes = {"vertices": vertices, "edges": [{"id": 7, "start": 1, "end": 1}], "directed": True}
    about = {"robot": "r", "floor": "f", "faults": 0, "fault": ""}
    for event, meant in (
        (
            {"type": "QueueReported", "robot": "r", "at": 1.0, "queue": queue, "fault": ""},
            QueueReported("r", 1.0, order_queue(5, 4, *listed, request_id=9)),
        ),
        (
            {"type": "GraphReceived", "graph": routes, **about},
            GraphReceived(
                "r",
                "f",
                RouteGraph(
                    {"1": Vertex("1", 0.0, math.inf, Role.DOCKING)}, (Edge("7", "1", "1"),), directed=True
                ),
            ),
        ),
        (
            {"type": "LabelsReceived", "labels": {"1": "Base"}, **about},
            LabelsReceived("r", "f", {"1": "Base"}),
        ),
    ):
        record = decode(msgspec.json.encode({"kind": "told", "at": 1.0, "wall": 1.0, "event": event}), 1)
        assert isinstance(record, EventRecord) and record.event == meant


def test_the_marks_of_a_recording_read_as_they_did() -> None:
    marks = open_recording(RECORDING).marks
    assert [line_text(mark.record) for mark in marks] == MEANING["marks"]


ANYTHING = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=8,
)
KINDS = st.sampled_from(["told", "mark", "header", "keyframe", "lost", ""])
EVENTS = st.sampled_from([*upgrade._EVENTS, "TimePassed"])


@given(
    KINDS,
    EVENTS,
    st.dictionaries(st.sampled_from(["command", "queue", "graph", "labels"]), ANYTHING),
    ANYTHING,
)
def test_a_damaged_record_is_refused_with_a_reason(
    kind: str, event: str, fields: dict[str, Any], record: object
) -> None:
    line = {"kind": kind, "at": 1.0, "wall": 1.0, "event": {"type": event, **fields}, "record": record}
    with pytest.raises(RecordingError, match="unreadable record"):
        decode(msgspec.json.encode(line), 1)


def test_limits_of_older_recordings_latch_every_class_of_alarms() -> None:
    assert msgspec.json.decode(b"{}", type=Limits).latched is None
