"""Records of a recording as events: frames are read as on the link, answers are not read twice."""

import json

from fleet_tui.model.events import TimePassed
from fleet_tui.records.recording.play.frames import Frames
from fleet_tui.records.recording.records import EventRecord, ReceivedFrame, Record, SentFrame
from tests.support.fleets import LINK, R0, T0, fleet
from tests.support.watched_store import config_of

CONFIG = config_of("ws://site:9090")


def frame(topic: str, msg: object, channel: str = "topics", link: str = LINK) -> ReceivedFrame:
    text = json.dumps({"op": "publish", "topic": topic, "msg": msg})
    return ReceivedFrame(T0 + 5, 0.0, link, channel, text, came=T0 + 3)


def test_a_frame_makes_its_event_at_the_time_it_came_and_counts() -> None:
    frames = Frames(CONFIG)
    state = frames.after(fleet(), frame(f"/{R0}/battery", {"data": 55.0}))
    found = state.robots[R0].battery
    assert found is not None and (found.value, found.at) == (55.0, T0 + 3)
    assert frames.counters[LINK].topics[f"/{R0}/battery"].last
    frames.recount()
    assert not frames.counters[LINK].topics[f"/{R0}/battery"].last


def test_an_event_is_taken_as_it_was_recorded() -> None:
    assert Frames(CONFIG).after(fleet(), EventRecord(T0, 0.0, TimePassed(T0 + 7, 1.0))).now == T0 + 7


def test_records_that_bring_no_event_change_nothing() -> None:
    state, frames = fleet(), Frames(CONFIG)
    answer = '{"op": "service_response", "id": "1", "service": "/s", "result": true}'
    others: list[Record] = [
        ReceivedFrame(T0, 0.0, LINK, "topics", answer),
        frame("/x", {}, channel="commands"),
        frame(f"/{R0}/battery", {"data": 5.0}, link="gone"),
        SentFrame(T0, 0.0, LINK, "topics", "{}"),
    ]
    for record in others:
        assert frames.after(state, record) is state
