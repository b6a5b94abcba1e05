"""The messages of robots with Nav2, as ROS has them."""

import math
from typing import Any

import numpy as np

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.floorplan import HEIGHT, ORIGIN, RESOLUTION, WIDTH
from fleet_tui.simulator.messages import float32
from fleet_tui.simulator.nav2.navigation import DOCK, THROUGH, WAYPOINTS, Navigation
from fleet_tui.simulator.nav2.poses import FRAME, solid
from fleet_tui.simulator.nav2.robot import Nav2Robot
from fleet_tui.simulator.robot import SPEED
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.goals import Goal, Id, uuid_of
from fleet_tui.simulator.warehouse import Floor

Message = dict[str, Any]

NOTHING, STOP = 0, 1  # nav2_msgs/CollisionMonitorState
CHARGING, DISCHARGING, LION = 1, 2, 2  # sensor_msgs/BatteryState
UNMEASURED = dict.fromkeys(("temperature", "current", "charge", "capacity", "design_capacity"), math.nan)
GIGA = 10**9


def odometry(robot: Nav2Robot, header: Message) -> Message:
    """nav_msgs/Odometry in the robot's own frame; what it doesn't measure is NaN."""
    # What a planar robot can't do it does not do for sure; the angles it can't tilt to are not measured.
    spread = np.diag([0.01, 0.01, 0.0, math.nan, math.nan, 0.03]).ravel()
    twist = {"linear": _vector(SPEED if robot.moving else 0.0), "angular": _vector(0.0)}
    return {
        "header": header,
        "child_frame_id": f"{robot.name}/base_link",
        "pose": {"pose": solid(robot.odom), "covariance": spread},
        "twist": {"twist": twist, "covariance": np.zeros(36)},
    }


def localisation(pose: Pose, variance: float, header: Message) -> Message:
    """geometry_msgs/PoseWithCovarianceStamped."""
    spread = np.diag([variance, variance, 0.0, 0.0, 0.0, variance]).ravel()
    return {"header": header, "pose": {"pose": solid(pose), "covariance": spread}}


def battery(robot: Nav2Robot, header: Message) -> Message:
    """sensor_msgs/BatteryState."""
    return {
        "header": header,
        "voltage": float32(10.5 + 0.02 * robot.battery),
        **UNMEASURED,
        "percentage": float32(robot.percent * robot.battery),
        "power_supply_status": CHARGING if robot.docked else DISCHARGING,
        "power_supply_health": 0,
        "power_supply_technology": LION,
        "present": True,
        "cell_voltage": [],
        "cell_temperature": [],
        "location": "",
        "serial_number": "",
    }


def path(robot: Nav2Robot, header: Message) -> Message:
    """nav_msgs/Path from where it is to its goal."""
    spots = [(robot.pose.x, robot.pose.y), *robot.way]
    return {"header": header, "poses": [{"header": header, "pose": solid(Pose(*spot))} for spot in spots]}


def collision(blocked: bool) -> Message:
    """nav2_msgs/CollisionMonitorState."""
    return {
        "action_type": STOP if blocked else NOTHING,
        "polygon_name": "PolygonStop" if blocked else "",
    }


def grid(floor: Floor, header: Message, loaded: Message) -> Message:
    """nav_msgs/OccupancyGrid."""
    info = {
        "map_load_time": loaded,
        "resolution": float32(RESOLUTION),
        "width": WIDTH,
        "height": HEIGHT,
        "origin": solid(Pose(*ORIGIN)),
    }
    return {"header": header, "info": info, "data": floor.cells.ravel()}


def statuses(report: list[tuple[Id, int, int]]) -> Message:
    """action_msgs/GoalStatusArray."""
    return {
        "status_list": [
            {"goal_info": goal_info(id_, stamp), "status": status} for id_, stamp, status in report
        ]
    }


def goal_info(id_: Id, stamp: int) -> Message:
    """action_msgs/GoalInfo."""
    time = {"sec": stamp // GIGA, "nanosec": stamp % GIGA}
    return {"goal_id": {"uuid": uuid_of(id_)}, "stamp": time}


def feedback(navigation: Navigation, verb: str, goal: Goal, header: Message) -> Message:
    """The feedback of an action."""
    robot = navigation.robot
    if verb == WAYPOINTS:
        return {"current_waypoint": navigation.waypoint()}
    if verb == DOCK:
        return {"state": 1, "docking_time": _duration(goal.age), "num_retries": 0}
    told = {
        "current_pose": {"header": header, "pose": solid(robot.pose)},
        "navigation_time": _duration(goal.age),
        "estimated_time_remaining": _duration(robot.time_remaining),
        "number_of_recoveries": robot.recoveries,
        "distance_remaining": float32(robot.distance_remaining),
    }
    return told | {"number_of_poses_remaining": robot.stops} if verb == THROUGH else told


def result(goal: Goal, distro: str) -> Message:
    """The result of an action; Humble's says less."""
    if distro != "humble":
        return goal.result
    if "missed_waypoints" in goal.result:
        return {"missed_waypoints": [missed["index"] for missed in goal.result["missed_waypoints"]]}
    return goal.result if "success" in goal.result else {}


def header(dialect: Dialect, now: float, frame: str = FRAME) -> Message:
    """A header in the map's frame, or another."""
    return dialect.header(0, now, frame)


def _vector(x: float) -> Message:
    return {"x": x, "y": 0.0, "z": 0.0}


def _duration(seconds: float) -> Message:
    return {"sec": int(seconds), "nanosec": 0}
