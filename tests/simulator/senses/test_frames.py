"""The static frames of simulated robots: one message of each, for late subscribers too."""

from fleet_tui.model.set_up.frames import Mount, mount_of
from fleet_tui.robots.ros.set_up.frames import read_frames
from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.senses.laser import MOUNT, frames_topic


def test_each_robot_tells_where_its_laser_is() -> None:
    for dialect, type_ in ((ROS1, "tf2_msgs/TFMessage"), (ROS2, "tf2_msgs/msg/TFMessage")):
        topic = frames_topic(["robot_0", "robot_1"], 7.0, dialect)
        assert (topic.name, topic.type, topic.latched) == ("/tf_static", type_, True)
        assert topic.history is not None
        first, second = (read_frames(payload.msg) for payload in topic.history())
        assert set(first) == {"robot_0/base_link", "robot_0/laser"}
        found = mount_of(second, "", "robot_1/laser")
        assert isinstance(found, Mount) and not found.is_flipped
        assert all(
            abs(value) < 1e-9
            for value in (found.pose.x - MOUNT.x, found.pose.y - MOUNT.y, found.pose.yaw - MOUNT.yaw)
        )
