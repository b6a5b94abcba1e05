"""The adapter of robots with Nav2 as tests ask it, and a robot that it is asked about."""

import json
from typing import Any

from fleet_tui.model.events import Event
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal as KnownGoal
from fleet_tui.model.order import OrderState
from fleet_tui.model.robot import Reading, Robot, RobotMap
from fleet_tui.robots.adapter import Feed, Site
from fleet_tui.robots.nav2.adapter import Nav2
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.operations import Publish, decode
from tests.support.fleets import graph

ZERO = "AAAAAAAAAAAAAAAAAAAAAA=="


UUID = "Cii/ftYHQUKiCFVjZrbQVQ=="


def adapter(**profile: Any) -> Nav2:
    return Nav2(Profile(kind="nav2", **profile), Site())


def feeds(it: Nav2, robot: str = "tb2", *floors: str) -> dict[str, Feed]:
    return {feed.key: feed for feed in it.feeds(robot, floors or ("hall",))}


def read(it: Nav2, key: str, frame: str | dict[str, Any], robot: str = "tb2") -> list[Event]:
    """The facts of a message, or of a frame as it came."""
    if isinstance(frame, dict):
        frame = json.dumps({"op": "publish", "topic": "/t", "msg": frame})
    operation = decode(frame.encode())
    assert isinstance(operation, Publish)
    return list(it.read(feeds(it, robot)[key], operation.msg, 5.0))


def robot(*goals: KnownGoal, pose: Pose | None = None) -> Robot:
    robot_map = RobotMap(graph=graph(1, 2, 3).graph)
    return Robot(
        *("tb2", 1, "rosbridge", {"hall": robot_map}),
        pose=Reading(pose, 1.0) if pose else None,
        floor="hall",
        goals={goal.action: (goal,) for goal in goals},
    )


def known(id_: str, action: str, uuid: str = UUID, **more: Any) -> KnownGoal:
    return KnownGoal(id_, uuid, action, OrderState.IN_PROCESS, **more)
