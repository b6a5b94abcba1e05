"""Names of set-up: topics and services that a kind has only if it, or a site's profile, names them."""

from collections.abc import Mapping
from typing import Any

TWIST = "geometry_msgs/Twist"
STAMPED_TWIST = "geometry_msgs/TwistStamped"
TOPICS: Mapping[str, tuple[str, str]] = {
    "initial_pose": ("", "geometry_msgs/PoseWithCovarianceStamped"),
    "scan": ("", "sensor_msgs/LaserScan"),
    "path": ("", "nav_msgs/Path"),
    "camera": ("", "sensor_msgs/CompressedImage"),
    "tf_static": ("/tf_static", "tf2_msgs/TFMessage"),
    "mode": ("", "std_msgs/String"),
    "drive": ("", TWIST),
}
SERVICES: Mapping[str, tuple[str, str]] = {
    "localise": ("", "std_srvs/Empty"),
    "settle": ("", "std_srvs/Empty"),
    "mapping_on": ("", "std_srvs/SetBool"),
    "mapping_off": ("", "std_srvs/SetBool"),
    "map_save": ("", "slam_toolbox_msgs/SaveMap"),
    "map_pose_graph": ("", "slam_toolbox_msgs/SerializePoseGraph"),
}
SAVING: Mapping[str, Mapping[str, Any]] = {
    "map_save": {"name": {"data": "{name}"}},
    "map_pose_graph": {"filename": "{name}"},
}
REQUESTS: Mapping[str, Mapping[str, Any]] = {
    "mapping_on": {"data": True},
    "mapping_off": {"data": False},
    **SAVING,
}
"""Fields of the services that have any."""
INVERSE: Mapping[str, Mapping[str, Any]] = {
    **REQUESTS,
    "mapping_on": {"data": False},
    "mapping_off": {"data": True},
}
"""The same for services that switch mapping off."""
ANSWERS: Mapping[str, Mapping[str, Any]] = {"map_save": {}, "map_pose_graph": {}}
"""Fields of an answer that mean success: on ROS 1 these have none."""


CAMERA = "/{robot}/camera/image_raw/compressed"
"""The usual topic of a compressed camera, below a robot's own name."""


def with_names(
    usual: Mapping[str, tuple[str, str]], given: Mapping[str, str]
) -> Mapping[str, tuple[str, str]]:
    """Return these topics or services with the names that a kind gives to some of them."""
    return {key: (given.get(key, name), type_) for key, (name, type_) in usual.items()}
