"""Wheels that follow twists until they get too old."""

import math

import pytest

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.senses.wheels import TIMEOUT, Wheels, twists
from tests.support.twists import twist

STEP = 0.05


def carried(wheels: Wheels, seconds: float) -> Pose:
    pose = Pose(0.0, 0.0)
    for _ in range(round(seconds / STEP)):
        pose = wheels.carry(pose, STEP)
    return pose


def test_it_moves_by_its_twist_and_stops_without_further_ones() -> None:
    wheels = Wheels()
    wheels.take(twist(0.4, 0.2))
    far = carried(wheels, 60.0)
    assert far.x == pytest.approx(0.4 * TIMEOUT, abs=0.03)
    assert far.y == pytest.approx(0.2 * TIMEOUT, abs=0.02)


def test_it_turns() -> None:
    wheels = Wheels()
    wheels.take(twist(turning=1.0))
    assert carried(wheels, 0.4).yaw == pytest.approx(0.4)


def test_a_zero_stops_it_at_once() -> None:
    wheels = Wheels()
    wheels.take(twist(1.0))
    wheels.take(twist())
    assert carried(wheels, 0.3) == Pose(0.0, 0.0)


def test_without_a_timeout_it_drives_for_ever() -> None:
    wheels = Wheels()
    wheels.timeout = math.inf
    wheels.take(twist(0.5))
    assert carried(wheels, 60.0).x == pytest.approx(30.0)


def test_a_robot_listens_on_both_topics() -> None:
    class Robot:
        wheels = Wheels()

    found = twists({"r": Robot()})
    assert [type_ for type_, _ in found.values()] == ["geometry_msgs/Twist", "geometry_msgs/TwistStamped"]
    found["/r/cmd_vel_stamped"][1]({"header": {}, "twist": twist(0.3)})
    assert Robot.wheels.speeds == Pose(0.3, 0.0, 0.0)
