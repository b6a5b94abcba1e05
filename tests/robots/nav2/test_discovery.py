"""Robots with Nav2 among what a bridge lists."""

import pytest

from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.nav2.discovery import discover as discover_nav2
from fleet_tui.robots.nav2.vocabulary import VOCABULARY
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.names import Names
from tests.support.nav2_recordings import recorded_site

TABLES = "topics", "services", "actions"
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


def test_a_robot_without_a_namespace_has_every_name_without_one() -> None:
    found = discover_nav2(recorded_site())
    assert list(found.robots) == ["robot_0"]
    names = Names(VOCABULARY, Profile(kind="nav2", **{table: getattr(found, table) for table in TABLES}))
    topics = [names.topic(key, "robot_0", "floor_0") for key in VOCABULARY.topics]
    services = [names.service(key, "robot_0") for key in VOCABULARY.services]
    actions = [names.action(key, "robot_0") for key in VOCABULARY.actions]
    assert not [name for name in (*topics, *services, *actions) if "robot_0" in name]
    assert names.topic("plan", "robot_0") == "/plan" and names.topic("tf_static", "robot_0") == "/tf_static"
    assert names.service("graph_load", "robot_0") == "/route_server/set_route_graph"
    assert {names.topic(key, "robot_0") for key in ("pose", "odometry")} <= recorded_site().topics.keys()


def test_transforms_of_each_robot_in_its_namespace_are_found_there() -> None:
    tf = "tf2_msgs/msg/TFMessage"
    own = discover_nav2(Listed({**ONE, "/tb1/tf": tf, "/tb1/tf_static": tf}, {}, DRIVES))
    assert (own.topics["tf"], own.topics["tf_static"]) == ("/{robot}/tf", "/{robot}/tf_static")
    shared = discover_nav2(Listed({**ONE, "/tf": tf, "/tf_static": tf}, {}, DRIVES))
    assert "tf" not in shared.topics and "tf_static" not in shared.topics


def test_a_service_of_another_name_is_found_by_its_type_if_that_tells_what_it_does() -> None:
    services = {"/tb1/saver/save": "nav2_msgs/srv/SaveMap", "/tb1/go": "std_srvs/srv/Trigger"}
    found = discover_nav2(Listed(ONE, services, DRIVES))
    assert found.services == {"map_save": "/{robot}/saver/save"}
    several = {**services, "/tb1/other/save": "nav2_msgs/srv/SaveMap"}
    assert discover_nav2(Listed(ONE, several, DRIVES)).services == {}


SAVE = "nav2_msgs/srv/SaveMap"


@pytest.mark.parametrize(
    ("services", "named"),
    [
        # Two robots, one of which has the service, or each has it under another name.
        ({"/tb1/saver/save": SAVE}, "/{robot}/saver/save"),
        ({"/tb1/saver/save": SAVE, "/tb2/saver/save": SAVE}, "/{robot}/saver/save"),
        ({"/tb1/saver/save": SAVE, "/tb2/map_saver/save_map": SAVE}, None),
        ({"/tb1/saver/save": SAVE, "/tb2/other/save": SAVE}, None),
        # The usual name stays where it exists, whatever else is of its type.
        ({"/tb1/map_saver/save_map": SAVE, "/tb1/saver/save": SAVE}, None),
        ({"/tb1/map_saver/save_map": "", "/tb1/saver/save": SAVE}, None),
        ({"/tb1/map_saver/save_map": "std_srvs/srv/Empty", "/tb1/saver/save": SAVE}, "/{robot}/saver/save"),
        # Of nobody, of an unknown type, of another package, and a robot's name within a name.
        ({"/saver/save": SAVE, "/tb3/saver/save": SAVE}, None),
        ({"/tb1/saver/save": ""}, None),
        ({"/tb1/saver/save": "slam_toolbox/srv/SaveMap"}, None),
        ({"/tb1/tb1/save": SAVE}, "/{robot}/tb1/save"),
    ],
)
def test_services_by_type_among_odd_ones(services: dict[str, str], named: str | None) -> None:
    second = {topic.replace("tb1", "tb2"): type_ for topic, type_ in ONE.items()}
    listed = Listed({**ONE, **second}, services, (*DRIVES, "/tb2/navigate_to_pose"))
    assert discover_nav2(listed).services == ({"map_save": named} if named else {})


def test_a_service_of_another_namespace_is_not_that_of_a_robot_without_one() -> None:
    topics = {"/odom": ODOM, "/amcl_pose": AMCL}
    own = discover_nav2(Listed(topics, {"/saver/save": SAVE}, ("/navigate_to_pose",)))
    assert own.services["map_save"] == "/saver/save"
    beside = {"/map_saver/save_map": "", "/mapper/map_saver/save_map": SAVE}
    assert discover_nav2(Listed(topics, beside, ("/navigate_to_pose",))).services["map_save"] == (
        "/map_saver/save_map"
    )


def test_a_laser_of_another_name_is_found_by_its_type() -> None:
    scan = "sensor_msgs/msg/LaserScan"
    named = discover_nav2(Listed({**ONE, "/tb1/scan": scan}, {}, DRIVES))
    assert "scan" not in named.topics
    other = discover_nav2(Listed({**ONE, "/tb1/front_scan": scan}, {}, DRIVES))
    assert other.topics["scan"] == "/{robot}/front_scan"
    assert "scan" not in discover_nav2(Listed(ONE, {}, DRIVES)).topics
