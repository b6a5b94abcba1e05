"""Faults of robots, their master and their bridge behind an open connection."""

import time
from types import SimpleNamespace

import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Config
from fleet_tui.links.rosbridge.heartbeat import NO_NODE
from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fault_report import report
from tests.support.fleets import place_order
from tests.support.invariants import linked
from tests.support.links import finished, path, ready
from tests.support.polling import HANGS
from tests.support.proxied_link import PLANTED, Holds, Stopwatch, fresh, through, usual
from tests.support.watched_store import config_of


def online(count: int) -> Holds:
    """So many robots have spoken within the limit."""
    return lambda state: sum(map(state.is_online, state.robots.values())) == count


def quick(url: str, robots: int) -> Config:
    """A config whose limits are short, where nothing else is measured."""
    config = config_of(url, robots)
    return replace(config, alarms=replace(config.alarms, no_answer_after=1.0, not_confirmed_after=1.0))


async def test_rosbridge_restarted_with_other_robots() -> None:
    first = RosbridgeServer(OhFleet(robots=3, floors=1, seed=1, quiet=True))
    await first.start()
    port = int(first.url.rpartition(":")[2])
    async with linked(config_of(first.url, 3)) as (_, store):
        await store.until(ready)
        watch = Stopwatch(store)
        await first.stop()
        second = RosbridgeServer(OhFleet(robots=1, floors=1, seed=2, quiet=True), port=port)
        await second.start()
        noticed = await watch.until(
            lambda state: online(1)(state) and state.links["rosbridge"].phase is Phase.UP
        )
        await second.stop()
        third = RosbridgeServer(OhFleet(robots=3, floors=1, seed=3, quiet=True), port=port)
        await third.start()
        watch.start()
        healed = await watch.until(fresh(3))
        await third.stop()
    report(
        "rosbridge restarted with other robots",
        "1 of 3 remains, then all return",
        "2 offline",
        noticed,
        healed,
    )
    assert noticed < 12 and healed < 8


async def test_roscore_restarted_behind_a_living_rosbridge(server: RosbridgeServer) -> None:
    """Two consoles: the bridge asks ROS anew only when both have let go."""
    async with through(server) as (_, _, store, watch), linked(config_of(server.url, 2)) as (_, theirs):
        await theirs.until(ready)
        server.bridge.orphaned.update(
            name for name in server.bridge.subscribed() if name.startswith("/robot_")
        )
        watch.start()
        noticed = await watch.until(online(0))
        assert store.state.links["rosbridge"].phase is Phase.UP
        healed = await watch.until(online(2), within=HANGS)
        await theirs.until(online(2))
    report("roscore restarted", "rosbridge's topics stay silent", "offline, every robot", noticed, healed)
    assert noticed < 7 and healed < 45


async def test_a_robot_that_is_off_is_asked_for_ever_more_seldom(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2)) as (_, store):
        await store.until(ready)
        server.bridge.muted.update(
            name for name in server.bridge.subscribed() if name.startswith("/robot_1/")
        )
        begun = time.monotonic()

        def asked(state: FleetState) -> list[object]:
            names = [op["topic"] for op in server.bridge.received if op["op"] == "subscribe"]
            return [name for name in names if name == "/robot_1/pose"]

        await store.until(lambda state: len(asked(state)) == 4, within=HANGS)
        assert time.monotonic() - begun > 0.5 + 0.9 + 1.6
        polite = [op["topic"] for op in server.bridge.received if op["op"] == "subscribe"].count(
            "/robot_0/pose"
        )
        assert polite == 1
        server.bridge.muted.clear()
        await store.until(online(2))


async def test_a_robots_node_restarted(server: RosbridgeServer) -> None:
    """Its latched topics come again, with what it knows now."""
    async with through(server) as (_, _, _, watch):
        labels = {"vertices": [{"label": "New gate", "vertex_id": 0}]}
        watch.start()
        server.bridge.publish_raw("/robot_0/floor_0/labeled_vertices", labels)
        healed = await watch.until(
            lambda state: state.robots["robot_0"].maps["floor_0"].labels == {"0": "New gate"}
        )
    report("a robot's node restarted", "its latched topics are sent again", "the new map", None, healed)


