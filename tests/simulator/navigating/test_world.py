"""A world of robots that navigate: names and places, time in steps, and what another client does."""

import pytest

from fleet_tui.simulator.move_base.navigation import SimMoveBase
from fleet_tui.simulator.navigating.world import NavigatingWorld
from fleet_tui.simulator.robot import LOW, STEP


def test_robots_are_numbered_as_asked_and_start_in_turn_on_all_floors() -> None:
    world = NavigatingWorld(SimMoveBase, 3, 2, first=4, step=2)
    assert list(world.robots) == ["robot_4", "robot_6", "robot_8"]
    assert [robot.floor.name for robot in NavigatingWorld(SimMoveBase, 3, 2).robots.values()] == [
        "floor_0",
        "floor_1",
        "floor_0",
    ]
    places = {(robot.pose.x, robot.pose.y) for robot in NavigatingWorld(SimMoveBase, 20, 1).robots.values()}
    assert len(places) == 20


def test_time_passes_in_steps_and_a_remainder_waits() -> None:
    world, passed = NavigatingWorld(SimMoveBase, 1, 1, quiet=True), list[float]()
    world.troubles.append(passed.append)
    world.step(STEP * 2.5)
    assert passed == [STEP] * 2
    world.step(STEP * 0.5)
    assert len(passed) == 3 and world.time == pytest.approx(3 * STEP)


def test_every_second_robot_is_driven_by_another_client_unless_it_is_quiet() -> None:
    for quiet, busy in ((False, {"robot_1", "robot_3"}), (True, set())):
        world, found = NavigatingWorld(SimMoveBase, 4, 1, seed=1, quiet=quiet), set[str]()
        for _ in range(60):
            world.step(1.0)
            found |= {name for name, navigation in world.navigation.items() if navigation.busy}
        assert found == busy


def test_the_other_client_leaves_a_robot_alone_after_its_goal_was_cancelled() -> None:
    world = NavigatingWorld(SimMoveBase, 2, 1, seed=1)
    navigation = world.navigation["robot_1"]
    while not navigation.busy:
        world.step(1.0)
    navigation.receive_cancel({"id": "", "stamp": {"secs": 0, "nsecs": 0}})
    busy = []
    for _ in range(160):
        world.step(1.0)
        busy.append(navigation.busy)
    assert not any(busy[2:110]) and busy[-1]


def test_who_is_low_is_sent_to_its_charger_and_charges() -> None:
    world = NavigatingWorld(SimMoveBase, 1, 1, seed=1)
    robot = world.robots["robot_0"]
    robot.battery = LOW - 1.0
    for _ in range(90):
        world.step(1.0)
    assert robot.docked and robot.battery > LOW - 1.0


def test_now_and_then_one_robot_is_not_heard_for_a_moment() -> None:
    world, silent = NavigatingWorld(SimMoveBase, 2, 1, seed=1), 0
    for _ in range(260):
        world.step(1.0)
        silent += any(robot.silence for robot in world.robots.values())
    assert 1 <= silent <= 6
