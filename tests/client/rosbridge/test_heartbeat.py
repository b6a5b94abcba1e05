"""The command path, as the console tests it on a real loopback server."""

import pytest

from fleet_tui.client.rosbridge import heartbeat
from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import CommandPathChanged
from fleet_tui.model.link import CommandPath
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.links import finished, linked, path, ready
from tests.support.watched_store import config_of

PAUSE, RESUME = "/robot_0/Application_layout/Pause", "/robot_0/Application_layout/Resume"


async def test_a_frozen_rosapi_locks_nobody_out(server: RosbridgeServer) -> None:
    server.bridge.services.silent_services.update(
        f"/rosapi/{name}" for name in ("topics", "services", "get_time")
    )
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(path(CommandPath.ALIVE))
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED


async def test_a_probe_that_runs_out_after_an_answer_came_raises_nothing(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(heartbeat, "TIMEOUT", 1.0)
    monkeypatch.setattr(heartbeat, "EVERY", 60.0)
    server.bridge.services.silent_services.add(heartbeat.SERVICE)
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(lambda state: state.links["rosbridge"].commands_connected)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        round_trips = link.counters["rosbridge"].round_trips
        await store.until(lambda _: round_trips.unanswered)
        paths = [
            event.path for event in store.told(CommandPathChanged) if isinstance(event, CommandPathChanged)
        ]
    assert CommandPath.DEAD not in paths and CommandPath.ALIVE in paths


async def test_an_answer_to_a_command_is_life_at_once(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(heartbeat, "TIMEOUT", 0.2)
    monkeypatch.setattr(heartbeat, "EVERY", 60.0)
    server.bridge.services.silent_services.add(heartbeat.SERVICE)
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(path(CommandPath.DEAD))
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        assert store.state.links["rosbridge"].command_path is CommandPath.ALIVE
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.CONFIRMED


@pytest.mark.parametrize("rosapi_returns", [True, False])
async def test_a_master_that_is_back_without_its_nodes_is_told_until_they_are(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch, rosapi_returns: bool
) -> None:
    monkeypatch.setattr(heartbeat, "EVERY", 0.1)
    async with linked(config_of(server.url, 2)) as (_, store):
        await store.until(ready)
        server.bridge.services.master_alive = False
        await store.until(path(CommandPath.DEAD))
        there = dict(server.bridge.services.offered)
        server.bridge.services.offered.clear()
        server.bridge.services.rosapi_alive = rosapi_returns
        server.bridge.services.master_alive = True
        state = await store.until(path(CommandPath.UNREGISTERED))
        assert state.links["rosbridge"].command_reason == "robot nodes not registered: restart them"
        server.bridge.services.offered.update({name: one for name, one in there.items() if "robot_0" in name})
        server.bridge.services.rosapi_alive = True
        state = await store.until(
            lambda state: (
                state.links["rosbridge"].command_reason == "nodes of robot_1 not registered: restart them"
            )
        )
        server.bridge.services.offered.update(there)
        await store.until(path(CommandPath.ALIVE))
