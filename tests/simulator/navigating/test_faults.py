"""Faults of robots that navigate, whichever stack they run: each is played on one robot alone."""

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, cast

import pytest
from websockets.asyncio.client import connect

from fleet_tui.simulator.faults import camera
from fleet_tui.simulator.faults.hand import FAULTS as HAND
from fleet_tui.simulator.faults.plays import FLAT
from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.navigating.faults import AWHILE, BODY, EVERY
from fleet_tui.simulator.navigating.robot import LOST, NavigatingRobot
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.nav2_client import latest

Fleets = MoveBaseFleet | Nav2Fleet
FLEETS: tuple[type[Any], ...] = (MoveBaseFleet, Nav2Fleet)
CHANGES: dict[str, Callable[[NavigatingRobot], bool]] = {
    "stuck": lambda robot: robot.stuck,
    "no-odom": lambda robot: not robot.odometry,
    "lost": lambda robot: robot.variance == LOST,
    "obstacle": lambda robot: robot.obstacle > 0.0,
    "battery": lambda robot: robot.battery <= FLAT,
    "unmeasured": lambda robot: math.isnan(robot.percent),
    "percent": lambda robot: robot.percent == 1.0,
    "mislocalised": lambda robot: robot.belief.misplaced is not None,
    "silent": lambda robot: math.isinf(robot.silence),
}


def played(name: str, kind: type[Fleets]) -> Fleets:
    """A fleet of two of which the first has a fault, as the server plays it."""
    fleet = kind(2, 1, seed=1, quiet=True)
    fleet.robots["robot_1"].percent = 0.01
    services = SimpleNamespace(fleet_of=lambda _robot: fleet)
    server = SimpleNamespace(bridge=SimpleNamespace(services=services), speed=1.0)
    BODY[name][1](cast("RosbridgeServer", server), "robot_0")
    return fleet


def test_every_fault_of_the_body_is_looked_at() -> None:
    places = {"tf-only", "own-tf", "dead-localisation"}  # on the wire
    assert set(CHANGES) | {"foreign-goal", "foreign-cancel", *HAND, *places} == set(BODY) - set(camera.FAULTS)


@pytest.mark.parametrize("kind", FLEETS)
@pytest.mark.parametrize("name", CHANGES)
def test_it_is_one_robots(name: str, kind: type[Fleets]) -> None:
    fleet = played(name, kind)
    fleet.step(0.1)
    assert [CHANGES[name](robot) for robot in fleet.robots.values()] == [True, False]


@pytest.mark.parametrize("kind", FLEETS)
def test_another_client_gives_goals_again_and_again(kind: type[Fleets]) -> None:
    fleet = played("foreign-goal", kind)
    fleet.step(EVERY - 1.0)
    assert not fleet.navigation["robot_0"].busy
    fleet.step(2.0)
    assert fleet.navigation["robot_0"].busy and not fleet.navigation["robot_1"].busy


@pytest.mark.parametrize("kind", FLEETS)
def test_another_client_cancels_every_goal_after_a_while(kind: type[Fleets]) -> None:
    fleet = played("foreign-cancel", kind)
    fleet.step(EVERY)
    for navigation in fleet.navigation.values():
        navigation.give(35.0, 20.0)
    fleet.step(AWHILE - 0.5)
    assert all(navigation.busy for navigation in fleet.navigation.values())
    fleet.step(1.0)
    assert [navigation.busy for navigation in fleet.navigation.values()] == [False, True]


@pytest.mark.parametrize("kind", FLEETS)
@pytest.mark.parametrize(
    ("name", "low", "high"), [("percent", 30.0, 100.0), ("battery", 0.01, 0.08), ("unmeasured", None, None)]
)
async def test_batteries_differ(kind: type[Fleets], name: str, low: float | None, high: float) -> None:
    server = RosbridgeServer(kind(2, 1, seed=1, quiet=True), rate=50.0, speed=20.0)
    BODY[name][1](server, "robot_0")
    await server.start()
    async with connect(server.url, max_size=None, close_timeout=0.1) as client:
        server.fleets[0].step(0.1)
        percentage = (await latest(client, "/robot_0/battery_state"))["percentage"]
        assert percentage is None if low is None else low < percentage <= high + 1e-6
    await server.stop()
