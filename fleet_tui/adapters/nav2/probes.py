"""Probes of robots with Nav2: their servers, lifecycle, localisation, bridge."""

from collections.abc import Iterator

from fleet_tui.adapters.probes import ActionProbe, BridgeProbe, Diagnosis, Probe, QueryProbe
from fleet_tui.adapters.ros.names import Names
from fleet_tui.adapters.ros_navigation.probes import message_probes

NEEDED = {"navigate_to_pose": "bt_navigator", "follow_waypoints": "waypoint_follower"}
"""Actions by which orders are driven, and the node of each."""

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
        yield QueryProbe("lifecycle", service, type_, {}, judge_lifecycle, missing)
    yield from message_probes(names, robot)


def judge_bridge(ros: int, distro: str) -> Diagnosis:
    """Judge the bridge by its distribution: its handling of goals."""
    if ros == 1:
        remedy = "Nav2 actions need a ROS 2 bridge: correct the url or the kind"
        return Diagnosis("fail", "ROS 1 bridge", remedy)
    if distro == "humble":
        return Diagnosis("warn", HUMBLE, NEW_THREADS)
    return Diagnosis("ok", distro or "not reported by the bridge")


def judge_lifecycle(answer: object) -> Diagnosis:
    """Judge whether the nodes of Nav2 are active."""
    success = answer.get("success") if isinstance(answer, dict) else None
    if success is True:
        return Diagnosis("ok", "Nav2 is active")
    if success is False:
        remedy = "see the lifecycle manager's log; start with RViz's Nav2 panel or nav2_bringup (autostart)"
        return Diagnosis("fail", "Nav2 not active: rejects every goal", remedy)
    said = f": {answer}" if isinstance(answer, str) else ""
    return Diagnosis("fail", f"no status from the lifecycle manager{said}", "check that node, or restart it")
