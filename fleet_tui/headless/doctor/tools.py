"""The commands that a remedy names: those of the ROS that is there, of both where that is not known. Pure."""

START_BRIDGE = {
    1: "roslaunch rosbridge_server rosbridge_websocket.launch",
    2: "ros2 launch rosbridge_server rosbridge_websocket_launch.xml",
}
START_ROSAPI = {1: "rosrun rosapi rosapi_node", 2: "ros2 run rosapi rosapi_node"}
LOOK_FOR_NODE = {1: "rosnode ping", 2: "ros2 node list"}
LATCHED = {1: "latched", 2: "with durability transient local"}


def named(tools: dict[int, str], ros: int, of: str = "") -> str:
    """The command for a ROS, of a node where `of` names one."""
    if ros in tools:
        return f"{tools[ros]} {of}".strip() if ros == 1 else tools[ros]
    return f"{named(tools, 1, of)}, ROS 2: {named(tools, 2, of)}"
