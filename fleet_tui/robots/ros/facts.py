"""Events from messages of the common ROS packages, for any kind of robot."""

import math
from array import array
from collections.abc import Callable

from fleet_tui.model import events
from fleet_tui.model.geometry import MapFrame, Pose, yaw_of_quaternion
from fleet_tui.model.grid import check_frame
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.errors import MapError, WireError

# (robot, floor, message still encoded, monotonic seconds of arrival) -> the event; raises WireError.
Translate = Callable[[str, str, object, float], events.Event]

FARTHEST = 1e9
"""Metres; a position farther off is on no floor, and a picture that includes it would overflow."""


def is_place(*numbers: float) -> bool:
    """Tell whether these can be coordinates."""
    return all(abs(number) <= FARTHEST for number in numbers)


def check_finite(*numbers: float, field: str) -> None:
    """Raise WireError unless these can be coordinates."""
    if not is_place(*numbers):
        raise WireError(f"{field} is not a finite number")


def pose_of(pose: ros.RosPose, field: str, scale: float = 1.0) -> Pose:
    """Return a pose on the ground. Raises WireError."""
    x, y = pose.position.x * scale, pose.position.y * scale
    check_finite(x, y, field=f"{field}.position")
    turn = pose.orientation
    try:
        return Pose(x, y, yaw_of_quaternion(turn.x, turn.y, turn.z, turn.w))
    except ValueError as problem:
        raise WireError(f"{field}.orientation: {problem}") from None


def frame_of(metadata: ros.MapMetadata, added: bool) -> MapFrame:
    """Return the placement of a map in the world. Raises WireError."""
    try:
        origin = pose_of(metadata.origin, "origin")
    except WireError:
        # Map servers are known to leave the origin's rotation unset: this means no rotation.
        position = metadata.origin.position
        check_finite(position.x, position.y, field="origin.position")
        origin = Pose(position.x, position.y)
    frame = MapFrame(metadata.resolution, metadata.width, metadata.height, origin, added)
    check_finite(frame.resolution, field="resolution")
    try:
        check_frame(frame)
    except MapError as problem:
        raise WireError(str(problem)) from None
    return frame


def read_bool(names: Names, key: str, event: Callable[[str, float, bool], events.Event]) -> Translate:
    """Read a std_msgs/Bool."""
    read = ros.reader(ros.Bool, names.paths(key))
    return lambda robot, _floor, msg, at: event(robot, at, read(msg).data)


def read_number(
    names: Names, key: str, event: Callable[[str, float, float], events.Event], low: float, high: float
) -> Translate:
    """Read a std_msgs/Float32 within limits, times the profile's scale."""
    read, scale = ros.reader(ros.Float32, names.paths(key)), names.scale(key)

    def translate(robot: str, _floor: str, msg: object, at: float) -> events.Event:
        number = read(msg).data * scale
        if not (math.isfinite(number) and low <= number <= high):
            raise WireError(f"data is {number}, not between {low:g} and {high:g}")
        return event(robot, at, number)

    return translate


def read_pose(names: Names) -> Translate:
    """Read a geometry_msgs/PoseStamped."""
    read, scale = ros.reader(ros.PoseStamped, names.paths("pose")), names.scale("pose")

    def translate(robot: str, _floor: str, msg: object, at: float) -> events.Event:
        message = read(msg)
        pose = pose_of(message.pose, "pose", scale)
        return events.PoseReported(robot, at, pose, message.header.frame_id, message.header.stamp.seconds)

    return translate


def read_metadata(names: Names) -> Translate:
    """Read a nav_msgs/MapMetaData."""
    read, added = ros.reader(ros.MapMetadata, names.paths("map_metadata")), names.profile.origin == "added"
    return lambda robot, floor, msg, _at: events.FrameReceived(robot, floor, frame_of(read(msg), added))


def read_map(names: Names) -> Translate:
    """Read a nav_msgs/OccupancyGrid."""
    read, added = ros.reader(ros.OccupancyGridMessage, names.paths("map")), names.profile.origin == "added"

    def translate(robot: str, floor: str, msg: object, at: float) -> events.Event:
        # With numpy, whose import takes longer than a whole command without a screen.
        from fleet_tui.model.occupancy import grid_from_ros

        message = read(msg)
        data = message.data if isinstance(message.data, bytes) else array("b", message.data).tobytes()
        try:
            grid = grid_from_ros(frame_of(message.info, added), data)
            return events.GridReceived(robot, floor, grid, at)
        except MapError as problem:
            raise WireError(str(problem)) from None

    return translate
