"""Robots with Nav2 in words: goals as they begin and end, obstacles as they come and go."""

from fleet_tui.simulator.logs import ERROR, INFO, WARN
from fleet_tui.simulator.nav2.fleet import Nav2Fleet

NODE = "/robot_0/bt_navigator"


def told(fleet: Nav2Fleet) -> list[tuple[int, str, str]]:
    return list(fleet.lines())


def test_a_goal_is_told_as_it_begins_and_as_it_ends() -> None:
    fleet = Nav2Fleet(1, 1, seed=1, quiet=True)
    navigation = fleet.navigation["robot_0"]
    navigation.give(8.0, 0.0)
    fleet.step(0.1)
    assert told(fleet) == [(INFO, NODE, "Begin navigating from current location to (8.00, 0.00)")]
    assert told(fleet) == []
    navigation.cancel_all()
    fleet.step(0.5)
    assert told(fleet) == [(INFO, NODE, "Goal canceled")]
    navigation.give(-99.0, 0.0)
    fleet.step(1.0)
    (level, node, words) = told(fleet)[-1]
    assert (level, node) == (ERROR, NODE) and words.startswith(
        "Goal failed error_code:204 error_msg:GridBased"
    )


def test_an_obstacle_is_told_once_and_a_silent_robot_says_nothing() -> None:
    fleet = Nav2Fleet(1, 1, seed=1, quiet=True)
    robot = fleet.robots["robot_0"]
    robot.block()
    assert told(fleet) == [], "without a twist the monitor has nothing to stop"
    robot.driving = True
    ((level, node, _),) = told(fleet)
    assert (level, node) == (WARN, "/robot_0/collision_monitor") and told(fleet) == []
    robot.obstacle, robot.silence = 0.0, 9.0
    assert told(fleet) == []
    robot.silence = 0.0
    robot.block()
    ((level, _, _),) = told(fleet)
    assert level == WARN
