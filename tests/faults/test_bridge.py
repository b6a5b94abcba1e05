"""Faults of a ROS 1 bridge that answers, and a console that does not keep up."""

import json
import time
from functools import partial

import pytest

from fleet_tui.commands.checks import problems
from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.robots.ros.reading import FrameReader, Read
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.situation.links import LATE_FROM
from fleet_tui.ui.view.tables.news import news
from tests.support.bridge_faults import all_online, raised
from tests.support.fault_report import report
from tests.support.fleets import R0, place_order
from tests.support.invariants import linked
from tests.support.links import finished, path, ready
from tests.support.polling import HANGS
from tests.support.proxied_link import Stopwatch, fresh, lost, usual
from tests.support.shown_text import shown
from tests.support.site_faults import Message, says

UNREGISTERED = "robot nodes not registered: restart them"


@pytest.mark.parametrize(
    ("fault", "made_by"),
    [("frozen-rosapi", "its services do not answer"), ("dead-rosapi", "its services do not exist")],
)
async def test_rosapi_is_frozen_or_dead(server: RosbridgeServer, fault: str, made_by: str) -> None:
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        play(server, [(fault, "robot_0")])
        round_trips = link.counters["rosbridge"].round_trips
        beats = len(round_trips.took)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        await store.until(lambda _: len(round_trips.took) >= beats + 2)
        await server.drop_clients()
        await store.until(lost())
        watch = Stopwatch(store)
        healed = await watch.until(fresh())
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.CONFIRMED
        assert not round_trips.unanswered and path(CommandPath.ALIVE)(store.state)
        assert not raised("commands")(store.state)
    seen = "nothing: commands and topics continue, also after a reconnect"
    report(f"a {fault.replace('-', ' ')}", made_by, seen, None, healed)


async def test_standing_robots_repeat_their_last_pose(server: RosbridgeServer) -> None:
    names = [f"robot_{n}" for n in range(2)]
    async with linked(usual(server.url, 2)) as (_, store):
        await store.until(ready)
        for name in names:
            says(server, f"/{name}/pose", partial(_with_stamp, pose_of(server, name)["header"]["stamp"]))
        await store.until(lambda state: all(state.is_old(state.robots[name], "pose") for name in names))
        assert not raised("late")(store.state) and all_online(store.state)
        play(server, [("silent", "robot_1")])
        watch = Stopwatch(store)
        noticed = await watch.until(raised("offline"))
        assert "overloaded" not in shown(store.state)
        assert [robot.name for robot in store.state.robots.values() if store.state.is_online(robot)] == [R0]
    seen = "the age of their poses; the silent one offline; no bridge overloaded"
    report("old stamps, then a robot loses power", "poses repeat their stamp", seen, noticed, None)


async def test_the_first_pose_is_old(server: RosbridgeServer) -> None:
    pose = pose_of(server, R0)
    stamp = {**pose["header"]["stamp"], "secs": pose["header"]["stamp"]["secs"] - 40}
    says(server, f"/{R0}/pose", partial(_with_stamp, stamp))
    async with linked(usual(server.url, 2)) as (_, store):
        watch = Stopwatch(store)
        noticed = await watch.until(lambda state: state.robots[R0].pose is not None)
        first = store.state.robots[R0].pose
        assert first is not None and 39.0 < time.monotonic() - first.at < 45.0
        await watch.until(lambda state: all_online(state) and state.now > first.at + 41.0)
        assert "pose 4" in row(store.state, R0)
    seen = "pose 40 s old, at its first message"
    report("the first pose of a robot is old", "it repeats a stamp of 40 s ago", seen, noticed, None)


