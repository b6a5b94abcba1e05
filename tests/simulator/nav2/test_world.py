"""A world of robots with Nav2: what another client does with every second robot, and that the seed is all."""

from fleet_tui.simulator.nav2.navigation import TO_POSE, WAYPOINTS, SimNavigation
from fleet_tui.simulator.navigating.world import NavigatingWorld
from fleet_tui.simulator.robot import LOW


def run(world: NavigatingWorld[SimNavigation], seconds: int) -> None:
    for _ in range(seconds):
        world.step(1.0)


def test_the_same_seed_gives_the_same_run() -> None:
    def lived(seed: int) -> list[object]:
        world = NavigatingWorld(SimNavigation, 3, 2, seed)
        run(world, 60)
        return [(robot.pose, robot.odom, robot.battery) for robot in world.robots.values()]

    assert lived(1) == lived(1) != lived(2)


def test_at_the_start_nobody_has_a_goal_and_later_every_second_robot() -> None:
    world = NavigatingWorld(SimNavigation, 4, 1, seed=1)
    assert not any(navigation.busy for navigation in world.navigation.values())
    given: set[str] = set()
    for _ in range(40):
        run(world, 1)
        given |= {name for name, navigation in world.navigation.items() if navigation.busy}
    assert given == {"robot_1", "robot_3"}


def test_some_goals_are_tours() -> None:
    world, verbs = NavigatingWorld(SimNavigation, 4, 1, seed=1), set[str]()
    for _ in range(400):
        run(world, 1)
        servers = [server for one in world.navigation.values() for server in one.servers.values()]
        verbs |= {server.verb for server in servers if server.running}
    assert {TO_POSE, WAYPOINTS} <= verbs


def test_who_is_low_docks_and_charges() -> None:
    world = NavigatingWorld(SimNavigation, 1, 1, seed=1)
    robot = world.robots["robot_0"]
    robot.battery = LOW - 1.0
    run(world, 90)
    assert robot.docked and robot.battery > LOW - 1.0