@pytest.mark.parametrize("hours", [-7.0, 0.5, 26.0])
async def test_the_clock_of_a_robot_is_hours_off(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch, hours: float
) -> None:
    async with through(server) as (_, _, store, watch):
        shifted = SimpleNamespace(time=lambda: time.time() + hours * 3600)
        monkeypatch.setattr("fleet_tui.simulator.server.time", shifted)
        watch.start()
        stepped = store.state.now + 1.0
        await watch.until(lambda state: state.now > stepped)
        for robot in store.state.robots.values():
            assert store.state.is_online(robot)
            assert robot.pose is not None and store.state.now - robot.pose.at < 1.0
    report("a robot's clock", "set by -7 h, 0.5 h, 26 h while it drives", "nothing", None, None)


@pytest.mark.parametrize("hours", [-5.0, 5.0])
async def test_the_systems_clock_jumps(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch, hours: float
) -> None:
    async with through(server) as (_, link, store, watch):
        shifted = SimpleNamespace(time=lambda: time.time() + hours * 3600, monotonic=time.monotonic)
        for module in ("writer", "fleet_link", "rosbridge.command_channel", "rosbridge.telemetry"):
            monkeypatch.setattr(f"fleet_tui.links.{module}.time", shifted)
        watch.start()
        await watch.until(lambda state: abs(state.wall - time.time() - hours * 3600) < 10)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        assert online(2)(store.state) and {alarm.key for alarm in store.state.alarms} == {PLANTED}
    report("system clock jumps", "by -5 h and 5 h", "the time of day, nothing else", None, None)


async def test_a_service_that_never_answers(server: RosbridgeServer) -> None:
    server.bridge.services.silent_services.add("/robot_0/Application_layout/Pause")
    async with linked(quick(server.url, 2)) as (link, store):
        await store.until(ready)
        watch = Stopwatch(store)
        command = link.submit(PauseRobot("robot_0"))
        noticed = await watch.until(
            lambda state: state.commands and state.commands[-1].time_of(Stage.NO_ANSWER)
        )
        await store.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert store.state.commands[-1].id == command
        assert (await finished(link, store, PauseRobot("robot_1"))).stage is Stage.CONFIRMED
    seen = "no answer, then not confirmed"
    report("a service never answers", "no_answer_after = 1 here, else 5 s", seen, noticed, None)


async def test_the_master_is_gone(server: RosbridgeServer) -> None:
    async with through(server) as (_, link, store, watch):
        server.bridge.services.master_alive = False
        watch.start()
        noticed = await watch.until(path(CommandPath.DEAD))
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.NOT_SENT
        server.bridge.services.master_alive = True
        watch.start()
        healed = await watch.until(path(CommandPath.ALIVE))
    report("no ROS master", "calls fail, topics continue", "commands dead: ...", noticed, healed)


async def test_a_hundred_robots_fall_silent_at_once() -> None:
    server = RosbridgeServer(OhFleet(robots=100, floors=1, seed=1, quiet=True))
    await server.start()
    async with linked(config_of(server.url, 100)) as (_, store):
        await store.until(lambda state: online(100)(state) and ready(state), within=HANGS)
        server.bridge.muted.update(name for name in server.bridge.subscribed() if name.startswith("/robot_"))
        watch = Stopwatch(store)
        noticed = await watch.until(online(0), within=HANGS)
        await store.until(lambda state: len(state.alarms) > 0, within=HANGS)
        server.bridge.muted.clear()
        watch.start()
        healed = await watch.until(online(100), within=HANGS)
    await server.stop()
    report("100 robots silent at once", "no messages arrive any more", "100 x offline", noticed, healed)
    assert noticed < 8 and healed < 5


async def test_the_master_was_restarted_without_rosapi_before_the_console(server: RosbridgeServer) -> None:
    own = dict(server.bridge.services.answers)
    offered = dict(server.bridge.services.offered)
    for robot in ("robot_0", "robot_1"):
        play(server, [("lost-master", robot)])
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(online(2), within=HANGS)
        watch = Stopwatch(store)
        link.submit(place_order("robot_0", 19, 0))
        noticed = await watch.until(path(CommandPath.UNREGISTERED), within=HANGS)
        assert store.state.links["rosbridge"].command_reason == NO_NODE
        server.bridge.services.rosapi_alive = True
        server.bridge.services.answers.update(own)
        server.bridge.services.offered.update(offered)
        watch.start()
        healed = await watch.until(path(CommandPath.ALIVE), within=HANGS)
    made_by = "no service exists, not even the bridge's own; an order"
    report("the ROS master was restarted without rosapi", made_by, NO_NODE, noticed, healed)
