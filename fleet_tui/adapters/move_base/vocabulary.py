"""Names of move_base's topics, `{robot}` being the namespace."""

from fleet_tui.adapters.ros.fields import GRID, HEADER, alike, placed
from fleet_tui.adapters.ros.names import Vocabulary
from fleet_tui.adapters.ros.set_up import names as set_up

VOCABULARY = Vocabulary(
    topics={
        "status": ("/{robot}/move_base/status", "actionlib_msgs/GoalStatusArray"),
        "goal": ("/{robot}/move_base/goal", "move_base_msgs/MoveBaseActionGoal"),
        "cancel": ("/{robot}/move_base/cancel", "actionlib_msgs/GoalID"),
        "feedback": ("/{robot}/move_base/feedback", "move_base_msgs/MoveBaseActionFeedback"),
        "target": ("/{robot}/move_base/current_goal", "geometry_msgs/PoseStamped"),
        "plan": ("/{robot}/move_base/NavfnROS/plan", "nav_msgs/Path"),
        "odometry": ("/{robot}/odom", "nav_msgs/Odometry"),
        "pose": ("/{robot}/amcl_pose", "geometry_msgs/PoseWithCovarianceStamped"),
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
    },
    floor_topics=frozenset({"map"}),
    services={
        "pause": ("", "std_srvs/Trigger"),
        "resume": ("", "std_srvs/Trigger"),
        **set_up.with_names(
            set_up.SERVICES,
            {
                "localise": "/{robot}/global_localization",
                "settle": "/{robot}/request_nomotion_update",
                **dict.fromkeys(("mapping_on", "mapping_off"), "/{robot}/pause_mapping"),
                "map_save": "/{robot}/slam_toolbox/save_map",
                "map_pose_graph": "/{robot}/slam_toolbox/serialize_map",
            },
        ),
    },
    requests=set_up.INVERSE,
    answers=set_up.ANSWERS,
    fields={
        "status": alike("status_list"),
        "feedback": placed("feedback.base_position.pose."),
        "target": placed("pose."),
        "plan": alike("poses"),
        "odometry": {**HEADER, **placed("pose.pose.")},
        "pose": {**HEADER, **placed("pose.pose."), "covariance": "pose.covariance"},
        "battery": alike("percentage"),
        "floor": alike("data"),
        "map": GRID,
        "mode": alike("data"),
    },
    scales=frozenset({"odometry", "pose", "battery"}),
)
