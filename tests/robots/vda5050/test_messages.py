"""Messages as events."""

from typing import Any

import pytest

from fleet_tui.model import events
from fleet_tui.model.commands import Stage
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import OrderState, Stop
from fleet_tui.model.vehicles.events import FactsheetReported, MasterSeen
from fleet_tui.robots.vda5050.messages import short_id
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import error, message, node, position, state


def states(site: VehicleSite) -> list[OrderState | None]:
    return [site.agv.orders.orders[-1].state]


@pytest.mark.parametrize(
    ("id_", "short"),
    [
        ("3fa85f64-5717-4562-b3fc-2c963f66afa6", "3fa85f64"),
        ("order-12", "order-12"),
        ("a b", "c8687a08"),
        ("x" * 30, "666a596d"),
    ],
)
def test_orders_have_ids_that_people_can_type(id_: str, short: str) -> None:
    assert short_id(id_) == short


def test_a_state_tells_pose_charge_cargo_and_pause() -> None:
    site = VehicleSite()
    site.read("state", state(loads=[{"loadId": "1"}], paused=True))
    agv = site.agv
    assert agv.pose is not None and agv.pose.value == Pose(1.0, 2.0, 0.5) and agv.floor == "hall"
    assert agv.battery is not None and agv.battery.value == 80.5
    assert agv.has_cargo and site.state.is_paused(agv) and site.state.is_online(agv)


def test_a_visualization_has_the_pose_alone() -> None:
    site = VehicleSite()
    (found,) = site.read("visualization", message(agvPosition=position(5.0)))
    assert isinstance(found, events.PoseReported) and found.pose.x == 5.0
    assert site.read("visualization", message()) == ()


def test_the_order_of_a_vehicle_is_driven_done_cancelled_or_failed() -> None:
    site = VehicleSite()
    site.read("state", state(orderId="o1", nodeStates=[node("b", 4), node("a", 2)]))
    order = site.agv.orders.orders[0]
    assert (order.id, order.state, order.stops) == ("o1", OrderState.IN_PROCESS, (Stop("b"),))
    site.read("state", state(orderId="o1"))
    assert states(site) == [OrderState.DONE]
    site.read("state", state(orderId="o2", nodeStates=[node("a", 2)]))
    cancel = [{"actionId": "x", "actionType": "cancelOrder", "actionStatus": "FINISHED"}]
    site.read("state", state(orderId="o2", actionStates=cancel))
    assert states(site) == [OrderState.CANCELLED]
    site.read("state", state(orderId="o2"))  # finished states vanish
    assert states(site) == [OrderState.CANCELLED]
    site.read("state", state(orderId="o3", nodeStates=[node("a", 2)]))
    site.read("state", state(orderId="o3", errors=[error("FATAL", orderId="o3")]))
    assert states(site) == [OrderState.FAILED]


def action(id_: str, type_: str, status: str, text: str = "") -> dict[str, str]:
    return {"actionId": id_, "actionType": type_, "actionStatus": status, "resultDescription": text}


def test_an_order_of_which_an_action_failed_has_failed() -> None:
    site = VehicleSite()
    pick = action("o1-pick", "pick", "WAITING")
    site.read("state", state(orderId="o1", nodeStates=[node("a", 2)], actionStates=[pick]))
    failed = action("o1-pick", "pick", "FAILED", "no pallet found")
    beside = action("p1", "startPause", "FAILED", "not now")
    site.read("state", state(orderId="o1", actionStates=[beside, failed]))
    assert states(site) == [OrderState.FAILED]
    assert site.agv.orders.orders[0].said == "pick failed: no pallet found"
    site.read("state", state(orderId="o2", nodeStates=[node("a", 2)], actionStates=[beside, failed]))
    site.read("state", state(orderId="o2", actionStates=[beside, failed]))
    assert states(site) == [OrderState.DONE], "what failed was another order's"


