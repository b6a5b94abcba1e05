"""A console that is sent more than it can read says what it passes over, and goes on."""

import threading

import pytest

from fleet_tui.links.rosbridge import telemetry
from fleet_tui.model.commands import Stage
from fleet_tui.robots.ros.reading import FrameReader, Read
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.watched_store import config_of

LARGE = '{"op":"publish","topic":"/robot_1/cargo","msg":{"data":true}%s}' % (" " * 150_000)


async def test_what_is_passed_over_is_said(server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch) -> None:
    reads, is_held, read = threading.Event(), threading.Event(), FrameReader.read
    reads.set()

    def held(self: FrameReader, payload: bytes, is_binary: bool, at: float) -> Read:
        if len(payload) > 100_000:
            is_held.set()
            reads.wait(30)
        return read(self, payload, is_binary, at)

    monkeypatch.setattr(FrameReader, "read", held)
    monkeypatch.setattr(telemetry, "MOST_WAITING", 200_000)
    async with console(config_of(server.url, 2), size=(200, 50)) as it:
        reads.clear()
        server.bridge.publish_raw("/robot_1/cargo", LARGE)
        await it.until(lambda _: is_held.is_set())
        for _ in range(4):
            server.bridge.publish_raw("/robot_1/cargo", LARGE)
        await it.shows("3 bad frames")
        await it.shows("bad data x3: 150,061 bytes dropped", "alarms")
        await it.press("p")
        await it.until(lambda state: state.commands and state.commands[-1].stage is Stage.CONFIRMED)
        reads.set()
        await it.until(lambda state: state.robots["robot_1"].has_cargo)
