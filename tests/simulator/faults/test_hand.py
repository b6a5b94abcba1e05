"""Faults of robots that are driven by hand, of any kind."""

import math
from typing import Any

import pytest

from fleet_tui.simulator.faults.hand import EVERY, foreign_drive, no_timeout
from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.twists import twist

FLEETS: list[tuple[Any, Dialect]] = [
    (lambda: OhFleet(1, 1, quiet=True), ROS1),
    (lambda: MoveBaseFleet(1, 1, quiet=True), ROS1),
    (lambda: Nav2Fleet(1, 1, quiet=True), ROS2),
]


@pytest.mark.parametrize(("make", "dialect"), FLEETS)
def test_without_a_timeout_the_last_twist_counts_for_ever(make: Any, dialect: Dialect) -> None:
    fleet = make()
    server = RosbridgeServer(fleet, dialect=dialect)
    robot = fleet.robots["robot_0"]
    take = server.bridge.services.subscriptions["/robot_0/cmd_vel"]
    take(twist(0.2))
    before = robot.pose
    fleet.step(10.0)
    assert math.dist((before.x, before.y), (robot.pose.x, robot.pose.y)) == pytest.approx(0.1, abs=0.02)
    no_timeout(server, "robot_0")
    take(twist(0.2))
    before = robot.pose
    fleet.step(10.0)
    assert math.dist((before.x, before.y), (robot.pose.x, robot.pose.y)) == pytest.approx(2.0, abs=0.02)


def test_another_client_drives_only_after_a_hand() -> None:
    fleet = OhFleet(1, 1, quiet=True)
    server = RosbridgeServer(fleet)
    foreign_drive(server, "robot_0")
    server.bridge.topics["/robot_0/cmd_vel"] = server.bridge.topics["/robot_0/pose"]
    wheels = fleet.robots["robot_0"].wheels
    fleet.step(5.0)
    assert wheels.driven == 0.0
    for _ in range(8):
        wheels.take(twist(0.2))
        fleet.step(EVERY)
    assert wheels.speeds.yaw == pytest.approx(0.9)
