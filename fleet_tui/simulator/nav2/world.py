"""Simulated robots with Nav2, advanced step by step: no I/O, random only by the seed."""

import random

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.nav2.navigation import DOCK, TO_POSE, WAYPOINTS, SimNavigation
from fleet_tui.simulator.navigating.poses import stamped
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.navigating.world import Clock, NavigatingWorld


class Nav2World(NavigatingWorld[SimNavigation]):
    """`robots` robots on `floors` floors, as in NavigatingWorld."""

    def navigate(self, robot: NavigatingRobot, ids: random.Random, clock: Clock) -> SimNavigation:
        """Make the navigation stack of a robot."""
        return SimNavigation(robot, ids, clock)

    def _assign(self, navigation: SimNavigation, is_low: bool) -> None:
        """Let a robot that is low dock, and send another one to a labelled vertex, every third time by way of
        another."""
        if is_low:
            navigation.take(DOCK, {"use_dock_id": True, "dock_id": "charger"})
            return
        floor, rng = navigation.robot.floor, self._rng
        spots = [floor.graph.vertices[id_] for id_ in rng.sample(tuple(floor.labels), 2)]
        poses = [stamped(Pose(spot.x, spot.y, rng.uniform(-3.0, 3.0))) for spot in spots]
        if rng.random() < 0.3:
            navigation.take(WAYPOINTS, {"number_of_loops": 0, "goal_index": 0, "poses": poses})
        else:
            navigation.take(TO_POSE, {"pose": poses[0], "behavior_tree": ""})
