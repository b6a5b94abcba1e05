"""Services of the source's robots in both dialects."""

import pytest

from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.ros.filling import service_type
from fleet_tui.simulator.ros.ros2 import ROS2


@pytest.mark.parametrize(
    ("dialect", "order"),
    [(ROS1, "OH_ressources/Execute_manual_order"), (ROS2, "oh_ressources/srv/ExecuteManualOrder")],
)
def test_a_service_has_the_dialects_name_and_the_same_request(dialect: Dialect, order: str) -> None:
    services = OhFleet(1, 1).services(dialect)
    execute, pause, resume = (
        services[f"/robot_0/Application_layout/{verb}"] for verb in ("Execute_order", "Pause", "Resume")
    )
    assert execute.name == order
    assert list(execute.fields) == ["request_id", "initial_point", "end_point"]
    assert pause == resume == service_type(dialect, "std_srvs/Trigger")
    assert not pause.fields
