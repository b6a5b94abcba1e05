"""Names of move_base's topics, `{robot}` being the namespace."""

from fleet_tui.robots.ros.fields import alike, placed
from fleet_tui.robots.ros.names import Vocabulary
from fleet_tui.robots.ros.set_up import names as set_up
from fleet_tui.robots.ros_navigation import vocabulary as shared

VOCABULARY = Vocabulary(
    topics={
        "status": ("/{robot}/move_base/status", "actionlib_msgs/GoalStatusArray"),
        "goal": ("/{robot}/move_base/goal", "move_base_msgs/MoveBaseActionGoal"),
        "cancel": ("/{robot}/move_base/cancel", "actionlib_msgs/GoalID"),
        "feedback": ("/{robot}/move_base/feedback", "move_base_msgs/MoveBaseActionFeedback"),
        "target": ("/{robot}/move_base/current_goal", "geometry_msgs/PoseStamped"),
        "plan": ("/{robot}/move_base/NavfnROS/plan", "nav_msgs/Path"),
        **shared.TOPICS,
    },
    floor_topics=shared.FLOOR_TOPICS,
    services={
        **shared.PAUSES,
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
        **shared.FIELDS,
    },
    scales=shared.SCALES,
)
