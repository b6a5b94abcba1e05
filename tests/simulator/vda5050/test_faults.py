"""Each fault is seen in the state."""

import pytest

from fleet_tui.simulator.vda5050.faults import FAULTS
from fleet_tui.simulator.vda5050.serving import state
from fleet_tui.simulator.vda5050.vehicle import SimVehicle


@pytest.mark.parametrize("name", FAULTS)
def test_each_changes_the_vehicle(name: str) -> None:
    text, apply = FAULTS[name]
    usual, faulty = (SimVehicle("robot_0", (0.0, 0.0), "hall", "a") for _ in range(2))
    apply(faulty)
    is_hidden = name in ("silent", "refuse", "slow-cancel")
    assert text and vars(faulty) != vars(usual) and (is_hidden or state(faulty) != state(usual))


def test_a_broken_motor_stops_the_vehicle_without_an_obstacle() -> None:
    vehicle = SimVehicle("robot_0", (0.0, 0.0), "hall", "a")
    vehicle.nodes = [{"nodeId": "b", "sequenceId": 2, "released": True, "nodePosition": {"x": 9.0, "y": 0.0}}]
    FAULTS["motor"][1](vehicle)
    vehicle.step(1.0)
    assert (vehicle.x, vehicle.driving, state(vehicle)["safetyState"]["fieldViolation"]) == (
        0.0,
        False,
        False,
    )
