"""Names of the source's robots: OH_ressources messages behind `Application_layout` services."""

from fleet_tui.robots.ros.fields import GRID, METADATA, POSE, alike
from fleet_tui.robots.ros.names import Vocabulary
from fleet_tui.robots.ros.set_up import names as set_up

VOCABULARY = Vocabulary(
    topics={
        "pose": ("/{robot}/pose", "geometry_msgs/PoseStamped"),
        "queue": ("/{robot}/queue", "OH_ressources/ActionQueue"),
        "obstacle": ("/{robot}/obstacle", "std_msgs/Float32"),
        "battery": ("/{robot}/battery", "std_msgs/Float32"),
        "cargo": ("/{robot}/cargo", "std_msgs/Bool"),
        "paused": ("", "std_msgs/Bool"),
        "map_metadata": ("/{robot}/{floor}/map_metadata", "nav_msgs/MapMetaData"),
        "graph": ("/{robot}/{floor}/graph", "OH_ressources/Graph"),
        "labels": ("/{robot}/{floor}/labeled_vertices", "OH_ressources/LabeledVertices"),
        "map": ("/{robot}/{floor}/map", "nav_msgs/OccupancyGrid"),
        "goal": ("", "geometry_msgs/PoseStamped"),
        "goal_cancel": ("", "actionlib_msgs/GoalID"),
        "graph_save": ("", "OH_ressources/Graph"),
        "labels_save": ("", "OH_ressources/LabeledVertices"),
        **set_up.TOPICS,
    },
    floor_topics=frozenset({"map_metadata", "graph", "labels", "map", "graph_save", "labels_save"}),
    services={
        "order": ("/{robot}/Application_layout/Execute_order", "OH_ressources/Execute_manual_order"),
        "order_with_cargo": (
            "/{robot}/Application_layout/Execute_order_with_cargo",
            "OH_ressources/Execute_manual_order_with_cargo",
        ),
        "cancel": ("/{robot}/Application_layout/Cancel_order", "OH_ressources/Cancel_order"),
        "clear": ("/{robot}/Application_layout/Clear_orders", "OH_ressources/Clear_orders"),
        "pause": ("/{robot}/Application_layout/Pause", "std_srvs/Trigger"),
        "resume": ("/{robot}/Application_layout/Resume", "std_srvs/Trigger"),
        **set_up.SERVICES,
    },
    fields={
        "pose": POSE,
        "obstacle": alike("data"),
        "battery": alike("data"),
        "cargo": alike("data"),
        "paused": alike("data"),
        "map_metadata": METADATA,
        "map": GRID,
        "mode": alike("data"),
        "graph": alike("vertices", "edges"),
        "vertex": alike("id", "x", "y", "type"),
        "edge": alike("id", "start", "end"),
        "labels": alike("vertices"),
        "label": alike("label", "vertex_id"),
        "queue": alike("request_id", "last_order_id", "current_order_id", "orders"),
        "order": alike("id", "start", "end", "status"),
        "order_call": alike("request_id", "initial_point", "end_point"),
        "cargo_call": alike("request_id", "agent", "end_point"),
        "cancel_call": alike("robot", "ind"),
    },
    requests=set_up.REQUESTS,
    answers=set_up.ANSWERS,
    scales=frozenset({"pose", "obstacle", "battery", "vertex"}),
    # A robot refuses in the text of an answer to a successful call.
    refusals=(
        r"(?i)\b(reject|refus|fail|invalid|denied|unknown|unable|cannot|can't|impossible)",
        r"(?i)\bno such\b",
        r"(?i)(?<!without )(?<!without an )(?<!no )\berror",
    ),
    vertex_types={
        "elevator": "elevator",
        "charger": "docking",
        "docking": "docking",
        "docking_station": "docking",
    },
)
