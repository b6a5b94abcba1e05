"""A world of robots with move_base."""

from fleet_tui.simulator.move_base.navigation import SimMoveBase
from fleet_tui.simulator.navigating.world import NavigatingWorld


def test_the_same_seed_gives_the_same_run_and_every_second_robot_is_driven() -> None:
    runs = []
    for _ in range(2):
        it = NavigatingWorld(SimMoveBase, 4, 2, seed=3)
        it.step(200.0)
        goals = {name: len(one.received) for name, one in it.navigation.items()}
        runs.append((goals, {name: robot.pose for name, robot in it.robots.items()}))
    assert runs[0] == runs[1]
    goals = runs[0][0]
    assert goals["robot_1"] > 0 and goals["robot_3"] > 0 and goals["robot_0"] == goals["robot_2"] == 0
