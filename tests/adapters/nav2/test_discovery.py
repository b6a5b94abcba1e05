"""Robots with Nav2 among what a bridge lists."""

import pytest

from fleet_tui.adapters.discovery import Listed
from fleet_tui.adapters.nav2.discovery import discover as discover_nav2

ODOM, AMCL = "nav_msgs/msg/Odometry", "geometry_msgs/msg/PoseWithCovarianceStamped"


BATTERY, MAP, TEXT = "sensor_msgs/msg/BatteryState", "nav_msgs/msg/OccupancyGrid", "std_msgs/msg/String"


ONE = {"/tb1/odom": ODOM, "/tb1/amcl_pose": AMCL, "/tb1/battery_state": BATTERY, "/map": MAP}


DRIVES = ("/tb1/navigate_to_pose", "/tb1/follow_waypoints")


def test_what_no_robot_has_is_switched_off_and_said() -> None:
    found = discover_nav2(Listed({"/tb1/odom": ODOM, "/tb1/amcl_pose": AMCL}, {}, DRIVES))
    assert found.topics == {"battery": "", "blocked": "", "map": ""}
    assert "battery: no topic of type sensor_msgs/BatteryState" in found.notes["topics"]
    assert not found.live_maps


@pytest.mark.parametrize(
    ("listed", "robots"),
    [
        (Listed({}, {}, ("/a/b/navigate_to_pose",)), ["a/b"]),
        (Listed({}, {}, ("/r10/follow_waypoints", "/r9/follow_waypoints", "/spin")), ["r9", "r10"]),
        (Listed({}, {}, ("/navigate_to_pose", "/r1/navigate_to_pose")), ["r1"]),
        (Listed({}, {"/r1/lifecycle_manager_navigation/is_active": "std_srvs/srv/Trigger"}), ["r1"]),
        (Listed(ONE, {}), ["tb1"]),
        (Listed({"/tb1/odom": ODOM}, {}), []),
        # On ROS 1 the same names are those of move_base.
        (Listed({topic: type_.replace("/msg", "") for topic, type_ in ONE.items()}, {}), []),
        (Listed({}, {}, ("/r1/fibonacci", "/xnavigate_to_pose")), []),
    ],
)
def test_the_signs_of_such_robots(listed: Listed, robots: list[str]) -> None:
    assert list(discover_nav2(listed).robots) == robots


def test_costmaps_and_the_pose_that_is_set_are_not_taken() -> None:
    listed = Listed(
        {
            "/tb1/odom": ODOM,
            "/tb1/initialpose": AMCL,
            "/tb1/slam/pose": AMCL,
            "/tb1/global_costmap/costmap": MAP,
            "/tb1/map": MAP,
            "/tb1/current_floor": TEXT,
        },
        {},
        DRIVES,
    )
    found = discover_nav2(listed)
    assert (found.topics["pose"], found.topics["map"]) == ("/{robot}/slam/pose", "/{robot}/map")
    assert found.notes["topics"][0].startswith('floor = "/{robot}/current_floor"')


def test_a_robot_without_a_namespace_has_set_up_without_one() -> None:
    listed = Listed({"/odom": ODOM, "/amcl_pose": AMCL}, {}, ("/navigate_to_pose",))
    found = discover_nav2(listed)
    assert found.topics["initial_pose"] == "/initialpose" and found.topics["scan"] == "/scan"
    assert found.services["settle"] == "/request_nomotion_update"
    assert found.services["map_save"] == "/map_saver/save_map"
    assert not any("{robot}" in name for name in (*found.topics.values(), *found.services.values()))


def test_a_laser_of_another_name_is_found_by_its_type() -> None:
    scan = "sensor_msgs/msg/LaserScan"
    named = discover_nav2(Listed({**ONE, "/tb1/scan": scan}, {}, DRIVES))
    assert "scan" not in named.topics
    other = discover_nav2(Listed({**ONE, "/tb1/front_scan": scan}, {}, DRIVES))
    assert other.topics["scan"] == "/{robot}/front_scan"
    assert "scan" not in discover_nav2(Listed(ONE, {}, DRIVES)).topics
