"""Taps: every frame in both directions, and every event without a frame."""

import json

from fleet_tui.model import events
from fleet_tui.model.commands import PauseRobot
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.adapters import adapter_of
from tests.support.ear import Ear
from tests.support.links import finished, linked, ready
from tests.support.watched_store import config_of


async def test_a_command_is_heard_as_it_leaves_and_as_it_is_answered(server: RosbridgeServer) -> None:
    ear = Ear()
    async with linked(config_of(server.url, 1), ear) as (link, store):
        await store.until(ready)
        await finished(link, store, PauseRobot("robot_0"))
    sent = [json.loads(payload) for _, channel, payload in ear.sent_frames if channel == "commands"]
    (pause,) = [frame for frame in sent if frame["service"].endswith("/Pause")]
    answers = [json.loads(payload) for _, channel, payload, _ in ear.heard_frames if channel == "commands"]
    assert [frame["result"] for frame in answers if frame["id"] == pause["id"]] == [True]
    kinds = [type(fact) for fact in ear.facts]
    assert kinds.count(events.CommandIssued) == 1
    assert events.CommandAdvanced in kinds
    assert events.TimePassed in kinds


async def test_what_frames_bring_is_not_told_twice(server: RosbridgeServer) -> None:
    ear = Ear()
    config = config_of(server.url, 2)
    async with linked(config, ear) as (_, store):
        await store.until(ready)
        topics = [json.loads(payload) for _, channel, payload, _ in ear.heard_frames if channel == "topics"]
        brought = [event for event in store.events if event not in ear.facts]
    assert brought
    assert not [fact for fact in ear.facts if isinstance(fact, events.Telemetry | events.MapFactReceived)]
    published = {frame["topic"] for frame in topics if frame["op"] == "publish"}
    keys = {feed.key for feed in adapter_of(config.profile).feeds("robot_0", ["floor_0"]) if not feed.large}
    assert {topic.rsplit("/", 1)[-1] for topic in published} >= keys - {"graph", "labels", "map_metadata"}
    subscribed = {json.loads(payload).get("topic") for _, _, payload in ear.sent_frames}
    assert published <= subscribed
