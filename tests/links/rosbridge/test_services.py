"""Services of the robots as the console knows them: which are gone, of another type, or not told yet."""

import asyncio
from dataclasses import replace

import pytest

from fleet_tui.links.rosbridge import heartbeat, services
from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.robots.oh_ressources.adapter import ABILITIES
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.links import finished, linked, path, phase, ready
from tests.support.polling import until
from tests.support.watched_store import config_of

PAUSE, RESUME = "/robot_0/Application_layout/Pause", "/robot_0/Application_layout/Resume"


async def test_a_robot_whose_services_have_gone_is_named_when_it_is_called(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        for name in list(server.bridge.services.offered):
            if "robot_0" in name:
                del server.bridge.services.offered[name]
        record = await finished(link, store, PauseRobot("robot_0"))
        assert record.stage is Stage.REFUSED and record.detail.endswith("does not exist")
        state = await store.until(path(CommandPath.UNREGISTERED))
        assert "nodes of robot_0 not" in state.links["rosbridge"].command_reason


async def test_a_service_of_another_type_is_not_called(server: RosbridgeServer) -> None:
    """`{}` is a command to some servers: to a lifecycle manager it is STARTUP."""
    manager = replace(server.bridge.services.offered[RESUME], name="nav2_msgs/srv/ManageLifecycleNodes")
    server.bridge.services.offered[RESUME] = manager
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        types_asked = [{"service": RESUME}, {"service": PAUSE}]
        await store.until(
            lambda _: all(
                any(one.get("args") == args for one in server.bridge.received if one["op"] == "call_service")
                for args in types_asked
            )
        )
        await finished(link, store, PauseRobot("robot_0"))
        record = await finished(link, store, ResumeRobot("robot_0"))
        assert record.stage is Stage.NOT_SENT
        assert f"{RESUME} has type nav2_msgs/srv/ManageLifecycleNodes, not std_srvs/Trigger" in record.detail
        server.bridge.services.silent_services.add("/rosapi/service_type")
        await server.restart_bridge()
        await store.until(lambda state: not phase(Phase.UP)(state))
        await store.until(ready)
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.NOT_SENT
    assert [service for service, _ in server.bridge.services.calls] == [PAUSE]


async def test_a_resume_waits_for_the_types_of_a_slow_rosapi_and_a_pause_only_for_its_own(
    server: RosbridgeServer,
) -> None:
    manager = replace(server.bridge.services.offered[RESUME], name="nav2_msgs/srv/ManageLifecycleNodes")
    server.bridge.services.offered[RESUME] = manager
    server.bridge.services.frozen["/rosapi/services"] = 2.0
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(phase(Phase.UP))
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is not Stage.NOT_SENT
        record = await finished(link, store, ResumeRobot("robot_0"))
        assert record.stage is Stage.NOT_SENT and "ManageLifecycleNodes" in record.detail
    assert [service for service, _ in server.bridge.services.calls] == [PAUSE]


async def test_a_pause_asks_for_the_type_of_its_service_before_it_leaves(server: RosbridgeServer) -> None:
    manager = replace(server.bridge.services.offered[PAUSE], name="nav2_msgs/srv/ManageLifecycleNodes")
    server.bridge.services.offered[PAUSE] = manager
    server.bridge.services.frozen["/rosapi/services"] = 2.0
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(phase(Phase.UP))
        record = await finished(link, store, PauseRobot("robot_0"))
        assert record.stage is Stage.NOT_SENT and "ManageLifecycleNodes" in record.detail
    assert not server.bridge.services.calls


async def test_a_pause_leaves_at_last_without_a_type(server: RosbridgeServer) -> None:
    server.bridge.services.silent_services.update(server.bridge.services.rosapi.services)
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(phase(Phase.UP))
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED


async def test_a_pause_that_waits_for_a_type_leaves_as_the_console_is_closed(server: RosbridgeServer) -> None:
    server.bridge.services.silent_services.update(server.bridge.services.rosapi.services)
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(phase(Phase.UP))
        link.submit(PauseRobot("robot_0"))
        await asyncio.sleep(0.1)
        assert not server.bridge.services.calls
    await until(lambda: server.bridge.services.calls)
    assert [service for service, _ in server.bridge.services.calls] == [PAUSE]


async def test_a_resume_is_sent_late_where_the_type_is_right(server: RosbridgeServer) -> None:
    """It waited on purpose: that the console was busy is not said of it."""
    server.bridge.services.frozen["/rosapi/services"] = 2.0
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(phase(Phase.UP))
        record = await finished(link, store, ResumeRobot("robot_0"))
        assert record.stage is not Stage.NOT_SENT, record.detail
    assert [service for service, _ in server.bridge.services.calls] == [RESUME]


async def test_services_that_go_unnoticed_are_missed_by_the_next_look(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(heartbeat, "EVERY", 0.1)
    async with linked(config_of(server.url, 2)) as (_, store):
        await store.until(ready)
        server.bridge.services.offered.clear()
        state = await store.until(path(CommandPath.UNREGISTERED))
        reason = state.links["rosbridge"].command_reason
        assert reason == "robot nodes not registered: restart them"


async def test_a_robot_that_speaks_and_has_no_services_is_told_from_the_start(
    server: RosbridgeServer,
) -> None:
    for name in list(server.bridge.services.offered):
        if "robot_1" in name:
            del server.bridge.services.offered[name]
    async with linked(config_of(server.url, 3)) as (_, store):  # nothing is ever heard of robot_2
        state = await store.until(path(CommandPath.UNREGISTERED))
        reason = state.links["rosbridge"].command_reason
        assert reason == "no services of robot_1: restart its node, or correct [profile.services]"


async def test_types_that_a_busy_bridge_did_not_tell_are_asked_for_again(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Behind the subscriptions of a large fleet the question runs out: the call must not leave for that."""
    monkeypatch.setattr(services, "ROSAPI_TIMEOUT", 0.2)
    monkeypatch.setattr(services, "RETRY_AFTER", 0.1)
    right = server.bridge.services.offered[RESUME]
    server.bridge.services.offered[RESUME] = replace(right, name="nav2_msgs/srv/ManageLifecycleNodes")
    server.bridge.services.silent_services.add("/rosapi/service_type")
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        await store.until(lambda _: asked_for_type(server) > 1)
        server.bridge.services.silent_services.clear()
        before = asked_for_type(server)
        await store.until(lambda _: asked_for_type(server) > before + len(ABILITIES) - 1)
        await finished(link, store, PauseRobot("robot_0"))
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.NOT_SENT
        server.bridge.services.offered[RESUME] = right
        # A refusal asks again: the next one goes by what is there now.
        before = asked_for_type(server)
        await finished(link, store, ResumeRobot("robot_0"))
        await store.until(lambda _: asked_for_type(server) > before)
        await finished(link, store, PauseRobot("robot_0"))
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.CONFIRMED


def asked_for_type(server: RosbridgeServer) -> int:
    """The number of requests for the type of a service."""
    return sum(one.get("service") == "/rosapi/service_type" for one in server.bridge.received)
