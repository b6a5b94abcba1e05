"""What decides whether robots with Nav2 can be driven: their servers, lifecycle, localisation, bridge."""

import math
from collections.abc import Iterator
from functools import partial

from fleet_tui.adapters.probes import ActionProbe, BridgeProbe, Diagnosis, HeardProbe, Probe, QueryProbe
from fleet_tui.adapters.ros.names import Names
from fleet_tui.model.events import BatteryReported, Event
from fleet_tui.model.navigation_events import LocalisationReported

NEEDED = {"navigate_to_pose": "bt_navigator", "follow_waypoints": "waypoint_follower"}
"""Actions by which orders are driven, and the node that has each."""

HUMBLE = (
    "humble: by default a goal blocks its connection until it ends, a call has no time limit, and a rejected"
    " goal is never answered before rosbridge 2.0.5"
)
NEW_THREADS = (
    "start rosbridge with send_action_goals_in_new_thread and call_services_in_new_thread true, and update it"
)
UNSURE = 0.5
"""Square metres, of x and y together."""


def probes(names: Names, robot: str) -> Iterator[Probe]:
    """Return what to look at of one robot, and of its bridge."""
    yield BridgeProbe("distribution", judge_bridge)
    for key, node in NEEDED.items():
        if action := names.action(key, robot):
            remedy = f"start its {node}, or correct [{names.table}.actions] {key}"
            yield ActionProbe(f"action {key}", action, remedy)
    if service := names.service("is_active", robot):
        type_ = names.service_type("is_active")
        missing = f"is its lifecycle manager another one? Correct [{names.table}.services] is_active"
        yield QueryProbe("lifecycle", service, type_, {}, judge_lifecycle, missing)
    if names.topic("pose", robot):
        yield HeardProbe("localisation", "pose", judge_localisation)
    if names.topic("battery", robot):
        yield HeardProbe("charge", "battery", partial(judge_battery, f"[{names.table}.scales]"))


def judge_bridge(ros: int, distro: str) -> Diagnosis:
    """Judge the bridge by its distribution: what it does with goals."""
    if ros == 1:
        remedy = "the actions of Nav2 go through a bridge of ROS 2 only: correct the url, or the kind"
        return Diagnosis("fail", "it is a bridge of ROS 1", remedy)
    if distro == "humble":
        return Diagnosis("warn", HUMBLE, NEW_THREADS)
    return Diagnosis("ok", distro or "a bridge that does not name it")


def judge_lifecycle(answer: object) -> Diagnosis:
    """Judge whether the nodes of Nav2 are active."""
    success = answer.get("success") if isinstance(answer, dict) else None
    if success is True:
        return Diagnosis("ok", "Nav2 is active")
    if success is False:
        remedy = (
            "see the log of its lifecycle manager; RViz's Nav2 panel or nav2_bringup (autostart) starts it"
        )
        return Diagnosis("fail", "Nav2 is not active: it rejects every goal", remedy)
    said = f": {answer}" if isinstance(answer, str) else ""
    return Diagnosis(
        "fail", f"its lifecycle manager does not tell{said}", "does that node still run? Restart it"
    )


def judge_localisation(count: int, event: Event | None) -> Diagnosis:
    """Judge how sure a robot is of where it is."""
    remedy = "set its pose (RViz: 2D Pose Estimate)"
    if not count or not isinstance(event, LocalisationReported):
        return Diagnosis(
            "fail", "it has not told where on the map it is", f"is localisation running? If so {remedy}"
        )
    if event.variance is None:
        return Diagnosis("ok", "it tells where it is, not how sure it is of that")
    around = f"within {math.sqrt(event.variance):.2f} m (variance {event.variance:.2f} m2)"
    if event.variance > UNSURE:
        return Diagnosis(
            "warn", f"not sure where it is: {around}", f"{remedy}, or drive it where the map has features"
        )
    return Diagnosis("ok", around)


def judge_battery(scales: str, count: int, event: Event | None) -> Diagnosis | None:
    """Judge on which scale the charge is, and whether it is measured. `scales`: the table that says it."""
    if not count:
        return None
    if not isinstance(event, BatteryReported):
        return Diagnosis(
            "warn", "not measured: percentage is NaN", "does its driver know the battery's capacity?"
        )
    if event.is_raw and event.percent > 1.0:
        remedy = f"{scales} battery = 1 says so for good: a value up to 1 is taken for a share at first"
        return Diagnosis(
            "warn", f"counts to 100 instead of to 1: {event.percent:.0f} is taken for per cent", remedy
        )
    percent = event.percent * 100.0 if event.is_raw else event.percent
    return Diagnosis("ok", f"{percent:.0f} %")
