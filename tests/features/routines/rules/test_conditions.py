"""Conditions of a routine: true, false, or unknown without a fresh report."""

import pytest

from fleet_tui.features.routines.blocks import BatteryCondition, Condition, IdleCondition, PlaceCondition
from fleet_tui.features.routines.rules.conditions import condition_holds
from fleet_tui.model.events import Event
from tests.support.fleets import R0, T0, battery, pose, queue, reduced, tick
from tests.support.routines import two_robots

FULL, LOW = BatteryCondition(True, 80.0), BatteryCondition(False, 30.0)


@pytest.mark.parametrize(
    ("condition", "event", "holds"),
    [
        (FULL, battery(T0, 81.0), True),
        (FULL, battery(T0, 80.0), False),
        (LOW, battery(T0, 29.0), True),
        (LOW, battery(T0, 30.0), False),
        (FULL, tick(T0 + 3600.0), None),
        (IdleCondition(), queue(T0), True),
        (IdleCondition(), queue(T0, (1, 1, 2, "Q")), False),
        (IdleCondition(), tick(T0 + 3600.0), None),
        (PlaceCondition("Base"), pose(T0, 0.5), True),
        (PlaceCondition("base"), pose(T0, 1.5), False),
        (PlaceCondition("Consumidores"), pose(T0, 1.2), True),
        (PlaceCondition("nowhere"), pose(T0), None),
        (PlaceCondition("Base"), tick(T0 + 3600.0), None),
    ],
)
def test_conditions(condition: Condition, event: Event, holds: bool | None) -> None:
    state = reduced(two_robots(), event)
    assert condition_holds(state, state.robots[R0], condition) is holds


def test_nothing_is_known_of_a_robot_that_never_reported() -> None:
    state = two_robots()
    for condition in (FULL, IdleCondition(), PlaceCondition("Base")):
        assert condition_holds(state, state.robots["robot_1"], condition) is None
