"""Robots that navigate in words: the health of battery and localisation."""

import pytest

from fleet_tui.simulator.logs import BROKEN, DOUBTFUL, HEALTHY
from fleet_tui.simulator.navigating.fleet import health
from fleet_tui.simulator.navigating.robot import LOST, SURE
from tests.support.navigating import robot


@pytest.mark.parametrize(
    ("battery", "docked", "level", "words"),
    [
        (5.0, True, BROKEN, "empty"),
        (20.0, False, DOUBTFUL, "low"),
        (60.0, True, HEALTHY, "charging"),
        (60.0, False, HEALTHY, "charged"),
    ],
)
def test_a_battery(battery: float, docked: bool, level: int, words: str) -> None:
    it = robot(7)
    it.battery, it.docked = battery, docked
    charge, _ = health(it)
    assert (charge["level"], charge["message"], charge["name"]) == (level, words, "robot_7: battery")
    assert charge["values"] == [{"key": "percent", "value": f"{battery:.1f}"}]


@pytest.mark.parametrize(("variance", "level"), [(SURE, HEALTHY), (LOST, DOUBTFUL)])
def test_a_localisation(variance: float, level: int) -> None:
    it = robot()
    it.variance = variance
    assert list(health(it))[1]["level"] == level
