"""Tests of robots/vda5050/discovery."""

from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.vda5050.discovery import SeenVehicle, discover, named


def test_serial_numbers_become_names_whatever_is_in_them() -> None:
    vehicles = [
        SeenVehicle("A", "truck-7"),
        SeenVehicle("A", "0001"),
        SeenVehicle("B", "0001"),
        SeenVehicle("C", "\x1b[2J\u202e"),
        SeenVehicle("D", "!!"),
        SeenVehicle("D", "??"),
    ]
    assert list(named(vehicles)) == ["agv_0001", "truck_7", "B_0001", "agv_2J", "vehicle", "D"]
    assert named(vehicles)["B_0001"] == SeenVehicle("B", "0001")


def test_a_bridge_has_none() -> None:
    assert not discover(Listed({"/uagv/v2/state": "std_msgs/String"}, {})).robots
