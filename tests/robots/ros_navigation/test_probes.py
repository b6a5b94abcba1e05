"""Probes of what a navigating robot tells of itself."""

import pytest

from fleet_tui.model.events import BatteryReported, Event
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import LocalisationReported, Unmeasured
from fleet_tui.robots.ros_navigation.probes import judge_battery, judge_localisation


def located(variance: float | None) -> LocalisationReported:
    return LocalisationReported("r1", 1.0, Pose(0.0, 0.0), "map", None, variance)


@pytest.mark.parametrize(
    ("count", "event", "level", "detail"),
    [
        (0, None, "fail", "no pose on the map received"),
        (1, None, "fail", "no pose on the map received"),
        (1, located(None), "ok", "uncertainty not reported"),
        (1, located(0.25), "ok", "within 0.50 m"),
        (1, located(4.0), "warn", "localisation uncertain: within 2.00 m"),
    ],
)
def test_how_sure_a_robot_is_of_where_it_is(count: int, event: Event | None, level: str, detail: str) -> None:
    found = judge_localisation(count, event)
    assert found.level == level and detail in found.measured
    assert bool(found.remedy) == (level != "ok")


@pytest.mark.parametrize(
    ("event", "level", "detail"),
    [
        (BatteryReported("r1", 1.0, 0.5, is_raw=True), "ok", "50 %"),
        (BatteryReported("r1", 1.0, 50.0, is_raw=False), "ok", "50 %"),
        (BatteryReported("r1", 1.0, 50.0, is_raw=True), "warn", "range 0 to 100 instead of 0 to 1"),
        (Unmeasured("r1", 1.0, "battery"), "warn", "percentage is NaN"),
    ],
)
def test_on_which_scale_a_battery_counts(event: Event, level: str, detail: str) -> None:
    found = judge_battery("[profile.scales]", 3, event)
    assert found is not None and found.level == level and detail in found.measured


def test_of_a_battery_that_says_nothing_its_topic_tells() -> None:
    assert judge_battery("[profile.scales]", 0, None) is None
