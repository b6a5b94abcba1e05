"""Reports of fleet adapters: a robot is as old as its own driver says."""

import pytest

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import MemberReported, StatusReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Robot
from tests.support.fleets import F0, R0, T0, reduced, tick
from tests.support.rmf import rmf_fleet

HERE, THERE = Pose(1.0, 1.0), Pose(9.0, 9.0)


def member(at: float, stamp: float | None, pose: Pose = HERE) -> MemberReported:
    return MemberReported(R0, at, pose, F0, stamp, 80.0, "moving", "p1")


def status(at: float, pose: Pose | None = THERE) -> StatusReported:
    return StatusReported(R0, at, "working", "p1", ("lift: stuck",), pose, F0, 55.0)


def robot(state: FleetState) -> Robot:
    return state.robots[R0]


def test_a_driver_that_is_lost_is_offline_although_its_adapter_goes_on() -> None:
    state = reduced(rmf_fleet(), member(T0, 100.0), member(T0 + 1, 101.0))
    assert state.is_online(robot(state)) and robot(state).floor == F0
    for n in range(2, 12):
        state = reduced(state, member(T0 + n, 101.0), status(T0 + n), tick(T0 + n))
    assert not state.is_online(robot(state))
    known = robot(state)
    assert known.pose is not None and known.battery is not None
    assert known.last_received == known.battery.at == known.pose.at == pytest.approx(T0 + 1, abs=0.1)


def test_what_the_adapter_repeats_of_a_stamped_robot_is_no_pose() -> None:
    state = reduced(rmf_fleet(), member(T0, 100.0), status(T0 + 0.1))
    known = robot(state)
    assert known.pose is not None and known.pose.value == HERE
    assert known.member is not None and known.member.value.issues == ("lift: stuck",)
    assert known.member.value.mode == "moving"


def test_without_stamps_the_adapter_is_all_there_is() -> None:
    state = reduced(rmf_fleet(), status(T0), tick(T0))
    assert robot(state).pose is not None and state.is_online(robot(state))
    battery = robot(state).battery
    assert battery is not None and battery.value == 55.0


def test_a_report_on_an_unknown_robot_changes_nothing() -> None:
    state = rmf_fleet()
    assert reduced(state, MemberReported("x/y", T0, HERE, F0, 1.0, None, "idle", "")) is state
