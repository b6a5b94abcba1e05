"""Records read back as written, to the last bit."""

import math
from functools import partial

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.config.schema import Link
from fleet_tui.model import events
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import build_grid
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.recording.records import (
    EventRecord,
    Keyframe,
    Lost,
    Mark,
    Packer,
    ReceivedFrame,
    RecordingError,
    RecordingHeader,
    SentFrame,
    decode,
    encode,
    public,
)
from fleet_tui.text.language import EMPTY
from tests.support.any_events import ANY, FACTS
from tests.support.fleets import battery, fleet, graph, labels, pose, reduced, tick
from tests.support.recordings import header, keyframe, plain
from tests.support.watched_store import config_of

NUMBERS = st.floats()
GRID = build_grid(MapFrame(0.05, 5, 3, Pose(-1.0, 2.0)), np.arange(15, dtype=np.uint8).reshape(3, 5) % 3)


def again(
    record: RecordingHeader | Keyframe | ReceivedFrame | SentFrame | EventRecord | Mark | Lost,
) -> object:
    line = encode(record, Packer())
    assert line.count(b"\n") == 1
    return decode(line)


@given(st.one_of(*FACTS.values()), NUMBERS, NUMBERS)
def test_every_fact_is_read_as_it_was(event: events.Event, at: float, wall: float) -> None:
    # JSON has no number for what is not finite, and records have no such time.
    record = EventRecord(at, wall, event) if math.isfinite(at + wall) else EventRecord(0.0, 0.0, event)
    assert plain(again(record)) == plain(record)


@given(NUMBERS, NUMBERS, st.none() | NUMBERS)
def test_any_number_is_read_as_it_was(x: float, y: float, stamp: float | None) -> None:
    event = events.PoseReported("robot_0", x, Pose(x, y, -0.0), "floor_0", stamp)
    assert plain(again(EventRecord(1.0, 2.0, event))) == plain(EventRecord(1.0, 2.0, event))


@given(ANY)
def test_every_state_is_read_as_it_was(facts: list[events.Event]) -> None:
    state = reduced(fleet(2, 2), *facts)
    record = Keyframe.of(1.0, 2.0, state, Packer())
    read = again(record)
    assert isinstance(read, Keyframe)
    assert plain(read.fleet_state()) == plain(state)


def test_a_state_goes_on_after_it_was_read_as_before() -> None:
    """Alarms that are under way, clocks of robots and graphs: all of it matters for what comes next."""
    state = reduced(fleet(), graph(1, 2, 3), labels({1: "Base"}), pose(1000.2, 1.0, stamp=7.0))
    state = reduced(state, battery(1000.3, 5.0), *(tick(1000.0 + n) for n in range(1, 4)))
    assert state.alarms and state.began
    read = keyframe(1000.0, state).fleet_state()
    later: list[events.Event] = [battery(1004.2, 8.0), *(tick(1004.0 + n) for n in range(1, 90))]
    assert plain(reduced(read, *later)) == plain(reduced(state, *later))


def test_maps_are_read_with_their_pyramid() -> None:
    for event in (
        events.FloorMapLoaded("floor_0", GRID, EMPTY, False),
        events.GridReceived("robot_0", "floor_0", GRID),
    ):
        assert plain(again(EventRecord(1.0, 2.0, event))) == plain(EventRecord(1.0, 2.0, event))
    routes = events.FloorGraphLoaded("floor_0", graph(1, 2).graph, {"1": "Base"}, "one fault")
    assert again(EventRecord(1.0, 2.0, routes)) == EventRecord(1.0, 2.0, routes)
    state = reduced(fleet(), events.FloorMapLoaded("floor_0", GRID), routes)
    assert plain(keyframe(1.0, state).fleet_state()) == plain(state)


@given(st.text(st.characters(exclude_categories=["Cs"])), st.binary())
def test_frames_are_read_as_they_were(text: str, data: bytes) -> None:
    assert again(ReceivedFrame(1.0, 2.0, "rosbridge", "topics", text)) == ReceivedFrame(
        1.0, 2.0, "rosbridge", "topics", text
    )
    binary = ReceivedFrame(1.0, 2.0, "rosbridge", "topics", data=data, binary=True, came=0.5)
    assert again(binary) == binary
    assert binary.payload == data
    assert again(SentFrame(1.0, 2.0, "rosbridge", "commands", text)) == SentFrame(
        1.0, 2.0, "rosbridge", "commands", text
    )


def test_the_others_are_read_as_they_were() -> None:
    origin = Origin("ana", "here:1", "r")
    entry = origin.record(1.7e9, kind="alarm", what="offline", change="raised")
    for record in (header(), Mark(1.0, 2.0, entry), Lost(1.0, 2.0, 7, "the disk is full")):
        assert again(record) == record


def test_what_cannot_be_written_is_said_before_anything_is() -> None:
    with pytest.raises(ValueError, match="surrogate"):
        encode(ReceivedFrame(1.0, 2.0, "rosbridge", "topics", "\ud800"), Packer())


@pytest.mark.parametrize(
    "line",
    [
        b"",
        b"{",
        b"[]",
        b'{"kind":"gossip"}',
        b'{"kind":"told","at":1,"wall":2,"event":{"type":"Told"}}',
        b'{"kind":"lost","at":1,"wall":2,"records":[],"why":""}',
        b'{"kind":"lost","at":' + b"[" * 100_000,
        b'{"kind":"heard","at":1,"wall":2,"link":"a","channel":"b","text":"\xff"}',
    ],
)
def test_what_is_no_record_is_refused(line: bytes) -> None:
    with pytest.raises(RecordingError, match="unreadable record"):
        decode(line)


def test_a_map_that_stands_for_more_than_it_says_is_refused() -> None:
    bomb = Packer()(build_grid(MapFrame(1.0, 1000, 1000), np.zeros((1000, 1000), np.uint8))).cells
    for frame, why in (
        (MapFrame(1.0, 10, 10), "with 101 cells"),
        (MapFrame(1.0, 100_000, 100_000), "exceeds 100,000,000 px"),
        (MapFrame(math.nan, 10, 10), "resolution"),
        (MapFrame(1.0, -10, -10), "size"),
    ):
        hostile = GRID.__class__(frame, GRID.levels)
        packer = Packer()
        packer(hostile)
        packer._packed[id(hostile)] = hostile, type(packer(GRID))(frame, bomb)
        line = encode(EventRecord(1.0, 2.0, events.GridReceived("robot_0", "floor_0", hostile)), packer)
        with pytest.raises(RecordingError, match=why):
            decode(line)


def test_no_secret_is_in_a_config() -> None:
    hush = partial(Link, authorization_env="hush", authorization_file="hush", rosauth_file="hush")
    config = config_of("ws://ana:hush@a:1/?token=hush")
    links = {"b": hush("ws://ana:hush@a:1/?token=hush", client_key="hush")}
    kept = encode(header(public(type(config)(hush("ws://u:hush@a:1/x?hush"), links))), Packer())
    assert b"hush" not in kept
    assert b"ws://***@a:1/x" in kept
