"""The state of a fleet: what of a robot is old, fresh or missing."""

import math

from fleet_tui.model.kind import Kind
from tests.support.fleets import R0, T0, battery, fleet, link_up, of_kinds, pose, queue, reduced, tick
from tests.support.kinds import FULL

R1 = "robot_1"


def test_each_value_is_old_after_its_own_silence() -> None:
    slow = Kind("slow", ("pose", "battery", "queue"), silence={"battery": 60.0, "queue": math.inf})
    state = reduced(of_kinds(fleet(2), slow, FULL), link_up(T0))
    for name in state.robots:
        state = reduced(state, battery(T0, robot=name), queue(T0, robot=name), pose(T0 + 40, robot=name))
    state = reduced(state, tick(T0 + 41))
    one, other = state.robots[R0], state.robots[R1]
    assert not state.is_old(one, "battery") and not state.is_old(one, "queue")
    assert state.is_old(other, "battery") and state.is_old(other, "queue")
    later = reduced(state, pose(T0 + 70), tick(T0 + 70))
    assert later.is_old(later.robots[R0], "battery") and not later.is_old(later.robots[R0], "queue")


def test_of_a_robot_that_is_offline_everything_is_old() -> None:
    kind = Kind("slow", ("pose", "queue"), silence={"queue": math.inf, "pose": 60.0})
    state = reduced(of_kinds(fleet(), kind), link_up(T0), queue(T0), pose(T0), tick(T0 + 6))
    robot = state.robots[R0]
    assert state.is_old(robot, "queue") and state.is_old(robot, "pose")
    assert not state.is_old(robot, "battery") and not state.is_fresh(robot, "battery")
