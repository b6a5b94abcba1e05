"""Messages of navigating robots, ROS 1 and 2: odometry, localisation, batteries, goals, paths."""

from typing import Any

import msgspec

from fleet_tui.robots.ros.messages import Header, PoseStamped, RosPose, Stamp


class PoseWithCovariance(msgspec.Struct, frozen=True):
    """geometry_msgs/PoseWithCovariance: 36 numbers, row-major, x and y first; NaN if unknown."""

    pose: RosPose
    covariance: list[float | None] = []


class Vector(msgspec.Struct, frozen=True):
    """geometry_msgs/Vector3: None for NaN."""

    x: float | None = None
    y: float | None = None
    z: float | None = None


class MeasuredTwist(msgspec.Struct, frozen=True):
    """geometry_msgs/Twist: metres and radians per second."""

    linear: Vector = Vector()
    angular: Vector = Vector()


class TwistWithCovariance(msgspec.Struct, frozen=True):
    """geometry_msgs/TwistWithCovariance."""

    twist: MeasuredTwist = MeasuredTwist()


class Located(msgspec.Struct, frozen=True):
    """nav_msgs/Odometry and geometry_msgs/PoseWithCovarianceStamped, of which only the first has a twist."""

    header: Header
    pose: PoseWithCovariance
    twist: TwistWithCovariance | None = None


class BatteryState(msgspec.Struct, frozen=True):
    """sensor_msgs/BatteryState: `percentage` is 0 to 1 by its definition, None (NaN) if not measured; some
    robots send 0 to 100."""

    percentage: float | None


class Text(msgspec.Struct, frozen=True):
    """std_msgs/String."""

    data: str


class CollisionMonitorState(msgspec.Struct, frozen=True):
    """nav2_msgs/CollisionMonitorState."""

    action_type: int
    polygon_name: str = ""


class PathPose(msgspec.Struct, frozen=True):
    pose: RosPose


class Path(msgspec.Struct, frozen=True):
    """nav_msgs/Path, its poses unread: only the last one counts."""

    poses: list[Any]


class GoalId(msgspec.Struct, frozen=True):
    """unique_identifier_msgs/UUID: base64 in JSON, a list of numbers in CBOR."""

    uuid: str


class TakenGoal(msgspec.Struct, frozen=True):
    """action_msgs/GoalInfo."""

    goal_id: GoalId
    stamp: Stamp = Stamp()


class GoalStatus(msgspec.Struct, frozen=True):
    """action_msgs/GoalStatus."""

    goal_info: TakenGoal
    status: int


class GoalStatusArray(msgspec.Struct, frozen=True):
    """action_msgs/GoalStatusArray, its goals unread: one bad one must not cost the others."""

    status_list: list[Any]


class Duration(msgspec.Struct, frozen=True):
    """builtin_interfaces/Duration."""

    sec: int = 0
    nanosec: int = 0

    @property
    def seconds(self) -> float:
        """Return the whole duration in seconds."""
        return self.sec + self.nanosec * 1e-9


class Feedback(msgspec.Struct, frozen=True):
    """Feedback of NavigateToPose, NavigateThroughPoses and FollowWaypoints; each has some of the fields."""

    current_pose: PoseStamped | None = None
    distance_remaining: float | None = None
    estimated_time_remaining: Duration | None = None
    navigation_time: Duration | None = None
    number_of_recoveries: int | None = None
    current_waypoint: int | None = None


class FeedbackMessage(msgspec.Struct, frozen=True):
    """Feedback of a goal, as on its topic."""

    goal_id: GoalId
    feedback: Feedback
