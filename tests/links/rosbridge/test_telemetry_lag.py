"""A console that does not keep up: it says so, blames no robot, and reads only what is newest."""

import time

import pytest

from fleet_tui.model.fleet import behind_text
from fleet_tui.robots.ros.reading import FrameReader, Read
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.situation.links import LATE_FROM
from tests.support.links import linked, ready
from tests.support.polling import HANGS
from tests.support.watched_store import config_of

ROBOTS = 10


async def test_a_console_that_is_behind_says_so_and_blames_no_robot(monkeypatch: pytest.MonkeyPatch) -> None:
    server = RosbridgeServer(OhFleet(robots=ROBOTS, floors=1, seed=1, quiet=True))
    await server.start()
    read, slowness = FrameReader.read, 0.0

    def slow(self: FrameReader, payload: bytes, is_binary: bool, at: float) -> Read:
        time.sleep(slowness)  # the slowness itself
        return read(self, payload, is_binary, at)

    monkeypatch.setattr(FrameReader, "read", slow)
    try:
        async with linked(config_of(server.url, ROBOTS)) as (link, store):
            await store.until(ready)
            slowness = 0.05  # with some 200 messages a second
            counter = link.counters["rosbridge"]
            state = await store.until(
                lambda state: any(alarm.condition.kind == "behind" for alarm in state.alarms), within=HANGS
            )
            assert behind_text(state).startswith("this console is ")
            await store.until(lambda _: counter.overtaken > 50, within=HANGS)
            assert {alarm.condition.source for alarm in store.state.alarms} == {"console"}
            assert all(map(store.state.is_online, store.state.robots.values()))
            slowness = 0.0
            state = await store.until(lambda state: state.behind < LATE_FROM / 2)
            await store.until(lambda state: all(map(state.is_online, state.robots.values())))
            seen = counter.overtaken
            count = counter.all.count
            await store.until(lambda _: counter.all.count > count + 100)
            assert counter.overtaken < seen + 50
    finally:
        await server.stop()
