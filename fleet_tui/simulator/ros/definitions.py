"""Definitions of messages and services, in ROS 1's names: what a bridge with these packages can handle."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

_MESSAGES = """
std_msgs/Empty:
std_msgs/Bool: bool data
std_msgs/Int32: int32 data
std_msgs/Int64: int64 data
std_msgs/Float32: float32 data
std_msgs/Float64: float64 data
std_msgs/String: string data
std_msgs/Header: uint32 seq, time stamp, string frame_id
geometry_msgs/Point: float64 x, float64 y, float64 z
geometry_msgs/Quaternion: float64 x, float64 y, float64 z, float64 w
geometry_msgs/Pose: geometry_msgs/Point position, geometry_msgs/Quaternion orientation
geometry_msgs/PoseStamped: std_msgs/Header header, geometry_msgs/Pose pose
geometry_msgs/PoseWithCovariance: geometry_msgs/Pose pose, float64[36] covariance
geometry_msgs/PoseWithCovarianceStamped: std_msgs/Header header, geometry_msgs/PoseWithCovariance pose
geometry_msgs/Vector3: float64 x, float64 y, float64 z
geometry_msgs/Twist: geometry_msgs/Vector3 linear, geometry_msgs/Vector3 angular
geometry_msgs/TwistStamped: std_msgs/Header header, geometry_msgs/Twist twist
nav_msgs/MapMetaData: time map_load_time, float32 resolution, uint32 width, uint32 height, \
geometry_msgs/Pose origin
nav_msgs/OccupancyGrid: std_msgs/Header header, nav_msgs/MapMetaData info, int8[] data
geometry_msgs/TwistWithCovariance: geometry_msgs/Twist twist, float64[36] covariance
nav_msgs/Odometry: std_msgs/Header header, string child_frame_id, geometry_msgs/PoseWithCovariance pose, \
geometry_msgs/TwistWithCovariance twist
sensor_msgs/LaserScan: std_msgs/Header header, float32 angle_min, float32 angle_max, \
float32 angle_increment, float32 time_increment, float32 scan_time, float32 range_min, float32 range_max, \
float32[] ranges, float32[] intensities
sensor_msgs/CompressedImage: std_msgs/Header header, string format, uint8[] data
geometry_msgs/Transform: geometry_msgs/Vector3 translation, geometry_msgs/Quaternion rotation
geometry_msgs/TransformStamped: std_msgs/Header header, string child_frame_id, \
geometry_msgs/Transform transform
tf2_msgs/TFMessage: geometry_msgs/TransformStamped[] transforms
nav_msgs/Path: std_msgs/Header header, geometry_msgs/PoseStamped[] poses
sensor_msgs/BatteryState: std_msgs/Header header, float32 voltage, float32 temperature, float32 current, \
float32 charge, float32 capacity, float32 design_capacity, float32 percentage, uint8 power_supply_status, \
uint8 power_supply_health, uint8 power_supply_technology, bool present, float32[] cell_voltage, \
float32[] cell_temperature, string location, string serial_number
builtin_interfaces/Duration: int32 sec, uint32 nanosec
unique_identifier_msgs/UUID: uint8[16] uuid
action_msgs/GoalInfo: unique_identifier_msgs/UUID goal_id, time stamp
action_msgs/GoalStatus: action_msgs/GoalInfo goal_info, int8 status
action_msgs/GoalStatusArray: action_msgs/GoalStatus[] status_list
actionlib_msgs/GoalID: time stamp, string id
actionlib_msgs/GoalStatus: actionlib_msgs/GoalID goal_id, uint8 status, string text
actionlib_msgs/GoalStatusArray: std_msgs/Header header, actionlib_msgs/GoalStatus[] status_list
move_base_msgs/MoveBaseGoal: geometry_msgs/PoseStamped target_pose
move_base_msgs/MoveBaseActionGoal: std_msgs/Header header, actionlib_msgs/GoalID goal_id, \
move_base_msgs/MoveBaseGoal goal
move_base_msgs/MoveBaseResult:
move_base_msgs/MoveBaseActionResult: std_msgs/Header header, actionlib_msgs/GoalStatus status, \
move_base_msgs/MoveBaseResult result
move_base_msgs/MoveBaseFeedback: geometry_msgs/PoseStamped base_position
move_base_msgs/MoveBaseActionFeedback: std_msgs/Header header, actionlib_msgs/GoalStatus status, \
move_base_msgs/MoveBaseFeedback feedback
nav2_msgs/CollisionMonitorState: uint8 action_type, string polygon_name
nav2_msgs/MissedWaypoint: uint32 index, geometry_msgs/PoseStamped goal, uint16 error_code
rosgraph_msgs/Log: std_msgs/Header header, byte level, string name, string msg, string file, \
string function, uint32 line, string[] topics
rcl_interfaces/Log: time stamp, uint8 level, string name, string msg, string file, string function, \
uint32 line
diagnostic_msgs/KeyValue: string key, string value
diagnostic_msgs/DiagnosticStatus: byte level, string name, string message, string hardware_id, \
diagnostic_msgs/KeyValue[] values
diagnostic_msgs/DiagnosticArray: std_msgs/Header header, diagnostic_msgs/DiagnosticStatus[] status
lifecycle_msgs/State: uint8 id, string label
rosbridge_msgs/ConnectedClient: string ip_address, time connection_time
rosbridge_msgs/ConnectedClients: rosbridge_msgs/ConnectedClient[] clients
OH_ressources/Vertex: int32 id, float64 x, float64 y, string type
OH_ressources/Edge: int32 id, int32 start, int32 end
OH_ressources/Graph: OH_ressources/Vertex[] vertices, OH_ressources/Edge[] edges
OH_ressources/LabeledVertex: string label, int32 vertex_id
OH_ressources/LabeledVertices: OH_ressources/LabeledVertex[] vertices
OH_ressources/Order: int32 id, int32 start, int32 end, string status
OH_ressources/ActionQueue: int32 request_id, int32 last_order_id, int32 robot_id, int32 current_order_id, \
OH_ressources/Order[] orders
rmf_fleet_msgs/Location: time t, float32 x, float32 y, float32 yaw, string level_name, uint64 index
rmf_fleet_msgs/RobotMode: uint32 mode, uint64 mode_request_id, string performing_action
rmf_fleet_msgs/RobotState: string name, string model, string task_id, uint64 seq, \
rmf_fleet_msgs/RobotMode mode, float32 battery_percent, rmf_fleet_msgs/Location location, \
rmf_fleet_msgs/Location[] path
rmf_fleet_msgs/FleetState: string name, rmf_fleet_msgs/RobotState[] robots
rmf_fleet_msgs/LaneStates: string fleet_name, uint64[] closed_lanes
rmf_task_msgs/ApiRequest: string json_msg, string request_id
rmf_task_msgs/ApiResponse: uint8 type, string json_msg, string request_id
rmf_task_msgs/Assignment: bool is_assigned, string fleet_name, string expected_robot_name
rmf_task_msgs/DispatchState: string task_id, uint8 status, rmf_task_msgs/Assignment assignment, \
string[] errors
rmf_task_msgs/DispatchStates: rmf_task_msgs/DispatchState[] active, rmf_task_msgs/DispatchState[] finished
rmf_building_map_msgs/Param: string name, uint32 type, int32 value_int, float32 value_float, \
string value_string, bool value_bool
rmf_building_map_msgs/GraphNode: float32 x, float32 y, string name, rmf_building_map_msgs/Param[] params
rmf_building_map_msgs/GraphEdge: uint32 v1_idx, uint32 v2_idx, rmf_building_map_msgs/Param[] params, \
uint8 edge_type
rmf_building_map_msgs/Graph: string name, rmf_building_map_msgs/GraphNode[] vertices, \
rmf_building_map_msgs/GraphEdge[] edges, rmf_building_map_msgs/Param[] params
rmf_building_map_msgs/AffineImage: string name, float32 x_offset, float32 y_offset, float32 yaw, \
float32 scale, string encoding, uint8[] data
rmf_building_map_msgs/Level: string name, float32 elevation, rmf_building_map_msgs/AffineImage[] images
rmf_building_map_msgs/BuildingMap: string name, rmf_building_map_msgs/Level[] levels
rmf_lift_msgs/LiftState: time lift_time, string lift_name, string[] available_floors, string current_floor, \
string destination_floor, uint8 door_state, uint8 motion_state, uint8[] available_modes, \
uint8 current_mode, string session_id
rmf_dispenser_msgs/DispenserState: time time, string guid, int32 mode, string[] request_guid_queue, \
float32 seconds_remaining
rmf_ingestor_msgs/IngestorState: time time, string guid, int32 mode, string[] request_guid_queue, \
float32 seconds_remaining
rmf_door_msgs/DoorMode: uint32 value
rmf_door_msgs/DoorState: time door_time, string door_name, rmf_door_msgs/DoorMode current_mode
rosapi/TypeDef: string type, string[] fieldnames, string[] fieldtypes, int32[] fieldarraylen, \
string[] examples, string[] constnames, string[] constvalues
"""

_SERVICES = """
OH_ressources/Execute_manual_order: int32 request_id, int32 initial_point, int32 end_point \
-> int32 request_id, string status
OH_ressources/Execute_manual_order_with_cargo: int32 request_id, string agent, int32 end_point \
-> int32 request_id, string status
OH_ressources/Cancel_order: string robot, int32 ind -> bool success, string status
OH_ressources/Clear_orders: string robot, int32 ind -> bool success, string status
action_msgs/CancelGoal: action_msgs/GoalInfo goal_info -> int8 return_code, \
action_msgs/GoalInfo[] goals_canceling
lifecycle_msgs/GetState: -> lifecycle_msgs/State current_state
std_srvs/Empty: ->
std_srvs/SetBool: bool data -> bool success, string message
std_srvs/Trigger: -> bool success, string message
slam_toolbox_msgs/SaveMap: std_msgs/String name ->
slam_toolbox_msgs/SerializePoseGraph: string filename ->
slam_toolbox/SerializePoseGraph: string filename -> uint8 result
nav2_msgs/SaveMap: string map_topic, string map_url, string image_format, string map_mode, \
float32 free_thresh, float32 occupied_thresh -> bool result
nav2_msgs/SetRouteGraph: string graph_filepath -> bool success
rosapi/Topics: -> string[] topics, string[] types
rosapi/TopicsAndRawTypes: -> string[] topics, string[] types, string[] typedefs_full_text
rosapi/TopicsForType: string type -> string[] topics
rosapi/TopicType: string topic -> string type
rosapi/Services: -> string[] services
rosapi/ServicesForType: string type -> string[] services
rosapi/ServiceType: string service -> string type
rosapi/ServiceProviders: string service -> string[] providers
rosapi/ServiceNode: string service -> string node
rosapi/ServiceHost: string service -> string host
rosapi/Nodes: -> string[] nodes
rosapi/NodeDetails: string node -> string[] subscribing, string[] publishing, string[] services
rosapi/GetActionServers: -> string[] action_servers
rosapi/ActionType: string action -> string type
rosapi/ActionGoalDetails: string type -> rosapi/TypeDef[] typedefs
rosapi/ActionResultDetails: string type -> rosapi/TypeDef[] typedefs
rosapi/ActionFeedbackDetails: string type -> rosapi/TypeDef[] typedefs
rosapi/Publishers: string topic -> string[] publishers
rosapi/Subscribers: string topic -> string[] subscribers
rosapi/MessageDetails: string type -> rosapi/TypeDef[] typedefs
rosapi/ServiceRequestDetails: string type -> rosapi/TypeDef[] typedefs
rosapi/ServiceResponseDetails: string type -> rosapi/TypeDef[] typedefs
rosapi/SetParam: string name, string value ->
rosapi/GetParam: string name, string default -> string value
rosapi_msgs/GetParam: string name, string default_value -> string value, bool successful, string reason
rosapi/HasParam: string name -> bool exists
rosapi/SearchParam: string name -> string global_name
rosapi/DeleteParam: string name ->
rosapi/GetParamNames: -> string[] names
rosapi/GetTime: -> time time
rosapi/GetROSVersion: -> uint8 version, string distro
rosapi/Interfaces: -> string[] interfaces
"""

_PROGRESS = """geometry_msgs/PoseStamped current_pose, builtin_interfaces/Duration navigation_time, \
builtin_interfaces/Duration estimated_time_remaining, int16 number_of_recoveries, \
float32 distance_remaining"""

_ACTIONS = f"""
nav2_msgs/NavigateToPose: geometry_msgs/PoseStamped pose, string behavior_tree \
-> uint16 error_code, string error_msg -> {_PROGRESS}
nav2_msgs/NavigateThroughPoses: geometry_msgs/PoseStamped[] poses, string behavior_tree \
-> uint16 error_code, string error_msg -> {_PROGRESS}, int16 number_of_poses_remaining
nav2_msgs/FollowWaypoints: uint32 number_of_loops, uint32 goal_index, geometry_msgs/PoseStamped[] poses \
-> nav2_msgs/MissedWaypoint[] missed_waypoints, uint16 error_code, string error_msg \
-> uint32 current_waypoint
nav2_msgs/DockRobot: bool use_dock_id, string dock_id, geometry_msgs/PoseStamped dock_pose, \
string dock_type, float32 max_staging_time, bool navigate_to_staging_pose \
-> bool success, uint16 error_code, uint16 num_retries \
-> uint16 state, builtin_interfaces/Duration docking_time, uint16 num_retries
nav2_msgs/Spin: float32 target_yaw, builtin_interfaces/Duration time_allowance \
-> builtin_interfaces/Duration total_elapsed_time, uint16 error_code -> float32 angular_distance_traveled
"""

_FIELD = re.compile(r"([\w/]+?)(?:\[(\d*)\])? (\w+)")


@dataclass(frozen=True)
class RosField:
    """A field: its type, and its length: None for a single value, 0 for any length, otherwise a fixed
    length."""

    type: str
    length: int | None = None


Fields = Mapping[str, RosField]


def _fields(text: str) -> Fields:
    found = (_FIELD.fullmatch(part.strip()) for part in text.split(",") if part.strip())
    return {
        match[3]: RosField(match[1], None if match[2] is None else int(match[2] or 0))
        for match in found
        if match is not None
    }


def _lines(text: str) -> Iterator[tuple[str, str]]:
    for line in text.strip().splitlines():
        name, _, rest = line.partition(":")
        yield name, rest


ACTIONS: Mapping[str, tuple[Fields, Fields, Fields]] = {
    name: (_fields(goal), _fields(result), _fields(feedback))
    for name, rest in _lines(_ACTIONS)
    for goal, result, feedback in (rest.split("->"),)
}
"""The fields of each action type: goal, result and feedback."""

_GOAL_ID = {"goal_id": RosField("unique_identifier_msgs/UUID")}

MESSAGES: Mapping[str, Fields] = (
    {name: _fields(rest) for name, rest in _lines(_MESSAGES)}
    | {f"{name}_Feedback": feedback for name, (_, _, feedback) in ACTIONS.items()}
    | {f"{name}_FeedbackMessage": {**_GOAL_ID, "feedback": RosField(f"{name}_Feedback")} for name in ACTIONS}
)
"""The fields of each message type."""

PACKAGES = frozenset(name.partition("/")[0] for name in MESSAGES) - {"sensor_msgs"}
"""Packages whose messages are all defined here, as far as they are used."""

SERVICES: Mapping[str, tuple[Fields, Fields]] = {
    name: (_fields(rest.partition("->")[0]), _fields(rest.partition("->")[2]))
    for name, rest in _lines(_SERVICES)
}
"""The fields of each service type: request and response."""