def test_a_cancellation_that_still_stands_in_the_states_is_not_of_the_next_order() -> None:
    site = VehicleSite()
    site.read("state", state(orderId="o1", nodeStates=[node("a", 2)]))
    cancelled = [action("c1", "cancelOrder", "FINISHED"), action("d", "drop", "FAILED")]
    site.read("state", state(orderId="o1", actionStates=cancelled))
    assert states(site) == [OrderState.CANCELLED]
    site.read("state", state(orderId="o2", nodeStates=[node("b", 2)], actionStates=cancelled))
    site.read("state", state(orderId="o2", actionStates=cancelled))
    assert states(site) == [OrderState.DONE]
    site.read("state", state(orderId="o3", nodeStates=[node("b", 2)], actionStates=cancelled))
    again = [*cancelled, action("c2", "cancelOrder", "FINISHED")]
    site.read("state", state(orderId="o3", actionStates=again))
    assert states(site) == [OrderState.CANCELLED]


def test_a_cancellation_is_known_by_its_id_where_states_do_not_name_their_actions() -> None:
    site = VehicleSite()
    site.read("state", state(orderId="o1", nodeStates=[node("a", 2)]))
    site.read("instantActions", message(actions=[{"actionId": "c1", "actionType": "cancelOrder"}]))
    site.read("state", state(orderId="o1", actionStates=[action("c1", "", "FINISHED")]))
    assert states(site) == [OrderState.CANCELLED]


def test_an_instant_action_known_by_its_id_does_not_fail_or_prolong_an_order() -> None:
    site = VehicleSite()
    site.read("state", state(orderId="o1", nodeStates=[node("a", 2)]))
    beside = [{"actionId": "p1", "actionType": "startPause"}, {"actionId": "b1", "actionType": "beep"}]
    site.read("instantActions", message(actions=beside))
    told = [action("p1", "", "FAILED"), action("b1", "beep", "RUNNING"), action("l", "logReport", "RUNNING")]
    site.read("state", state(orderId="o1", actionStates=told))
    assert states(site) == [OrderState.DONE]


def test_a_cancellation_that_was_over_before_the_first_state_is_not_of_the_order_driven_then() -> None:
    site = VehicleSite()
    old = [action("c1", "cancelOrder", "FINISHED")]
    site.read("state", state(orderId="o2", nodeStates=[node("a", 2)], actionStates=old))
    site.read("state", state(orderId="o2", actionStates=old))
    assert states(site) == [OrderState.DONE]


def test_an_order_that_was_cancelled_is_over_though_its_actions_wait_for_ever() -> None:
    site = VehicleSite()
    drop = action("d", "drop", "WAITING")
    site.read("state", state(orderId="o1", nodeStates=[node("a", 2)], actionStates=[drop]))
    site.read("state", state(orderId="o1", actionStates=[drop]))
    assert states(site) == [OrderState.IN_PROCESS]
    site.read("state", state(orderId="o1", actionStates=[drop, action("c1", "cancelOrder", "FINISHED")]))
    assert states(site) == [OrderState.CANCELLED]


@pytest.mark.parametrize(
    "odd", [{"nodeStates": "none"}, {"nodeStates": [3]}, {"actionStates": "d"}, {"actionStates": ["d"]}]
)
def test_an_order_has_not_ended_because_its_parts_can_not_be_read(odd: dict[str, Any]) -> None:
    site = VehicleSite()
    site.read("state", state(orderId="o1", nodeStates=[node("a", 2)]))
    site.read("state", state(orderId="o1", **odd))
    assert states(site) == [OrderState.IN_PROCESS] and site.agv.faults == 1
    site.read("state", state(orderId="o1", nodeStates={}))  # as some libraries write an empty list
    assert states(site) == [OrderState.DONE]


def test_a_vehicle_that_keeps_all_nodes_but_the_one_it_has_reached_has_driven_its_order() -> None:
    site = VehicleSite()
    way = [node("n0", 0), node("a", 2), node("b", 4)]
    site.read("state", state(orderId="o1", nodeStates=way, lastNodeId="n0", lastNodeSequenceId=0))
    assert states(site) == [OrderState.IN_PROCESS]
    site.read("state", state(orderId="o1", nodeStates=way[:2], lastNodeId="b", lastNodeSequenceId=4))
    assert states(site) == [OrderState.DONE]
    # The number is that of the last order, until the vehicle begins.
    site.read("state", state(orderId="o2", nodeStates=way[:2], lastNodeId="b", lastNodeSequenceId=4))
    assert states(site) == [OrderState.IN_PROCESS]


