"""The command path, as the console tests it on a real loopback server."""

from pathlib import Path

import msgspec
import pytest

from fleet_tui.cli.status.report import attention
from fleet_tui.config.schema import Config, Operator
from fleet_tui.console.demo import demo_config
from fleet_tui.links.rosbridge import calls, heartbeat, lateness
from fleet_tui.links.rosbridge import probes as pulse
from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.counters import RoundTrips
from fleet_tui.model.events import CommandPathChanged
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import NOT_ADMITTED, UNASKED, UNPROVEN, CommandPath
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.situation.why.why import reasons
from tests.support.fleets import reduced, tick
from tests.support.links import finished, linked, path, ready
from tests.support.polling import HANGS
from tests.support.watched_store import WatchedStore, config_of

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
    server.bridge.services.silent_services.update(pulse.EVERY_QUESTION)
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
    server.bridge.services.silent_services.update(pulse.EVERY_QUESTION)
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(path(CommandPath.DEAD))
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        assert store.state.links["rosbridge"].command_path is CommandPath.ALIVE
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.CONFIRMED


@pytest.mark.parametrize("rosapi_returns", [True, False])
async def test_a_master_that_is_back_without_its_nodes_is_told_until_they_are(
    server: RosbridgeServer, rosapi_returns: bool
) -> None:
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


async def test_a_console_that_comes_after_a_restart_of_the_master_says_that_no_command_gets_through(
    server: RosbridgeServer,
) -> None:
    own = dict(server.bridge.services.answers)
    play(server, [("lost-master", "robot_0")])
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(lambda state: state.links["rosbridge"].command_reason == UNPROVEN)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.REFUSED
        state = await store.until(path(CommandPath.UNREGISTERED))
        assert f"rosbridge: {heartbeat.NO_NODE}" in attention(state)
        server.bridge.services.answers.update(own)
        await store.until(path(CommandPath.ALIVE))


async def test_a_site_without_rosapi_whose_bridge_has_another_name_is_no_alarm(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(heartbeat, "EVERY", 0.1)
    server.bridge.services.rosapi_alive = False
    server.bridge.services.answers.clear()
    async with linked(config_of(server.url, 1)) as (link, store):
        state = await store.until(lambda state: state.links["rosbridge"].command_reason == UNPROVEN)
        assert state.links["rosbridge"].command_path is CommandPath.ALIVE
        assert not state.alarms and any("commands not tried yet" in line for line in attention(state))
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        assert store.state.links["rosbridge"].command_reason == ""


async def test_a_console_that_may_only_read_calls_no_path_alive_of_which_rosapi_knows_nothing(
    server: RosbridgeServer,
) -> None:
    play(server, [("lost-master", "robot_0")])
    config = msgspec.structs.replace(config_of(server.url, 1), operator=Operator(read_only=True))
    async with linked(config) as (_, store):
        await store.until(lambda state: state.links["rosbridge"].command_reason == UNASKED)


async def test_a_bridge_whose_nodes_answer_is_asked_nothing_that_is_an_error_in_the_log_of_its_site(
    ros_2: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(heartbeat, "EVERY", 0.05)
    for asks in (heartbeat, lateness):
        monkeypatch.setattr(asks, "QUICK", HANGS)
    async with linked(config_of(ros_2.url, 1)) as (link, store):
        beats = link.counters["rosbridge"].round_trips
        await more_beats(store, beats)
        play(ros_2, [("dead-rosapi", "robot_0")])
        await more_beats(store, beats)
        asked = [one["service"] for one in ros_2.bridge.received if one["op"] == "call_service"]
    assert store.state.links["rosbridge"].command_path is CommandPath.ALIVE
    assert calls.OWN_WORD not in asked and calls.TIME in asked and not {*asked}.isdisjoint(pulse.OF_NODE)


async def more_beats(store: WatchedStore, beats: RoundTrips) -> None:
    seen: set[float | None] = set()

    def went_on(_: FleetState) -> bool:
        seen.add(beats.at)
        return len(seen) > 3

    await store.until(went_on)


async def test_a_bridge_that_is_half_dead_is_told_as_that_and_no_robot_is_blamed(
    nav2: RosbridgeServer, tmp_path: Path
) -> None:
    config = demo_config(Config(), nav2.url, 1, 1, "2", "nav2", tmp_path)
    async with linked(config) as (_, store):
        await store.until(lambda state: state.robots["robot_0"].pose)
        play(nav2, [("half-dead", "robot_0")])
        await store.until(lambda state: state.links["rosbridge"].is_half_dead)
        state = await store.until(lambda state: not state.is_online(state.robots["robot_0"]), within=HANGS)
        later = reduced(state, tick(state.now + 60.0))
        assert [alarm.condition.kind for alarm in later.alarms if alarm.holds] == ["commands"]
        assert later.alarms[0].text == "commands dead: rosbridge is half dead: restart it"
        found = reasons(later, later.robots["robot_0"])
        assert found[0].name == "rosbridge half dead" and "Restart rosbridge" in found[0].remedy
        assert attention(later) == ["rosbridge: commands dead: rosbridge is half dead: restart it"]
        nav2.bridge.services.silent_services.clear()
        await store.until(path(CommandPath.ALIVE))


async def test_a_fleet_that_has_nothing_to_say_has_no_half_dead_bridge(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nor has one without rosapi."""
    monkeypatch.setattr(heartbeat, "EVERY", 0.05)
    monkeypatch.setattr(heartbeat, "QUICK", HANGS)
    monkeypatch.setattr(heartbeat, "HALF_DEAD_AFTER", 0.0)
    server.bridge.muted.update(server.bridge.topics)
    async with linked(config_of(server.url, 1)) as (link, store):
        beats = link.counters["rosbridge"].round_trips
        await more_beats(store, beats)
        play(server, [("dead-rosapi", "robot_0")])
        await more_beats(store, beats)
        paths = [one.path for one in store.told(CommandPathChanged) if isinstance(one, CommandPathChanged)]
    assert CommandPath.ALIVE in paths and CommandPath.DEAD not in paths


async def test_a_bridge_that_does_not_allow_the_heartbeat_is_neither_half_dead_nor_without_rosapi(
    ros_2: RosbridgeServer,
) -> None:
    ros_2.bridge.allowed["service"] = ("/robot_0/*",)
    async with linked(demo_config(Config(), ros_2.url, 1, 1, "2")) as (_, store):
        await store.until(lambda state: state.robots["robot_0"].pose)
        state = await store.until(lambda state: state.links["rosbridge"].command_reason == NOT_ADMITTED)
        later = reduced(state, tick(state.now + 20.0))
        alarm = next(one.condition for one in later.alarms if one.condition.kind == "commands")
        assert alarm.text == f"commands dead: {NOT_ADMITTED}" and "services_glob" in alarm.remedy
        assert attention(later)[0] == f"rosbridge: {alarm.text}"
        del ros_2.bridge.allowed["service"]
        await store.until(path(CommandPath.ALIVE))
