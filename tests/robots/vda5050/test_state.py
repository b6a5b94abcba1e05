"""The table from states to our model, in all versions."""

import json
from typing import Any

from fleet_tui.model.geometry import Pose
from fleet_tui.model.vehicles.vehicle import Vehicle, VehicleAction, VehicleError
from fleet_tui.robots.vda5050.fields import Fields
from fleet_tui.robots.vda5050.state import charge_of, graph_of, is_running, nodes_of, pose_of, vehicle_of
from tests.support.vda_messages import error, message, node, position, state, state_3


def read(payload: bytes) -> Vehicle:
    fields = Fields.of(payload)
    found = vehicle_of(fields, "base", nodes_of(fields), {})
    assert fields.faults == []
    return found


def without(payload: bytes, *names: str) -> bytes:
    found: dict[str, Any] = json.loads(payload)
    return json.dumps({name: value for name, value in found.items() if name not in names}).encode()


def test_a_state_of_2_0() -> None:
    vehicle = read(state(loads=[], errors=[error("FATAL", text="hot", hint="cool it", orderId="o1")]))
    assert (vehicle.mode, vehicle.driving, vehicle.charging, vehicle.localised) == (
        "AUTOMATIC",
        False,
        False,
        True,
    )
    assert vehicle.takes_orders and vehicle.e_stop == "" and vehicle.field_violation is False
    assert vehicle.last_node == "n0" and vehicle.load == "" and vehicle.paused is False
    assert vehicle.errors == (VehicleError("motorError", "FATAL", "hot", "cool it", (("orderId", "o1"),)),)


def test_a_state_of_3_0_is_read_by_its_own_names() -> None:
    vehicle = read(state_3(instantActionStates=[{"actionId": "a", "actionStatus": "running"}]))
    assert (vehicle.mode, vehicle.charging, vehicle.localised) == ("TEACHIN", True, False)
    assert vehicle.e_stop == "REMOTE" and vehicle.field_violation is True and not vehicle.takes_orders
    assert vehicle.actions == (VehicleAction("a", "RUNNING", is_beside=True),)
    fields = Fields.of(state_3())
    assert charge_of(fields) == 42.0 and pose_of(fields) == (Pose(1.0, 2.0, 0.5), "hall")


def test_what_is_absent_is_unknown_not_false() -> None:
    names = ("paused", "loads", "agvPosition", "safetyState", "batteryState", "driving")
    vehicle = read(without(state(), *names))
    unknown = (vehicle.paused, vehicle.load, vehicle.localised, vehicle.field_violation, vehicle.charging)
    assert unknown == (None,) * 5 and vehicle.driving is None
    fields = Fields.of(without(state(), *names))
    assert pose_of(fields) is None and charge_of(fields) is None


def test_loads_are_named() -> None:
    assert read(state(loads=[{"loadType": "EPAL"}, {"loadId": "7"}, {}])).load == "EPAL, 7, load"


def test_clearance_is_missing_at_the_end_of_the_released_nodes() -> None:
    ahead = [node("n3", 6, released=False), node("n2", 4, released=False)]
    waiting = read(state(orderId="o", nodeStates=ahead))
    assert waiting.waits and waiting.horizon == 2 and waiting.nodes_left == ()
    going = read(state(orderId="o", nodeStates=[*ahead, node("n1", 2)]))
    assert not going.waits and going.nodes_left == ("n1",) and is_running(going)
    assert read(state(orderId="o", nodeStates=[node("n1", 2)], newBaseRequest=True)).waits
    assert not read(state(orderId="o", newBaseRequest=True)).waits  # its end: there is nothing to wait for


def test_an_order_runs_while_nodes_or_actions_are_left() -> None:
    def action(status: str) -> list[dict[str, str]]:
        return [{"actionId": "a", "actionStatus": status}]

    assert is_running(read(state(orderId="o", actionStates=action("RUNNING"))))
    assert not is_running(read(state(orderId="o", actionStates=action("FINISHED"))))
    assert not is_running(read(state(orderId="o", actionStates=action("failed"))))
    assert not is_running(read(state(nodeStates=[node("n1", 2)])))


def test_a_charge_outside_its_scale_is_named() -> None:
    fields = Fields.of(state(batteryState={"batteryCharge": 5000}))
    assert charge_of(fields) is None and fields.faults == ["charge is 5000, not between 0 and 100"]


def test_a_charge_at_an_end_of_its_scale_is_one() -> None:
    for charge in (0.0, 0.5, 100.0):
        fields = Fields.of(state(batteryState={"batteryCharge": charge}))
        assert charge_of(fields) == charge and fields.faults == []


def test_the_speed_is_that_of_the_directions_that_are_reported() -> None:
    assert read(state(velocity={"vx": -3.0, "vy": 4.0})).speed == 5.0
    assert read(state(velocity={"vx": -3.0})).speed == 3.0
    assert read(state(velocity={"vy": 4.0})).speed == 4.0
    assert read(state(velocity={"omega": 1.0})).speed is None


def test_nodes_with_places_are_a_graph() -> None:
    nodes = [node("a", 0, x=0.0), node("b", 2, x=1.0), node("c", 4)]
    edges = [
        {"edgeId": "e", "startNodeId": "a", "endNodeId": "b"},
        {"edgeId": "f", "startNodeId": "b", "endNodeId": "c"},
    ]
    graph, frame = graph_of(Fields.of(message(nodes=nodes, edges=edges)), "nodes", "edges")
    assert frame == "hall" and list(graph.vertices) == ["a", "b"]
    assert [(edge.start, edge.end) for edge in graph.edges] == [("a", "b")]
    left, _ = graph_of(Fields.of(state(nodeStates=[nodes[1], nodes[0]])), "nodeStates", "edgeStates")
    assert [(edge.start, edge.end) for edge in left.edges] == [("a", "b")]


def test_numbers_of_messages_are_told_from_ids() -> None:
    found = read(state(errors=[error(headerId="7", orderId="o")])).errors[0]
    assert found.references == (("headerId", "7"), ("orderId", "o"))


def test_a_position_without_a_place_is_none() -> None:
    fields = Fields.of(state(agvPosition={**position(), "x": None}))
    assert pose_of(fields) is None
