"""Names of Nav2's topics and actions, `{robot}` being the namespace."""

from fleet_tui.robots.ros.fields import alike
from fleet_tui.robots.ros.names import Vocabulary
from fleet_tui.robots.ros.set_up import names as set_up
from fleet_tui.robots.ros_navigation import vocabulary as shared

ACTIONS = ("follow_waypoints", "navigate_through_poses", "navigate_to_pose", "dock_robot", "undock_robot")
"""In the order of cancelling: the first drives by goals of others."""
MOTIONS = (
    "follow_path",
    "spin",
    "backup",
    "drive_on_heading",
    "assisted_teleop",
    "dock_robot",
    "undock_robot",
)
"""Those that move the robot, too: Nav2 gives itself goals there, and any client may."""

MAP_SAVE = {
    "map_topic": "map",
    "map_url": "{name}",
    "image_format": "pgm",
    "map_mode": "trinary",
    "free_thresh": 0.25,
    "occupied_thresh": 0.65,
}
"""The request of Nav2's map saver. Its topic is relative to the saver's own namespace."""

VOCABULARY = Vocabulary(
    topics={
        **shared.TOPICS,
        "blocked": ("/{robot}/collision_monitor_state", "nav2_msgs/CollisionMonitorState"),
        "plan": ("/{robot}/plan", "nav_msgs/Path"),
    },
    floor_topics=shared.FLOOR_TOPICS,
    services={
        **shared.PAUSES,
        "is_active": ("/{robot}/lifecycle_manager_navigation/is_active", "std_srvs/Trigger"),
        **set_up.with_names(
            set_up.SERVICES,
            {
                "localise": "/{robot}/reinitialize_global_localization",
                "settle": "/{robot}/request_nomotion_update",
                **dict.fromkeys(("mapping_on", "mapping_off"), "/{robot}/slam_toolbox/set_localization_mode"),
            },
        ),
        "map_save": ("/{robot}/map_saver/save_map", "nav2_msgs/SaveMap"),
        "map_pose_graph": ("/{robot}/slam_toolbox/serialize_map", "slam_toolbox/SerializePoseGraph"),
        "graph_load": ("/{robot}/route_server/set_route_graph", "nav2_msgs/SetRouteGraph"),
    },
    requests={**set_up.INVERSE, "map_save": MAP_SAVE, "graph_load": {"graph_filepath": "{path}"}},
    answers={"map_save": {"result": True}, "map_pose_graph": {"result": 0}, "graph_load": {"success": True}},
    actions={
        "follow_waypoints": ("/{robot}/follow_waypoints", "nav2_msgs/action/FollowWaypoints"),
        "navigate_through_poses": (
            "/{robot}/navigate_through_poses",
            "nav2_msgs/action/NavigateThroughPoses",
        ),
        "navigate_to_pose": ("/{robot}/navigate_to_pose", "nav2_msgs/action/NavigateToPose"),
        "dock_robot": ("/{robot}/dock_robot", "nav2_msgs/action/DockRobot"),
        "undock_robot": ("/{robot}/undock_robot", "nav2_msgs/action/UndockRobot"),
        "follow_path": ("/{robot}/follow_path", "nav2_msgs/action/FollowPath"),
        "spin": ("/{robot}/spin", "nav2_msgs/action/Spin"),
        "backup": ("/{robot}/backup", "nav2_msgs/action/BackUp"),
        "drive_on_heading": ("/{robot}/drive_on_heading", "nav2_msgs/action/DriveOnHeading"),
        "assisted_teleop": ("/{robot}/assisted_teleop", "nav2_msgs/action/AssistedTeleop"),
    },
    fields={**shared.FIELDS, "blocked": alike("action_type", "polygon_name")},
    scales=shared.SCALES,
)
