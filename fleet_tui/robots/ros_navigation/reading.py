"""Messages of navigating robots of either ROS as events."""

import math
from collections.abc import Callable, Iterable

from fleet_tui.model import events, navigation_events
from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros import navigation as nav
from fleet_tui.robots.ros.facts import pose_of
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.errors import WireError
from fleet_tui.text.limits import LONGEST_NAME, truncate

# (robot, message still encoded, monotonic seconds of arrival) -> the events; raises WireError.
Read = Callable[[str, object, float], Iterable[events.Event]]


def read_odometry(names: Names) -> Read:
    """Read a nav_msgs/Odometry."""
    read, scale = ros.reader(nav.Located, names.paths("odometry")), names.scale("odometry")

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        message = read(msg)
        pose = pose_of(message.pose.pose, "pose", scale)
        speed = _speed(message.twist.twist, scale) if message.twist is not None else None
        yield navigation_events.OdometryReported(robot, at, pose, message.header.stamp.seconds, speed=speed)

    return facts


def _speed(twist: nav.MeasuredTwist, scale: float) -> Speeds | None:
    """Return the speeds on the ground, None if a part of it is missing or not a number."""
    parts = (twist.linear.x, twist.linear.y, twist.angular.z)
    x, y, turning = (one if one is not None else math.nan for one in parts)
    return Speeds(x * scale, y * scale, turning) if math.isfinite(x + y + turning) else None


def read_localisation(names: Names) -> Read:
    """Read a geometry_msgs/PoseWithCovarianceStamped."""
    read, scale = ros.reader(nav.Located, names.paths("pose")), names.scale("pose")

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        message = read(msg)
        pose, header = pose_of(message.pose.pose, "pose", scale), message.header
        variance = _variance(message.pose.covariance)
        yield navigation_events.LocalisationReported(
            robot, at, pose, header.frame_id, header.stamp.seconds, variance
        )

    return facts


def _variance(covariance: list[float | None]) -> float | None:
    """Return the variance of x and y together, None if one of them is missing or not a number."""
    found = [covariance[n] if n < len(covariance) else None for n in (0, 7)]
    known = [one for one in found if one is not None and math.isfinite(one)]
    return sum(known) if len(known) == len(found) else None


def read_battery(names: Names) -> Read:
    """Read a sensor_msgs/BatteryState. Its scale is that of the profile, else it is detected."""
    read = ros.reader(nav.BatteryState, names.paths("battery"))
    scale = names.profile.scales.get("battery")

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        charge = read(msg).percentage
        if charge is None or not math.isfinite(charge):
            yield navigation_events.Unmeasured(robot, at, "battery")
            return
        percent = charge if scale is None else charge * scale
        if not 0.0 <= percent <= 101.0:
            raise WireError(f"percentage is {charge}, not between 0 and 100 times the scale")
        yield events.BatteryReported(robot, at, percent, is_raw=scale is None)

    return facts


def read_floor(names: Names) -> Read:
    """Read a std_msgs/String with the name of a floor."""
    read = ros.reader(nav.Text, names.paths("floor"))

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        yield navigation_events.FloorReported(robot, at, truncate(read(msg).data.lstrip("/"), LONGEST_NAME))

    return facts


def read_plan(names: Names) -> Read:
    """Read a nav_msgs/Path."""
    read = ros.reader(nav.Path, names.paths("plan"))
    read_pose = ros.reader(nav.PathPose)

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        poses = read(msg).poses
        if poses:
            yield navigation_events.PlanReported(robot, at, pose_of(read_pose(poses[-1]).pose, "poses[-1]"))

    return facts
