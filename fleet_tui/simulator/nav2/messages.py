"""The messages of robots with Nav2, as ROS has them."""

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.messages import Message, float32, solid
from fleet_tui.simulator.nav2.navigation import DOCK, SPIN, THROUGH, WAYPOINTS, SimNavigation
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.ros.goals import Id, ServedGoal, uuid_of

# nav2_msgs/CollisionMonitorState
NOTHING = 0
STOP = 1
GIGA = 10**9


def collision(blocked: bool) -> Message:
    """nav2_msgs/CollisionMonitorState."""
    return {"action_type": STOP if blocked else NOTHING, "polygon_name": "PolygonStop" if blocked else ""}


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


def believed(robot: NavigatingRobot, now: float) -> tuple[Pose, float]:
    """Return where its navigation believes the robot to be, and when that was so."""
    return robot.localised_last or (robot.pose, now)


def feedback(navigation: SimNavigation, verb: str, goal: ServedGoal, header: Message) -> Message:
    """The feedback of an action."""
    robot = navigation.robot
    if verb == WAYPOINTS:
        return {"current_waypoint": navigation.waypoint()}
    if verb == DOCK:
        return {"state": 1, "docking_time": _duration(goal.age), "num_retries": 0}
    if verb == SPIN:
        return {"angular_distance_traveled": float32(goal.request["target_yaw"] - robot.turns_left)}
    values = {
        "current_pose": {"header": header, "pose": solid(believed(robot, 0.0)[0])},
        "navigation_time": _duration(goal.age),
        "estimated_time_remaining": _duration(robot.time_remaining),
        "number_of_recoveries": robot.recoveries,
        "distance_remaining": float32(robot.distance_remaining),
    }
    return values | {"number_of_poses_remaining": robot.stops} if verb == THROUGH else values


def result(goal: ServedGoal, distro: str) -> Message:
    """The result of an action; that of Humble has fewer fields."""
    if distro != "humble":
        return goal.result
    if "missed_waypoints" in goal.result:
        return {"missed_waypoints": [missed["index"] for missed in goal.result["missed_waypoints"]]}
    return goal.result if "success" in goal.result else {}


def _duration(seconds: float) -> Message:
    return {"sec": int(seconds), "nanosec": 0}
