"""Probes of a navigating robot's reports: its localisation, its battery."""

import math
from collections.abc import Iterator
from functools import partial

from fleet_tui.model.events import BatteryReported, Event
from fleet_tui.model.navigation_events import LocalisationReported, OriginReported
from fleet_tui.robots.probes import Diagnosis, MessageProbe
from fleet_tui.robots.ros.names import Names
from fleet_tui.situation.facts import ADRIFT

UNSURE = 0.5
"""Square metres, of x and y together."""


def message_probes(names: Names, robot: str) -> Iterator[MessageProbe]:
    """Return the checks of a robot's reports."""
    if names.topic("pose", robot):
        yield MessageProbe("localisation", "pose", judge_localisation)
    if names.topic("tf", robot):
        yield MessageProbe("localisation", "tf", judge_transforms)
    if names.topic("battery", robot):
        yield MessageProbe("charge", "battery", partial(judge_battery, f"[{names.table}.scales]"))


def judge_localisation(count: int, event: Event | None) -> Diagnosis:
    """Judge the certainty of a robot's localisation."""
    remedy = "set its pose (RViz: 2D Pose Estimate)"
    if not count or not isinstance(event, LocalisationReported):
        return Diagnosis(
            "fail", "no pose on the map received", f"check that localisation runs, then {remedy}"
        )
    if event.variance is None:
        return Diagnosis("ok", "pose received, uncertainty not reported")
    around = f"within {math.sqrt(event.variance):.2f} m (variance {event.variance:.2f} m2)"
    if event.variance > UNSURE:
        return Diagnosis(
            "warn", f"localisation uncertain: {around}", f"{remedy}, or drive to an area with features"
        )
    return Diagnosis("ok", around)


def judge_transforms(count: int, event: Event | None) -> Diagnosis | None:
    """Judge whether a localisation corrects a robot's odometry in its transforms."""
    if not count:
        return None
    if isinstance(event, OriginReported):
        return Diagnosis("ok", "by transforms")
    return Diagnosis("fail", f"{ADRIFT.word}: no transform from map to odom", ADRIFT.action)


def judge_battery(scales: str, count: int, event: Event | None) -> Diagnosis | None:
    """Judge the scale of the charge, and whether it is measured. `scales`: the config table of scales."""
    if not count:
        return None
    if not isinstance(event, BatteryReported):
        return Diagnosis("warn", "not measured: percentage is NaN", "set the battery capacity in its driver")
    if event.is_raw and event.percent > 1.0:
        remedy = f"{scales} battery = 1 fixes the scale: values up to 1 are first read as a fraction"
        return Diagnosis(
            "warn", f"range 0 to 100 instead of 0 to 1: {event.percent:.0f} read as per cent", remedy
        )
    percent = event.percent * 100.0 if event.is_raw else event.percent
    return Diagnosis("ok", f"{percent:.0f} %")
