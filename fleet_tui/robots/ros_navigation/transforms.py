"""Transforms (tf2_msgs/TFMessage) as places of robots: map -> odom -> base, named as in REP 105."""

from collections.abc import Callable, Iterator, Sequence

from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import OdometryReported, OriginReported, Place
from fleet_tui.model.set_up.frames import BASES
from fleet_tui.robots.ros.facts import pose_of
from fleet_tui.robots.ros.messages import RosPose
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros.set_up.frames import read_transforms

MAP = "map"
ODOM = "odom"

# (robots, message still encoded, monotonic seconds of arrival, whether it is a static one) -> the events;
# raises WireError.
ReadPlaces = Callable[[Sequence[str], object, float, bool], Iterator[Place]]


def read_places(names: Names) -> ReadPlaces:
    """Read where the odometry of these robots begins on the map, and where it has them. A robot that never
    had an odometry frame has its place on the map alone."""

    def places(robots: Sequence[str], msg: object, at: float, is_fixed: bool) -> Iterator[Place]:
        for one in read_transforms(msg):
            child, parent = one.child_frame_id.lstrip("/"), one.header.frame_id.lstrip("/")
            robot, frame, above = _robot_of(child, robots), _bare(child), _bare(parent)
            is_base = frame in BASES or (bool(robot) and child == names.base_frame(robot))
            if not robot or not (frame == ODOM or (is_base and above in (ODOM, MAP))):
                continue
            pose = pose_of(
                RosPose(one.transform.translation, one.transform.rotation), f"transform of {frame}"
            )
            if frame == ODOM or above == MAP:
                yield OriginReported(robot, at, pose, parent, is_fixed)
            if is_base:
                driven = pose if above == ODOM else Pose(0.0, 0.0)
                yield OdometryReported(robot, at, driven, one.header.stamp.seconds, is_transform=True)

    return places


def _bare(frame: str) -> str:
    """Return `odom` of `robot_0/odom`."""
    return frame.rpartition("/")[2]


def _robot_of(frame: str, robots: Sequence[str]) -> str:
    """Return the robot that a frame belongs to by its prefix, empty for none of these; one alone on its topic
    needs no prefix."""
    prefix = frame.rpartition("/")[0]
    if not prefix and len(robots) == 1:
        return robots[0]
    return prefix if prefix in robots else ""
