"""One robot that navigates: it drives, gives up, counts its wheels and tells where it believes to be."""

import math

import pytest

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.navigating.robot import LOST, NO_PROGRESS, PROGRESS, RECOVERIES, SLIP
from fleet_tui.simulator.robot import SPEED
from tests.support.navigating import FLOOR, lived, robot

START, END = (list(FLOOR.graph.vertices.values())[n] for n in (0, 1))
THERE = Pose(END.x, END.y, 1.0)


def test_it_drives_to_each_pose_and_turns_to_its_heading() -> None:
    it = robot()
    it.drive([THERE, Pose(START.x, START.y, -1.0)])
    lived(it, 0.2)
    assert it.driving and it.stops == 2 and it.distance_remaining > 0.0
    while it.stops == 2:
        it.step()
    assert (it.pose.x, it.pose.y) == pytest.approx((END.x, END.y))
    assert it.pose.yaw == pytest.approx(1.0, abs=0.1)
    lived(it, 30)
    assert not it.driving and it.failure is None
    assert (it.pose.x, it.pose.y, it.pose.yaw) == pytest.approx((START.x, START.y, -1.0))


def test_time_and_distance_are_those_of_the_way() -> None:
    it = robot()
    it.drive([THERE])
    lived(it, 3)
    before = it.distance_remaining
    assert it.time_remaining == pytest.approx(before / SPEED)
    lived(it, 1)
    assert before - it.distance_remaining == pytest.approx(SPEED, abs=0.1)


def test_who_is_stuck_recovers_and_then_gives_up() -> None:
    it = robot()
    it.stuck = True
    it.drive([THERE])
    lived(it, PROGRESS + 1)
    assert it.recoveries == 1 and it.driving
    lived(it, PROGRESS * RECOVERIES + 1)
    assert it.failure == NO_PROGRESS and not it.driving


def test_a_goal_without_a_way_fails_with_the_planners_code() -> None:
    it = robot()
    it.drive([Pose(-99.0, 0.0)])
    lived(it, 0.2)
    assert it.failure is not None and it.failure[0] == 204
    it.halt()
    assert it.failure is None


def test_wheels_count_a_little_more_than_it_drives() -> None:
    it = robot()
    it.drive([THERE])
    lived(it, 60)
    driven = math.dist((START.x, START.y), (END.x, END.y))
    assert math.hypot(it.odom.x, it.odom.y) == pytest.approx(SLIP * driven, rel=0.01)


def test_it_tells_its_pose_after_a_distance_and_a_wrong_one_when_lost() -> None:
    it = robot()
    assert not it.localise()
    it.pose = Pose(START.x + 0.3, START.y)
    assert it.localise() and it.estimate == it.pose and not it.localise()
    it.pose = Pose(it.pose.x, it.pose.y, 0.3)
    assert it.localise()
    it.lose()
    assert it.localise() and it.estimate.x == pytest.approx(it.pose.x + math.sqrt(LOST))


def test_an_obstacle_stands_in_its_way_and_a_dock_charges() -> None:
    it = robot()
    it.block()
    it.drive([THERE])
    lived(it, 5)
    assert it.obstacle == pytest.approx(5.05) and not it.moving
    charged = robot()
    charged.docked = True
    before = charged.battery
    assert lived(charged, 10).battery == pytest.approx(before + 5.0)