def test_a_vehicle_that_keeps_the_nodes_it_has_passed_is_not_busy_for_ever() -> None:
    site = VehicleSite()
    way = [node("n0", 0), node("a", 2), node("b", 4)]
    site.read("state", state(orderId="o1", nodeStates=way, lastNodeId="n0", lastNodeSequenceId=0))
    assert states(site) == [OrderState.IN_PROCESS]
    assert site.agv.orders.orders[0].stops == (Stop("b"),)
    site.read("state", state(orderId="o1", nodeStates=way, lastNodeId="b", lastNodeSequenceId=4))
    assert states(site) == [OrderState.DONE]
    # The number is the last order's until a node of this one is reached.
    site.read("state", state(orderId="o2", nodeStates=way[1:], lastNodeId="b", lastNodeSequenceId=8))
    assert states(site) == [OrderState.IN_PROCESS]


def test_an_order_that_is_driven_to_its_goal_is_done_though_its_vehicle_names_it_no_more() -> None:
    site = VehicleSite()
    drop = action("o1-drop", "drop", "RUNNING")
    site.read("state", state(orderId="o1", nodeStates=[node("a", 2)], actionStates=[drop]))
    site.read("state", state(lastNodeId="a", actionStates=[{**drop, "actionStatus": "FINISHED"}]))
    site.read("state", state(lastNodeId="a"))
    assert states(site) == [OrderState.DONE]
    site.read("state", state(orderId="o2", lastNodeId="a", nodeStates=[node("b", 2)]))
    site.read("state", state(lastNodeId="b", errors=[error("FATAL", orderId="o2")]))
    assert states(site) == [OrderState.FAILED]


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ({"nodeStates": [node("a", 2)]}, {}),
        ({"nodeStates": [node("b", 2), node("a", 4)]}, {"lastNodeId": "a"}),
        ({"nodeStates": [node("a", 2), node("b", 4, released=False)]}, {"lastNodeId": "a"}),
        (
            {"nodeStates": [node("a", 2)], "actionStates": [action("x", "drop", "RUNNING")]},
            {"lastNodeId": "a"},
        ),
    ],
)
def test_an_order_that_its_vehicle_forgets_before_its_end_is_not_done(
    before: dict[str, Any], after: dict[str, Any]
) -> None:
    site = VehicleSite()
    site.read("state", state(orderId="o1", **before))
    site.read("state", state(**after))
    assert site.agv.orders.orders == () and site.agv.gone[-1].stage is Stage.LOST


def test_an_order_that_grows_has_a_new_target() -> None:
    site = VehicleSite()
    site.read("state", state(orderId="o1", nodeStates=[node("a", 2)]))
    site.read("state", state(orderId="o1", nodeStates=[node("a", 2), node("b", 4, released=False)]))
    assert site.agv.orders.orders[0].stops == (Stop("b"),)


def test_orders_of_this_operator_are_known_after_a_restart() -> None:
    site = VehicleSite()
    owned = "3fa85f64-5717-4562-b3fc-" + site.adapter.site.console
    site.read("state", state(orderId=owned, nodeStates=[node("a", 2)]))
    assert [goal.is_ours for goal in site.agv.goals["order"]] == [True]
    site.read("state", state(orderId="other", nodeStates=[node("a", 2)]))
    assert [goal.is_ours for goal in site.agv.goals["order"]] == [False]


def test_master_controls_and_properties_are_noted() -> None:
    site = VehicleSite()
    found = site.read("order", message(orderId="o9", nodes=[node("a", 0, x=1.0)], edges=[]))
    assert found[0] == MasterSeen("agv", site.now, "order o9", ("o9",))
    (seen,) = site.read(
        "instantActions", message(instantActions=[{"actionType": "startPause", "actionId": "x"}])
    )
    assert seen == MasterSeen("agv", site.now, "startPause", ("x",))
    (sheet,) = site.read(
        "factsheet", message(typeSpecification={"seriesName": "T\x1b", "agvClass": "FORKLIFT"})
    )
    assert isinstance(sheet, FactsheetReported) and sheet.facts["agvClass"] == "FORKLIFT"


def test_a_wrong_time_is_named_and_the_pose_is_used() -> None:
    site = VehicleSite()
    found = site.read("visualization", message(agvPosition=position(), timestamp="yesterday"))
    assert isinstance(found[0], events.PoseReported) and found[0].stamp is None
    assert isinstance(found[1], events.MessageRejected)
