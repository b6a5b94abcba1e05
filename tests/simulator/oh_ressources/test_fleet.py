"""A world of the source's robots as the bridge sees it."""

import pytest

from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.ros.ros2 import ROS2

ORDER = "/robot_1/Application_layout/Execute_order"


@pytest.mark.parametrize(("dialect", "type_"), [(ROS1, "std_srvs/Trigger"), (ROS2, "std_srvs/srv/Trigger")])
def test_each_robot_has_the_same_services_in_the_dialects_words(dialect: Dialect, type_: str) -> None:
    services = OhFleet(2, 1, quiet=True).services(dialect)
    assert len(services) == 16 and ORDER in services
    assert services["/robot_0/Application_layout/Pause"].name == type_


def test_an_answer_is_the_worlds_and_its_time_is_the_fleets() -> None:
    world = OhFleet(2, 1, seed=1, quiet=True)
    fleet = world
    answer = fleet.answer(ORDER, {"request_id": 7, "initial_point": 0, "end_point": 5})
    assert answer["request_id"] == 7 and world.robots["robot_1"].orders
    before = world.robots["robot_1"].pose
    fleet.step(5.0)
    assert world.robots["robot_1"].pose != before


def test_a_silent_robot_has_no_health_and_there_are_no_actions() -> None:
    fleet = OhFleet(2, 1, quiet=True)
    fleet.robots["robot_0"].silence = 9.0
    assert {entry["name"].partition(":")[0] for entry in fleet.health()} == {"robot_1"}
    assert fleet.actions == {} and list(fleet.news(ROS1)) == []
