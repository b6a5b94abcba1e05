"""What a vehicle does with orders and actions."""

from typing import Any

from fleet_tui.simulator.vda5050.vehicle import SimVehicle


def vehicle() -> SimVehicle:
    return SimVehicle("robot_0", (0.0, 0.0), "hall", "a")


def order(id_: str = "o", *places: float, released: bool = True) -> dict[str, Any]:
    nodes = [
        {
            "nodeId": chr(ord("a") + n),
            "sequenceId": 2 * n,
            "released": released or n < 2,
            "nodePosition": {"x": x, "y": 0.0, "mapId": "hall"},
        }
        for n, x in enumerate(places or (0.0, 2.0, 4.0))
    ]
    return {"orderId": id_, "orderUpdateId": 0, "headerId": 3, "nodes": nodes, "edges": []}


def action(type_: str) -> dict[str, Any]:
    return {"actionType": type_, "actionId": "x"}


def drive(one: SimVehicle, seconds: float = 10.0) -> None:
    for _ in range(int(seconds * 20)):
        one.step(0.05)


def test_an_order_is_driven_to_its_end() -> None:
    one = vehicle()
    one.take_order(order())
    assert one.is_running
    drive(one)
    assert (one.x, one.last_node, one.nodes, one.order_id) == (4.0, "c", [], "o") and one.battery < 80.0


def test_it_waits_where_the_released_nodes_end_and_goes_on() -> None:
    one = vehicle()
    one.take_order(order(released=False))
    drive(one)
    assert one.last_node == "b" and len(one.nodes) == 1 and not one.driving
    one.take_order({**order(), "orderUpdateId": 1, "nodes": order()["nodes"][1:]})
    drive(one)
    assert one.last_node == "c"


def test_a_rejection_names_the_order() -> None:
    for change, type_ in (({"rejects": True}, "orderError"), ({"x": 9.0, "last_node": "z"}, "noRouteError")):
        one = vehicle()
        for name, value in change.items():
            setattr(one, name, value)
        one.take_order(order())
        assert one.errors[0]["errorType"] == type_ and not one.is_running
        assert {"referenceKey": "orderId", "referenceValue": "o"} in one.errors[0]["errorReferences"]
    one = vehicle()
    one.take_order(order("first"))
    one.take_order(order("second"))
    assert one.order_id == "first" and one.errors[0]["errorType"] == "orderUpdateError"
    one.take_order({"orderId": "third", "nodes": []})
    assert one.errors[1]["errorType"] == "validationError"


def test_pause_cancel_and_unknown_actions() -> None:
    one = vehicle()
    one.take_order(order())
    one.take_action(action("startPause"))
    drive(one)
    assert one.paused and one.x == 0.0
    one.take_action(action("stopPause"))
    drive(one, 1.0)
    assert one.x > 0.0
    one.take_action(action("cancelOrder"))
    assert not one.is_running and one.actions[-1]["actionStatus"] == "FINISHED"
    one.take_action(action("cancelOrder"))
    assert one.actions[-1]["actionStatus"] == "FAILED" and one.errors[-1]["errorType"] == "noOrderToCancel"
    one.take_action(action("dance"))
    assert one.actions[-1] == {"actionId": "x", "actionType": "dance", "actionStatus": "FAILED"}
    one.take_action(action("stateRequest"))
    assert one.actions[-1]["actionStatus"] == "FINISHED"


def test_a_slow_cancellation_ends_at_the_next_node() -> None:
    one = vehicle()
    one.slow = True
    one.take_order(order())
    drive(one, 1.0)
    one.take_action(action("cancelOrder"))
    assert one.actions[-1]["actionStatus"] == "RUNNING" and one.is_running
    drive(one)
    assert one.actions[-1]["actionStatus"] == "FINISHED" and one.last_node == "b"


def test_it_charges_at_a_node_until_it_is_freed_and_takes_no_order_meanwhile() -> None:
    one = vehicle()
    to_charger = order()
    to_charger["nodes"][-1]["actions"] = [action("startCharging")]
    one.take_order(to_charger)
    drive(one)
    before = one.battery
    drive(one)
    assert one.charging and one.battery > before and not one.is_running
    one.take_order({**order(), "orderId": "p"})
    assert one.errors[-1]["errorType"] == "orderError" and one.order_id == "o"
    one.take_action(action("stopCharging"))
    assert not one.charging and one.actions[-1]["actionStatus"] == "FINISHED"
