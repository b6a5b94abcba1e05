"""Probes of robots with Nav2: their servers, lifecycle, localisation, bridge."""

from collections.abc import Iterator, Mapping

from fleet_tui.model.navigation import DOWN, Servers
from fleet_tui.model.ros_logs import Health, PartDiagnosis
from fleet_tui.robots.probes import ActionProbe, BridgeProbe, Diagnosis, LifecycleProbe, Probe
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros_navigation.probes import message_probes

NEEDED = {"navigate_to_pose": "bt_navigator", "follow_waypoints": "waypoint_follower"}
"""Actions by which orders are driven, and the node of each."""

SERVERS = (
    "controller_server",
    "smoother_server",
    "planner_server",
    "behavior_server",
    "velocity_smoother",
    "collision_monitor",
    "bt_navigator",
    "waypoint_follower",
)
"""Nodes of Nav2's lifecycle in the order of their start."""
REQUIRED = frozenset({"controller_server", "planner_server", "behavior_server", "bt_navigator"})
"""Those without which Nav2 drives nowhere."""
GET_STATE = "lifecycle_msgs/GetState"
DIAGNOSED = "Nav2 Health"
ACTIVE = "active"

HUMBLE = (
    "humble: by default a goal blocks its connection until it ends, a call has no time limit, and a rejected"
    " goal is never answered before rosbridge 2.0.5"
)
NEW_THREADS = (
    "start rosbridge with send_action_goals_in_new_thread and call_services_in_new_thread true, and update it"
)


def probes(names: Names, robot: str) -> Iterator[Probe]:
    """Return the checks of one robot, and of its bridge."""
    yield BridgeProbe("distribution", judge_bridge)
    for key, node in NEEDED.items():
        if action := names.action(key, robot):
            remedy = f"start its {node}, or correct [{names.table}.actions] {key}"
            yield ActionProbe(f"action {key}", action, remedy)
    if service := names.service("is_active", robot):
        type_ = names.service_type("is_active")
        missing = f"correct [{names.table}.services] is_active"
        space = service.rpartition("/")[0].rpartition("/")[0]
        nodes = {node: f"{space}/{node}/get_state" for node in SERVERS}
        yield LifecycleProbe(
            "lifecycle", service, type_, nodes, GET_STATE, REQUIRED, judge_lifecycle, missing, DIAGNOSED
        )
    yield from message_probes(names, robot)


def judge_bridge(ros: int, distro: str) -> Diagnosis:
    """Judge the bridge by its distribution: its handling of goals."""
    if ros == 1:
        remedy = "Nav2 actions need a ROS 2 bridge: correct the url or the kind"
        return Diagnosis("fail", "ROS 1 bridge", remedy)
    if distro == "humble":
        return Diagnosis("warn", HUMBLE, NEW_THREADS)
    return Diagnosis("ok", distro or "not reported by the bridge")


def judge_lifecycle(answer: object, states: Mapping[str, str]) -> Servers:
    """Judge whether the nodes of Nav2 are active, by the word of their manager, which does not answer while
    it waits for one of them, and by their own."""
    if isinstance(answer, PartDiagnosis):
        # "Nav2 is active" up to Humble, later "Managed nodes are active": also "are inactive" is no error.
        says_active = answer.level == Health.OK and answer.message.split()[-1:] == ["active"]
    else:
        says_active = isinstance(answer, Mapping) and answer.get("success") is True
    if says_active:
        return Servers(True)
    idle = {node: state for node in SERVERS if (state := states.get(node, ACTIVE)) != ACTIVE}
    if states and not idle and not isinstance(answer, Mapping):
        return Servers(True)
    down = next((node for node, state in idle.items() if state == DOWN), "")
    are_alike = len(idle) == len(states) and len(set(idle.values())) == 1
    node = down or ("" if are_alike else next(iter(idle), ""))
    return Servers(False, node, idle.get(node, "") if node else "")
