"""Robots with move_base among what a bridge lists."""

from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.move_base.discovery import discover

TYPES = {
    "move_base/status": "actionlib_msgs/GoalStatusArray",
    "move_base/current_goal": "geometry_msgs/PoseStamped",
    "move_base/NavfnROS/plan": "nav_msgs/Path",
    "move_base/TrajectoryPlannerROS/local_plan": "nav_msgs/Path",
    "odom": "nav_msgs/Odometry",
    "amcl_pose": "geometry_msgs/PoseWithCovarianceStamped",
    "battery_state": "sensor_msgs/BatteryState",
}


class TestFound:
    """Such robots among what a bridge lists."""

    def test_by_namespaces(self) -> None:
        topics = {f"/{robot}/{name}": type_ for robot in ("a", "b") for name, type_ in TYPES.items()}
        found = discover(Listed({**topics, "/map": "nav_msgs/OccupancyGrid"}, {}))
        assert found.robots == {"a": ["floor_0"], "b": ["floor_0"]}
        assert not found.topics and not found.is_guess

    def test_alone_on_its_bridge(self) -> None:
        topics = {f"/{name}": type_ for name, type_ in TYPES.items()}
        found = discover(Listed({**topics, "/map": "nav_msgs/OccupancyGrid"}, {}))
        assert found.robots == {"robot_0": ["floor_0"]}
        assert found.topics["goal"] == "/move_base/goal" and found.topics["odometry"] == "/odom"

    def test_another_planner(self) -> None:
        types = {name.replace("NavfnROS", "GlobalPlanner"): type_ for name, type_ in TYPES.items()}
        found = discover(Listed({f"/a/{name}": type_ for name, type_ in types.items()}, {}))
        assert found.topics["plan"] == "/{robot}/move_base/GlobalPlanner/plan"

    def test_not_where_actions_are_of_ros_2_or_of_something_else(self) -> None:
        assert not discover(Listed({"/a/dock/status": "actionlib_msgs/GoalStatusArray"}, {})).robots
        assert not discover(Listed({"/a/move_base/status": "std_msgs/String"}, {})).robots