async def test_all_messages_of_a_robot_are_bad(server: RosbridgeServer) -> None:
    async with linked(usual(server.url, 2)) as (_, store):
        await store.until(ready)
        for topic in [
            one for one in server.bridge.topics if one.startswith("/robot_1/") and "floor" not in one
        ]:
            says(server, topic, lambda _: {"nonsense": "of another version"})
        watch = Stopwatch(store)
        noticed = await watch.until(lambda state: not state.is_online(state.robots["robot_1"]))
        await store.until(raised("data"))
        assert row(store.state, "robot_1").startswith("bad data x")
        assert not raised("offline")(store.state) and "all messages are bad" in shown(store.state)
    report("all messages of a robot are bad", "other fields", "bad data, not offline", noticed, None)


def row(state: FleetState, name: str) -> str:
    """The news of a robot in its row."""
    return ", ".join(text for text, _ in news(state, state.robots[name]))


def pose_of(server: RosbridgeServer, name: str) -> Message:
    """The pose that a robot publishes now."""
    pose: Message = json.loads(server.bridge.topics[f"/{name}/pose"].payload(time.time()).json)
    return pose


def _with_stamp(stamp: Message, pose: Message) -> Message:
    return {**pose, "header": {**pose["header"], "stamp": stamp}}


async def test_the_master_is_back_and_the_nodes_are_not(server: RosbridgeServer) -> None:
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        server.bridge.services.master_alive = False
        await store.until(path(CommandPath.DEAD))
        services = dict(server.bridge.services.offered)
        server.bridge.services.offered.clear()
        server.bridge.services.master_alive = True
        watch = Stopwatch(store)
        noticed = await watch.until(lambda state: UNREGISTERED in shown(state))
        record = await finished(link, store, ResumeRobot("robot_0"))
        assert record.stage is Stage.REFUSED and record.detail.endswith("does not exist")
        server.bridge.services.offered.update(services)
        watch.start()
        healed = await watch.until(path(CommandPath.ALIVE))
        await store.until(lambda state: not raised("commands")(state))
    report("the ROS master is back, the nodes are not", "no service exists", UNREGISTERED, noticed, healed)


async def test_a_bridge_without_the_robots_messages(server: RosbridgeServer) -> None:
    play(server, [("unsourced", "robot_0")])
    async with linked(usual(server.url, 2)) as (_, store):
        await store.until(path(CommandPath.ALIVE))
        watch = Stopwatch(store)
        noticed = await watch.until(raised("messages"))
        remedy = "rosbridge lacks package OH_ressources: source its workspace and restart rosbridge"
        assert remedy in shown(store.state)
        asked = problems(store.state, Request((place_order("robot_0", 19, 0),)), Permissions())
        assert "queue unheard" in [problem.check for problem in asked]
        server.bridge.services.unsourced.clear()
        await server.restart_bridge()
        watch.start()
        healed = await watch.until(lambda state: ready(state) and remedy not in shown(state))
    report(
        "a bridge without the robots' messages", "started without their workspace", remedy, noticed, healed
    )


async def test_this_console_is_behind(monkeypatch: pytest.MonkeyPatch) -> None:
    server = RosbridgeServer(OhFleet(robots=10, floors=1, seed=1, quiet=True))
    await server.start()
    read, slowness = FrameReader.read, 0.0

    def slow(self: FrameReader, payload: bytes, is_binary: bool, at: float) -> Read:
        time.sleep(slowness)
        return read(self, payload, is_binary, at)

    monkeypatch.setattr(FrameReader, "read", slow)
    async with linked(usual(server.url, 10)) as (link, store):
        await store.until(ready)
        slowness = 0.05
        watch = Stopwatch(store)
        noticed = await watch.until(raised("behind"), within=HANGS)
        assert "this console is " in shown(store.state) and " s behind" in shown(store.state)
        assert {alarm.condition.source for alarm in store.state.alarms} == {"console"}
        assert all_online(store.state)
        await store.until(lambda _: link.counters["rosbridge"].overtaken)
        slowness = 0.0
        watch.start()
        healed = await watch.until(lambda state: state.behind < LATE_FROM and all_online(state))
    await server.stop()
    seen = "this console is N s behind, one alarm; no robot is blamed"
    report(
        "this console is behind", "each message takes 50 ms, and 200 arrive per second", seen, noticed, healed
    )
