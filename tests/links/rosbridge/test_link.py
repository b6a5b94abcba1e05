"""One bridge behind two connections: commands on their own, each attempt of which is reported once."""

import asyncio
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from fleet_tui.config.fleet import adapters_of
from fleet_tui.config.start import initial_state
from fleet_tui.links.rosbridge.link import BridgeLink
from fleet_tui.links.writer import Writer
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued
from fleet_tui.model.link import CommandPath
from fleet_tui.simulator.calls import Call
from fleet_tui.simulator.frames import Frame
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.links import path
from tests.support.polling import HANGS
from tests.support.watched_store import WatchedStore, config_of

PAUSE = "/robot_0/Application_layout/Pause"


@asynccontextmanager
async def opened(server: RosbridgeServer) -> AsyncIterator[tuple[BridgeLink, WatchedStore]]:
    config = config_of(server.url)
    store = WatchedStore(initial_state(config, time.monotonic()))
    writer = Writer(store)
    link = BridgeLink("rosbridge", config, adapters_of(config), writer)
    writer.start()
    link.open()
    try:
        yield link, store
    finally:
        link.close()
        writer.stop()


async def test_a_command_goes_its_own_way_and_its_progress_is_told(server: RosbridgeServer) -> None:
    async with opened(server) as (link, store):
        await store.until(path(CommandPath.ALIVE))
        await store.until(lambda state: state.robots["robot_0"].pose)
        now = time.monotonic()
        store.apply(CommandIssued(7, PauseRobot("robot_0"), now, time.time()))
        link.writer.loop.call_soon_threadsafe(link.submit_now, 7, PauseRobot("robot_0"), now)
        state = await store.until(lambda state: state.commands[0].stage is Stage.ACCEPTED)
        assert [step.stage for step in state.commands[0].steps] == [Stage.CHECKED, Stage.SENT, Stage.ACCEPTED]
        advanced = len(store.told(CommandAdvanced))
        link.writer.loop.call_soon_threadsafe(link.resend, PauseRobot("robot_0"))
        async with asyncio.timeout(HANGS):
            while len(server.bridge.services.calls) < 2:  # noqa: ASYNC110  # a bridge does not tell
                await asyncio.sleep(0)
        assert len(store.told(CommandAdvanced)) == advanced, "only the first attempt is reported"
        assert [service for service, _ in server.bridge.services.calls] == [PAUSE, PAUSE]


async def test_closing_leaves_no_connection_behind(server: RosbridgeServer) -> None:
    async with opened(server) as (_, store):
        await store.until(lambda state: state.robots["robot_0"].pose)
    async with asyncio.timeout(HANGS):
        while server.bridge.subscribers("/robot_0/pose"):  # noqa: ASYNC110  # nobody tells that a client left
            await asyncio.sleep(0)


class Outstanding:
    """Delays the answers of rosapi, and counts the questions that wait for one."""

    def __init__(self, server: RosbridgeServer, seconds: float) -> None:
        self._seconds = seconds
        self._now = 0
        self.most = 0
        self.asked = 0
        services = server.bridge.services
        services.deliveries |= dict.fromkeys(services.rosapi.services, self._deliver)

    def _deliver(self, call: Call, frame: Frame) -> None:
        self.asked += 1
        self._now += 1
        self.most = max(self.most, self._now)
        asyncio.get_running_loop().call_later(self._seconds, self._answer, call, frame)

    def _answer(self, call: Call, frame: Frame) -> None:
        self._now -= 1
        call.reply(frame)


async def test_two_questions_at_once_go_to_rosapi_over_all_connections_of_a_bridge(
    server: RosbridgeServer,
) -> None:
    outstanding = Outstanding(server, 0.1)
    async with opened(server) as (_, store):
        await store.until(lambda state: path(CommandPath.ALIVE)(state) and outstanding.asked > 10)
    assert outstanding.most == 2
