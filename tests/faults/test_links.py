"""Several bridges in one console: each has its own state, and a dead one hurts no other."""

from collections.abc import AsyncIterator

import pytest
from msgspec.structs import replace

from fleet_tui.config.entries import RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fault_proxy import before, mute
from tests.support.fault_report import report
from tests.support.invariants import linked
from tests.support.links import finished
from tests.support.proxied_link import Stopwatch
from tests.support.watched_store import config_of


@pytest.fixture
async def other() -> AsyncIterator[RosbridgeServer]:
    running = RosbridgeServer(OhFleet(robots=2, floors=2, seed=2, quiet=True))
    await running.start()
    yield running
    await running.stop()


def two_sites(first: str, second: str) -> Config:
    robots = [RobotEntry("robot_0"), RobotEntry("robot_1", link="b")]
    return replace(config_of(first), robots=robots, links={"b": Link(second)})


def both_up(state: FleetState) -> bool:
    commands = all(link.command_path is CommandPath.ALIVE for link in state.links.values())
    robots = [robot.pose and robot.paused for robot in state.robots.values()]
    return commands and all(robots) and all(link.phase is Phase.UP for link in state.links.values())


async def test_a_dead_bridge_hurts_no_other(server: RosbridgeServer, other: RosbridgeServer) -> None:
    async with before(other.url) as proxy, linked(two_sites(server.url, proxy.url)) as (link, store):
        await store.until(both_up)
        proxy.attend = mute
        watch = Stopwatch(store)
        proxy.cut()
        noticed = await watch.until(lambda state: state.links["b"].phase is Phase.WAITING)
        await store.until(lambda state: any(alarm.condition.source == "b" for alarm in state.alarms))
        assert store.state.links["rosbridge"].phase is Phase.UP
        assert {alarm.condition.source for alarm in store.state.alarms} <= {"b", "robot_1"}
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        refused = await finished(link, store, PauseRobot("robot_1"))
        assert refused.stage is Stage.NOT_SENT and "no link" in refused.detail
        assert store.state.is_online(store.state.robots["robot_0"])
        up_since = store.state.links["rosbridge"].since
        proxy.attend = proxy.relay
        watch.start()
        healed = await watch.until(both_up)
        assert store.state.links["rosbridge"].since == up_since
    services = [service for service, _ in other.bridge.services.calls]
    assert not any(service.endswith("Pause") for service in services)
    report(
        "one of two bridges dead",
        "it accepts connections and sends nothing",
        "an alarm of that bridge",
        noticed,
        healed,
    )


async def test_commands_go_to_the_robots_own_bridge(server: RosbridgeServer, other: RosbridgeServer) -> None:
    async with linked(two_sites(server.url, other.url)) as (link, store):
        await store.until(both_up)
        assert (await finished(link, store, PauseRobot("robot_1"))).stage is Stage.CONFIRMED
    assert [service.split("/")[1] for service, _ in other.bridge.services.calls] == ["robot_1"]
    assert not server.bridge.services.calls
    topics = {operation["topic"] for operation in server.bridge.received if operation["op"] == "subscribe"}
    assert all(topic.startswith("/robot_0/") for topic in topics)
