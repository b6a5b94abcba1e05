"""Services of the source's robots in both dialects."""

import pytest

from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.ros1 import ROS1
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.ros_types import robot_services, service_type


@pytest.mark.parametrize(
    ("dialect", "order"),
    [(ROS1, "OH_ressources/Execute_manual_order"), (ROS2, "oh_ressources/srv/ExecuteManualOrder")],
)
def test_a_service_has_the_dialects_name_and_the_same_request(dialect: Dialect, order: str) -> None:
    services = robot_services(dialect)
    assert services["Execute_order"].name == order
    assert list(services["Execute_order"].fields) == ["request_id", "initial_point", "end_point"]
    assert services["Pause"] == services["Resume"] == service_type(dialect, "std_srvs/Trigger")
    assert not services["Pause"].fields
