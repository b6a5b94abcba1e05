"""Names of Nav2's topics and actions, `{robot}` being the namespace."""

from fleet_tui.adapters.ros.fields import GRID, HEADER, alike, placed
from fleet_tui.adapters.ros.names import Vocabulary
from fleet_tui.adapters.ros.set_up import names as set_up

ACTIONS = ("follow_waypoints", "navigate_through_poses", "navigate_to_pose", "dock_robot", "undock_robot")
"""In the order of cancelling: the first drives by goals of others."""

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
        "odometry": ("/{robot}/odom", "nav_msgs/Odometry"),
        "pose": ("/{robot}/amcl_pose", "geometry_msgs/PoseWithCovarianceStamped"),
        "battery": ("/{robot}/battery_state", "sensor_msgs/BatteryState"),
        "blocked": ("/{robot}/collision_monitor_state", "nav2_msgs/CollisionMonitorState"),
        "floor": ("", "std_msgs/String"),
        "pause_navigation": ("", "std_msgs/Bool"),
        "plan": ("/{robot}/plan", "nav_msgs/Path"),
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
    },
    floor_topics=frozenset({"map"}),
    services={
        "pause": ("", "std_srvs/Trigger"),
        "resume": ("", "std_srvs/Trigger"),
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
    answers={
        "map_save": {"result": True},
        "map_pose_graph": {"result": 0},
        "graph_load": {"success": True},
    },
    actions={
        "follow_waypoints": ("/{robot}/follow_waypoints", "nav2_msgs/action/FollowWaypoints"),
        "navigate_through_poses": (
            "/{robot}/navigate_through_poses",
            "nav2_msgs/action/NavigateThroughPoses",
        ),
        "navigate_to_pose": ("/{robot}/navigate_to_pose", "nav2_msgs/action/NavigateToPose"),
        "dock_robot": ("/{robot}/dock_robot", "nav2_msgs/action/DockRobot"),
        "undock_robot": ("/{robot}/undock_robot", "nav2_msgs/action/UndockRobot"),
    },
    fields={
        "odometry": {**HEADER, **placed("pose.pose.")},
        "pose": {**HEADER, **placed("pose.pose."), "covariance": "pose.covariance"},
        "battery": alike("percentage"),
        "blocked": alike("action_type", "polygon_name"),
        "floor": alike("data"),
        "plan": alike("poses"),
        "map": GRID,
        "mode": alike("data"),
    },
    scales=frozenset({"odometry", "pose", "battery"}),
)
