"""Facts of a bridge that answers: round trips, and services that are called only where their type is sure."""

import asyncio
import time
from pathlib import Path

import pytest

from fleet_tui.config.schema import Config, Link
from fleet_tui.console.demo import demo_config
from fleet_tui.features.doctor import gather
from fleet_tui.features.doctor.gather import gather as gathered
from fleet_tui.features.doctor.gather import measure_calls
from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import Message
from tests.support.asked_rosapi import AskedRosapi, CountedQuestions
from tests.support.watched_store import config_of


class Beating(AskedRosapi):
    """A bridge that answers so many calls."""

    def __init__(self, answers: int, lost: str = "") -> None:
        super().__init__()
        self._answers, self._lost = answers, lost

    async def beat(self, _within: float) -> str:
        self._answers -= 1
        if self._answers < 0:
            self.lost = self._lost
            raise LinkError(Message("no answer"))
        return "service does not exist"


@pytest.mark.parametrize(
    ("answers", "lost", "count"), [(99, "", gather.ROUND_TRIPS), (3, "gone", 3), (3, "", 3), (0, "gone", 0)]
)
async def test_round_trips_end_with_the_first_that_is_not_answered(
    answers: int, lost: str, count: int
) -> None:
    trips = await measure_calls(Beating(answers, lost).wire, time.monotonic() + 5)
    assert len(trips) == count and all(0.0 <= trip < 10.0 for trip in trips)


async def test_a_bridge_that_answers_nothing_is_measured_by_the_wait() -> None:
    assert len(await measure_calls(Beating(0).wire, time.monotonic() + 0.05)) >= 1
    assert await measure_calls(Beating(99).wire, time.monotonic() - 1) == ()


async def test_everything_of_a_bridge_is_gathered_and_no_command_is_called(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fleet_tui.features.doctor.listening.AT_LEAST", 0.2)

    async def gather_all() -> BridgeFacts:
        wire = BridgeConnection(Link(server.url))
        try:
            assert not await wire.connect(5.0)
            return await gathered(config_of(server.url, 2, 2), "rosbridge", wire, time.monotonic() + 10)
        finally:
            wire.close()

    facts = await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(gather_all(), network_loop()))
    assert facts.busy_trips, "questions beside the messages"
    assert len(facts.round_trips) == gather.ROUND_TRIPS and facts.ahead is not None and not facts.lost
    assert facts.rosapi.ros == 1 and not facts.rosapi.problem
    assert all(one.count for one in facts.topics if not one.wanted.large)
    maps = [one for one in facts.topics if one.wanted.large]
    assert sum(one.subscribed for one in maps) == 2, "of each floor one is enough"
    pause = "/robot_0/Application_layout/Pause"
    assert facts.rosapi.services[pause] == "std_srvs/Trigger" and facts.rosapi.owners[pause]
    assert not server.bridge.services.calls


async def test_over_all_its_connections_two_questions_at_once_go_to_rosapi_of_ros_2(tmp_path: Path) -> None:
    server = RosbridgeServer(Nav2Fleet(2, 1, seed=1, quiet=True), dialect=ROS2)
    server.bridge.muted.add("/map")  # who holds it is asked for meanwhile
    questions = CountedQuestions(0.4)
    server.bridge.services.deliveries |= dict.fromkeys(
        server.bridge.services.rosapi.services, questions.deliver
    )
    await server.start()
    config = demo_config(Config(), server.url, 2, 1, "2", "nav2", tmp_path)

    async def gather_all() -> BridgeFacts:
        wire = BridgeConnection(Link(server.url))
        try:
            assert not await wire.connect(5.0)
            return await gathered(config, "rosbridge", wire, time.monotonic() + 20)
        finally:
            wire.close()

    try:
        await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(gather_all(), network_loop()))
    finally:
        await server.stop()
    asked = [one.get("service") for one in server.bridge.received]
    assert "/rosapi/subscribers" in asked and questions.most == 2
