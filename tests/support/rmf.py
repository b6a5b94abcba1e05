"""Messages of Open-RMF as its nodes write them, and robots of its fleets without a wire."""

import json
from typing import Any

from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import TaskReported
from fleet_tui.model.navigation import Goal
from fleet_tui.model.order import OrderState
from fleet_tui.robots.adapter import Feed, Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.rmf.adapter import Rmf
from fleet_tui.robots.ros.operations import Publish, decode
from tests.support.fleets import T0, fleet, link_up, of_kinds, reduced, tick

TINY, CARRIER = "tiny/t1", "carrier/c1"
ROBOTS = (TINY, "tiny/t2", CARRIER)
ON, QUEUED, DONE = OrderState.IN_PROCESS, OrderState.QUEUED, OrderState.DONE


def adapter(**profile: Any) -> Rmf:
    return Rmf(Profile(kind="rmf", **profile), Site())


def feed(it: Rmf, key: str) -> Feed:
    """The topic of a key, for all robots."""
    found = next(one for one in it.feeds(ROBOTS[0], ["L1"]) if one.key == key)
    return found._replace(robots=ROBOTS)


def read(it: Rmf, key: str, msg: object) -> list[Event]:
    """The events of a message as it comes over the wire."""
    operation = decode(json.dumps({"op": "publish", "topic": "/t", "msg": msg}).encode())
    assert isinstance(operation, Publish)
    return list(it.read(feed(it, key), operation.msg, 5.0))


def text(value: object) -> dict[str, str]:
    """A std_msgs/String with JSON."""
    return {"data": json.dumps(value)}


def member(name: str, t: int = 7, **more: Any) -> dict[str, Any]:
    """An rmf_fleet_msgs/RobotState."""
    place = {"t": {"sec": t, "nanosec": 0}, "x": 1.0, "y": 2.0, "yaw": 0.5, "level_name": "L2", "index": 0}
    mode = {"mode": 2, "mode_request_id": 0, "performing_action": ""}
    usual = {"name": name, "model": "", "task_id": "", "seq": 0, "mode": mode, "battery_percent": 80.0}
    return {**usual, "location": place, "path": [], **more}


def task(id_: str = "patrol-1", status: str = "underway", robot: str = TINY, **more: Any) -> dict[str, Any]:
    """The state of a task."""
    group, _, name = robot.partition("/")
    assigned = {"group": group, "name": name}
    return {"booking": {"id": id_}, "category": "patrol", "status": status, "assigned_to": assigned, **more}


def update(state: dict[str, Any]) -> dict[str, str]:
    """A task_state_update."""
    return text({"type": "task_state_update", "data": state})


def rmf_fleet() -> FleetState:
    """Two robots of fleets, online at T0."""
    return reduced(of_kinds(fleet(2), adapter().kind, adapter().kind), link_up(T0), tick(T0))


def reported(
    at: float, id_: str, state: OrderState = ON, robot: str = "robot_0", **more: Any
) -> TaskReported:
    """A task of a robot."""
    return TaskReported(robot, at, Goal(id_, id_, "task", state, **more))
