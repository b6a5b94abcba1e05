"""Driving over a real loopback bridge: the frames on the wire, and every way in which a drive ends."""

import time
from itertools import dropwhile, takewhile

import pytest

from fleet_tui.model.set_up.driving import STILL, DrivePhase, Steering
from fleet_tui.robots.profile import DriveConfig
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.language import Message
from tests.support.driving import AHEAD, R0, TOPIC, driving
from tests.support.fault_proxy import before


def zeros_at_the_end(frames: list[tuple[float, ...]]) -> int:
    return len(list(takewhile(lambda one: one == STILL, reversed(frames))))


@pytest.mark.parametrize("topic", ["/{robot}/cmd_vel", "/{robot}/cmd_vel_stamped"])
async def test_a_robot_moves_while_the_hand_asks_for_it_and_no_longer(
    server: RosbridgeServer, topic: str
) -> None:
    await held_and_released(server, topic)


@pytest.mark.parametrize("topic", ["/{robot}/cmd_vel", "/{robot}/cmd_vel_stamped"])
async def test_so_it_does_behind_a_bridge_of_ros_2(ros_2: RosbridgeServer, topic: str) -> None:
    await held_and_released(ros_2, topic)


async def held_and_released(server: RosbridgeServer, topic: str) -> None:
    async with driving(server, topic=topic) as it:
        await it.ready()
        robot = server.world.robots[R0]
        start = robot.pose
        it.drive.steer(Steering(AHEAD, time.monotonic() + 0.45))
        await it.store.until(lambda _: robot.pose != start)
        await it.store.until(lambda _: len(it.frames) > 4 and zeros_at_the_end(list(it.frames)) >= 3)
        moved = list(dropwhile(lambda one: one == STILL, it.frames))
        speeds = [one.ahead for one in moved]
        assert speeds[0] == pytest.approx(0.05)
        assert speeds == [*sorted(speeds[:-3]), 0.0, 0.0, 0.0]
        assert max(speeds) <= 0.3
        assert it.drive.state.round_trip is not None


async def test_the_bridge_keeps_one_frame_alone_and_the_connection_is_shut_in_the_end(
    server: RosbridgeServer,
) -> None:
    async with driving(server) as it:
        await it.ready()
        (advertised,) = [one for one in server.bridge.received if one["op"] == "advertise"]
        assert (advertised["topic"], advertised["queue_size"]) == (TOPIC, 1)
        await it.moving()
        it.drive.end(Message("a dialog"))
        assert await it.ended() == "a dialog"
        await it.store.until(lambda _: zeros_at_the_end(list(it.frames)) >= 3)
        await it.store.until(lambda _: not server.bridge.subscribers(TOPIC))
        told = len(it.frames)
        it.drive.steer(Steering(AHEAD, time.monotonic() + 5.0))
        it.drive.end(Message("again"))
        assert (it.drive.state.reason, len(it.frames)) == ("a dialog", told)


async def test_the_caps_of_its_profile_are_the_last_word(server: RosbridgeServer) -> None:
    async with driving(server, limits=DriveConfig(max_linear=0.08)) as it:
        await it.ready()
        await it.moving()
        assert max(one.ahead for one in it.frames) == pytest.approx(0.08)


async def test_another_publisher_ends_it(server: RosbridgeServer) -> None:
    play(server, [("foreign-drive", R0)])
    async with driving(server) as it:
        await it.ready()
        await it.moving()
        assert await it.ended() == "someone else drives"
        await it.store.until(lambda _: zeros_at_the_end(list(it.frames)) >= 3)


async def test_a_link_that_swallows_everything_ends_it_by_its_lag(server: RosbridgeServer) -> None:
    async with before(server.url) as proxy, driving(server, proxy.url) as it:
        await it.ready()
        await it.moving()
        proxy.swallows = True
        assert (await it.ended()).startswith("lag: no echo for 0.")


async def test_a_lost_link_ends_it_and_nothing_is_sent_after_it_is_back(server: RosbridgeServer) -> None:
    async with before(server.url) as proxy, driving(server, proxy.url) as it:
        await it.ready()
        await it.moving()
        proxy.cut()
        assert (await it.ended()).startswith("link lost")
        told = len(it.frames)
        link = it.store.state.links["rosbridge"]
        await it.store.until(lambda state: state.links["rosbridge"].since > link.since)
        it.drive.steer(Steering(AHEAD, time.monotonic() + 5.0))
        await it.store.until(lambda state: state.robots[R0].pose)
        assert len(it.frames) == told
        # The robot stops by itself.
        wheels = server.world.robots[R0].wheels
        await it.store.until(lambda _: wheels.age > wheels.timeout)


async def test_a_console_that_closes_stops_the_robot(server: RosbridgeServer) -> None:
    async with driving(server) as it:
        await it.ready()
        await it.moving()
    assert it.drive.state.reason == "console closed"
    async with driving(server) as later:
        await later.ready()
        assert zeros_at_the_end(list(it.frames)) >= 3


async def test_a_second_drive_ends_the_first(server: RosbridgeServer) -> None:
    async with driving(server) as it, driving(server) as other:
        await it.ready()
        await other.ready()
        await it.moving()
        assert await other.ended() == "someone else drives"
        assert it.drive.state.phase is DrivePhase.READY


async def test_without_a_bridge_it_does_not_begin(server: RosbridgeServer) -> None:
    async with before(server.url) as proxy, driving(server, proxy.url) as it:
        await proxy.refuse()
        assert (await it.ended()).startswith(("no link", "link lost"))
        assert it.frames == []
