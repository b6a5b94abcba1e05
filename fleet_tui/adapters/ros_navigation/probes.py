"""Probes of what a navigating robot tells of itself: its localisation, its battery."""

import math
from collections.abc import Iterator
from functools import partial

from fleet_tui.adapters.probes import Diagnosis, HeardProbe
from fleet_tui.adapters.ros.names import Names
from fleet_tui.model.events import BatteryReported, Event
from fleet_tui.model.navigation_events import LocalisationReported

UNSURE = 0.5
"""Square metres, of x and y together."""


def heard_probes(names: Names, robot: str) -> Iterator[HeardProbe]:
    """Return what to make of what a robot tells."""
    if names.topic("pose", robot):
        yield HeardProbe("localisation", "pose", judge_localisation)
    if names.topic("battery", robot):
        yield HeardProbe("charge", "battery", partial(judge_battery, f"[{names.table}.scales]"))


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
