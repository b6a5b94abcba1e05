"""Tests of fleet_tui/simulator/vda5050/faults.py: each fault is seen in the state."""

import pytest

from fleet_tui.simulator.vda5050.faults import FAULTS
from fleet_tui.simulator.vda5050.messages import state
from fleet_tui.simulator.vda5050.vehicle import SimVehicle


@pytest.mark.parametrize("name", FAULTS)
def test_each_changes_the_vehicle(name: str) -> None:
    text, apply = FAULTS[name]
    usual, faulty = (SimVehicle("robot_0", (0.0, 0.0), "hall", "a") for _ in range(2))
    apply(faulty)
    is_hidden = name in ("silent", "refuse", "slow-cancel")
    assert text and vars(faulty) != vars(usual) and (is_hidden or state(faulty) != state(usual))
