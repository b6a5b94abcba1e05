"""Set-up among the names that a bridge lists: by usual names and types; dangerous ones are only proposed."""

from fleet_tui.robots.discovery import Discovery, Listed
from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.robots.ros.set_up.discovery import find_set_up

POSE, GOAL = "geometry_msgs/PoseWithCovarianceStamped", "geometry_msgs/PoseStamped"
TOPICS = {"/r2/base_scan": "sensor_msgs/msg/LaserScan", "/r1/move_base/NavfnROS/plan": "nav_msgs/Path"}
HEARD = {"/r1/initialpose": POSE, "/r1/goal": GOAL, "/r1/move_base/cancel": "actionlib_msgs/GoalID"}
SERVICES = {
    "/r1/request_nomotion_update": "std_srvs/Empty",
    "/r1/global_localization": "std_srvs/Trigger",
    "/r1/slam_toolbox/save_map": "slam_toolbox_msgs/SaveMap",
}


def found(listed: Listed) -> Discovery:
    it = Discovery({"r1": [], "r2": []})
    find_set_up(it, listed, VOCABULARY)
    return it


def test_a_usual_name_of_any_robot_with_the_right_type_is_named() -> None:
    it = found(Listed(TOPICS, SERVICES, (), HEARD))
    assert it.topics == {
        "scan": "/{robot}/base_scan",
        "path": "/{robot}/move_base/NavfnROS/plan",
        "initial_pose": "/{robot}/initialpose",
    }
    assert it.services == {"settle": "/{robot}/request_nomotion_update"}


def test_what_drives_a_robot_or_writes_to_its_disk_is_left_to_a_person() -> None:
    it = found(Listed(TOPICS, SERVICES, (), HEARD))
    assert [note.partition("   #")[0] for notes in it.notes.values() for note in notes] == [
        'goal = "/{robot}/goal"',
        'goal_cancel = "/{robot}/move_base/cancel"',
        'map_save = "/{robot}/slam_toolbox/save_map"',
    ]


def test_what_maps_or_takes_a_graph_is_proposed_with_its_floor() -> None:
    heard = {
        "/r1/hall/graph_save": "OH_ressources/Graph",
        "/r1/hall/labels_save": "OH_ressources/msg/LabeledVertices",
    }
    services = {"/r1/set_mapping": "std_srvs/srv/SetBool", "/r1/enable_mapping": "std_srvs/SetBool"}
    it = Discovery({"r1": ["hall"]})
    find_set_up(it, Listed({"/r1/mode": "std_msgs/String"}, services, (), heard), VOCABULARY)
    assert [note.partition("   #")[0] for notes in it.notes.values() for note in notes] == [
        'mode = "/{robot}/mode"',
        'graph_save = "/{robot}/{floor}/graph_save"',
        'labels_save = "/{robot}/{floor}/labels_save"',
        'mapping_on = "/{robot}/set_mapping"',
        'mapping_off = "/{robot}/set_mapping"',
    ]


def test_nothing_of_another_robot_or_type_is_taken() -> None:
    it = found(Listed({"/r3/scan": "sensor_msgs/LaserScan", "/r1/scan": "std_msgs/String"}, {}))
    assert not it.topics and not it.services and not it.notes
