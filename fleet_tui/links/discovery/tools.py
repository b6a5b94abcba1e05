"""The shell commands in remedies: those of the detected ROS, of both if unknown. Pure."""

from fleet_tui.links.discovery.facts import RosapiFacts

START_BRIDGE = {
    1: "roslaunch rosbridge_server rosbridge_websocket.launch",
    2: "ros2 launch rosbridge_server rosbridge_websocket_launch.xml",
}
START_ROSAPI = {1: "rosrun rosapi rosapi_node", 2: "ros2 run rosapi rosapi_node"}
LOOK_FOR_NODE = {1: "rosnode ping", 2: "ros2 node list"}
SAME_GRAPH = {
    1: "start the robots with ROS_MASTER_URI of this bridge's master, or correct their names",
    2: "start robots and rosbridge with the same ROS_DOMAIN_ID and RMW_IMPLEMENTATION, in a network that"
    " carries multicast, or correct the robots' names",
}
STAYS_LISTED = {
    1: "; a node that was killed stays listed until rosnode cleanup",
    2: "; a node that was killed stays listed for 20 s",
}
LATCHED = {1: "latched", 2: "with durability transient local"}


def named(tools: dict[int, str], ros: int, of: str = "") -> str:
    """Return the command for a ROS version, of a node if `of` names one."""
    if ros in tools:
        return f"{tools[ros]} {of}".strip() if ros == 1 else tools[ros]
    return f"{named(tools, 1, of)}, ROS 2: {named(tools, 2, of)}"


def rosapi_remedy(rosapi: RosapiFacts) -> str:
    """Return the remedy for a missing or silent rosapi."""
    start = named(START_ROSAPI, rosapi.ros)
    if rosapi.is_absent:
        renew = "if it runs, the ROS master was restarted: restart rosapi and the robot nodes"
        return f"start rosapi beside rosbridge ({start})" + f"; {renew}" * (rosapi.ros != 2)
    if rosapi.is_silent:
        return f"restart rosapi ({start})"
    return "error of rosapi: see its log"
