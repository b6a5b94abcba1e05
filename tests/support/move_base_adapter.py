"""The adapter of robots with move_base as tests ask it, and a robot that it is asked about."""

import json
from typing import Any

from fleet_tui.model.commands import Command
from fleet_tui.model.events import Event
from fleet_tui.model.navigation import Goal
from fleet_tui.model.navigation_events import GoalsReported
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.robots.adapter import Feed, Publication, Site
from fleet_tui.robots.move_base.adapter import MoveBase
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.operations import Publish, decode
from tests.support.fleets import graph

UNIQUE = "0123456789abcdef0123456789abcdef"


OWN = "fleet-tui-01234567-89ab-cdef-0123-456789abcdef"


RVIZ = "/r1/move_base-4-1700000000.25"


NEVER = {"secs": 0, "nsecs": 0}


def adapter(**profile: Any) -> MoveBase:
    return MoveBase(Profile(kind="move_base", **profile), Site())


def feeds(it: MoveBase) -> dict[str, Feed]:
    return {feed.key: feed for feed in it.feeds("r1", ("hall",))}


def read(it: MoveBase, key: str, message: dict[str, Any]) -> list[Event]:
    operation = decode(json.dumps({"op": "publish", "topic": "/t", "msg": message}).encode())
    assert isinstance(operation, Publish)
    return list(it.read(feeds(it)[key], operation.msg, 5.0))


def status(*goals: tuple[str, int, str]) -> dict[str, Any]:
    header = {"seq": 9, "stamp": {"secs": 1700000009, "nsecs": 0}, "frame_id": ""}
    return {
        "header": header,
        "status_list": [
            {"goal_id": {"stamp": {"secs": 1700000000, "nsecs": 0}, "id": id_}, "status": state, "text": text}
            for id_, state, text in goals
        ],
    }


def listed(*goals: tuple[str, int, str]) -> tuple[Goal, ...]:
    reported = read(adapter(), "status", status(*goals))[0]
    assert isinstance(reported, GoalsReported)
    return reported.goals


def robot(*goals: Goal, received: bool = True, named: str = "") -> Robot:
    robot_map = RobotMap(graph=graph(1, 2, 3).graph)
    known = {"move_base": goals} if received else {}
    return Robot("r1", 1, "rosbridge", {"hall": robot_map}, floor="hall", goals=known, named=named)


def sent(command: Command, known: Robot, **profile: Any) -> list[Publication]:
    found = adapter(**profile).outgoing(command, 1, known, UNIQUE)
    assert all(isinstance(one, Publication) for one in found)
    return [one for one in found if isinstance(one, Publication)]
