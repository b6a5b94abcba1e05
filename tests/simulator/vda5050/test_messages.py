"""Tests of simulator/vda5050/serving, by the published model of another library."""

import pytest

from fleet_tui.simulator.vda5050.serving import factsheet, header, state
from fleet_tui.simulator.vda5050.vehicle import SimVehicle


def test_a_state_is_one_for_another_library() -> None:
    model = pytest.importorskip("vda5050.model.state")
    vehicle = SimVehicle("robot_0", (1.0, 2.0), "hall", "a")
    place = {"x": 3.0, "y": 2.0, "mapId": "hall"}
    nodes = [
        {"nodeId": id_, "sequenceId": n, "released": True, "nodePosition": place}
        for n, id_ in ((0, "a"), (2, "b"))
    ]
    vehicle.take_order({"orderId": "o", "orderUpdateId": 0, "nodes": nodes})
    vehicle.take_action({"actionType": "startPause", "actionId": "x"})
    read = model.State.model_validate({**header(vehicle, 1, "2026-01-01T00:00:00.000Z"), **state(vehicle)})
    assert read.order_id == "o" and read.paused and [node.node_id for node in read.node_states] == ["b"]
    assert read.agv_position.map_id == "hall" and factsheet()["physicalParameters"]["speedMax"] == 1.2
