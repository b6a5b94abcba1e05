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
nav_msgs/MapMetaData: time map_load_time, float32 resolution, uint32 width, uint32 height, \
geometry_msgs/Pose origin
nav_msgs/OccupancyGrid: std_msgs/Header header, nav_msgs/MapMetaData info, int8[] data
rosgraph_msgs/Log: std_msgs/Header header, byte level, string name, string msg, string file, \
string function, uint32 line, string[] topics
rcl_interfaces/Log: time stamp, uint8 level, string name, string msg, string file, string function, \
uint32 line
diagnostic_msgs/KeyValue: string key, string value
diagnostic_msgs/DiagnosticStatus: byte level, string name, string message, string hardware_id, \
diagnostic_msgs/KeyValue[] values
diagnostic_msgs/DiagnosticArray: std_msgs/Header header, diagnostic_msgs/DiagnosticStatus[] status
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
std_srvs/Empty: ->
std_srvs/SetBool: bool data -> bool success, string message
std_srvs/Trigger: -> bool success, string message
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

_FIELD = re.compile(r"([\w/]+?)(?:\[(\d*)\])? (\w+)")


@dataclass(frozen=True)
class RosField:
    """A field: its type, and how many of it: None = one, 0 = any number, else as many as given."""

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


MESSAGES: Mapping[str, Fields] = {name: _fields(rest) for name, rest in _lines(_MESSAGES)}
"""The fields of each message type."""

PACKAGES = frozenset(name.partition("/")[0] for name in MESSAGES)

SERVICES: Mapping[str, tuple[Fields, Fields]] = {
    name: (_fields(rest.partition("->")[0]), _fields(rest.partition("->")[2]))
    for name, rest in _lines(_SERVICES)
}
"""The fields of each service type: request and response."""
