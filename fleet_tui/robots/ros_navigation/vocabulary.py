"""The usual names that both navigation stacks share, `{robot}` being the namespace."""

from fleet_tui.robots.ros.fields import GRID, HEADER, alike, placed
from fleet_tui.robots.ros.set_up import names as set_up

TOPICS = {
    "odometry": ("/{robot}/odom", "nav_msgs/Odometry"),
    "pose": ("/{robot}/amcl_pose", "geometry_msgs/PoseWithCovarianceStamped"),
    "tf": ("/tf", "tf2_msgs/TFMessage"),
    "battery": ("/{robot}/battery_state", "sensor_msgs/BatteryState"),
    "floor": ("", "std_msgs/String"),
    "pause_navigation": ("", "std_msgs/Bool"),
    "map": ("/map", "nav_msgs/OccupancyGrid"),
    **set_up.with_names(
        set_up.TOPICS,
        {
            "initial_pose": "/{robot}/initialpose",
            "scan": "/{robot}/scan",
            "camera": set_up.CAMERA,
            "drive": "/{robot}/cmd_vel",
        },
    ),
}
FLOOR_TOPICS = frozenset({"map"})
FIELDS = {
    "odometry": {**HEADER, **placed("pose.pose.")},
    "pose": {**HEADER, **placed("pose.pose."), "covariance": "pose.covariance"},
    "battery": alike("percentage"),
    "floor": alike("data"),
    "plan": alike("poses"),
    "map": GRID,
    "mode": alike("data"),
}
SCALES = frozenset({"odometry", "pose", "battery"})
PAUSES = {"pause": ("", "std_srvs/Trigger"), "resume": ("", "std_srvs/Trigger")}
"""Services that a site may name."""
