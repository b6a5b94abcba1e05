"""Messages of the simulated hospital fit their definitions."""

import json
from typing import Any

import pytest

from fleet_tui.simulator.rmf import fleet
from fleet_tui.simulator.rmf.fleet import RmfFleet
from fleet_tui.simulator.ros.ros2 import ROS2

WORLD = RmfFleet(2, 2, seed=1, quiet=True)
MEMBERS = list(WORLD.robots.values())
SEEN = dict.fromkeys(WORLD.robots, 7.5)
STAMP = {"sec": 7, "nanosec": 0}


@pytest.mark.parametrize(
    ("type_", "message"),
    [
        ("rmf_fleet_msgs/FleetState", fleet.fleet_state("tiny", MEMBERS, SEEN, ROS2)),
        ("rmf_task_msgs/DispatchStates", fleet.dispatches([], [])),
        ("rmf_building_map_msgs/Graph", fleet.nav_graph("tiny", WORLD.building)),
        ("rmf_building_map_msgs/BuildingMap", fleet.building_map(WORLD.building)),
        ("rmf_lift_msgs/LiftState", fleet.lift_state(WORLD.lift, STAMP)),
        ("rmf_door_msgs/DoorState", fleet.door_state(WORLD.doors[0], STAMP)),
    ],
)
def test_each_has_the_fields_of_its_type(type_: str, message: dict[str, Any]) -> None:
    assert set(message) == set(ROS2.fields(type_) or {})


def test_the_adapter_counts_charge_from_0_to_1() -> None:
    data = json.loads(fleet.fleet_update("tiny", MEMBERS, 5)["data"])["data"]
    assert data["robots"]["robot_0"]["battery"] == MEMBERS[0].body.battery / 100.0
    assert data["robots"]["robot_0"]["unix_millis_time"] == 5
