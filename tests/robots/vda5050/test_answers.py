"""What a state says of a command before it."""

from typing import Any

import pytest

from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.order import at_vertices
from fleet_tui.model.set_up.commands import StartCharging
from fleet_tui.robots.vda5050.answers import answer
from fleet_tui.robots.vda5050.fields import Fields
from fleet_tui.robots.vda5050.state import nodes_of, vehicle_of
from tests.support.vda_messages import error, node, state

ORDER = PlaceOrder("agv", at_vertices("a"))
PAUSE, RESUME, CLEAR = PauseRobot("agv"), ResumeRobot("agv"), ClearOrders("agv")


def said(command: Command, **fields: Any) -> tuple[Stage, str] | None:
    message = Fields.of(state(**fields))
    return answer(command, "mine", 7, vehicle_of(message, "base", nodes_of(message), {}))


def action(status: str, id_: str = "mine", **more: str) -> list[dict[str, str]]:
    return [{"actionId": id_, "actionType": "any", "actionStatus": status, **more}]


def test_an_order_is_taken_when_the_vehicle_names_it() -> None:
    assert said(ORDER) is None
    assert said(ORDER, orderId="mine") == (Stage.ACCEPTED, "")


@pytest.mark.parametrize(
    ("type_", "ids"),
    [
        ("orderUpdateError", {"orderId": "mine"}),
        ("orderError", {"orderId": "mine", "orderUpdateId": "0", "headerId": "7"}),
        ("OTHER_ORDER_ACTIVE", {"orderId": "mine"}),
        ("noRouteError", {"orderId": "mine"}),
        ("validationError", {"headerId": "7"}),
        ("validationError", {"topic": "order", "headerId": "7"}),
        ("mapError", {"orderId": "mine", "orderUpdateId": "0"}),
    ],
)
def test_a_rejection_is_known_by_its_reference(type_: str, ids: dict[str, str]) -> None:
    assert said(ORDER, errors=[error(type_=type_, text="too far", **ids)]) == (
        Stage.REFUSED,
        f"{type_}: too far",
    )


@pytest.mark.parametrize(
    ("type_", "ids"),
    [
        ("orderError", {"orderId": "other"}),  # of an earlier order: it may stay for long
        ("orderError", {"orderId": "other", "headerId": "7"}),
        ("orderError", {}),
        ("validationError", {"topic": "instantActions", "headerId": "7"}),
        ("orderError", {"headerId": "mine"}),
    ],
)
def test_other_errors_are_no_rejection(type_: str, ids: dict[str, str]) -> None:
    assert said(ORDER, errors=[error(type_=type_, **ids)]) is None


def test_an_error_of_an_order_on_its_way_is_no_rejection() -> None:
    failed = error(type_="orderError", orderId="mine")
    assert said(ORDER, orderId="mine", errors=[failed]) == (Stage.ACCEPTED, "")


@pytest.mark.parametrize("command", [PAUSE, RESUME, CLEAR])
def test_instant_actions_that_a_vehicle_can_not_read_are_rejected(command: Command) -> None:
    bad = error(type_="validationError", text="no actions", topic="instantActions", headerId="7")
    assert said(command, paused=None, errors=[bad]) == (Stage.REFUSED, "validationError: no actions")
    other = error(type_="validationError", topic="order", headerId="7")
    assert said(command, paused=None, errors=[other]) is None


@pytest.mark.parametrize(("command", "wanted"), [(PAUSE, True), (RESUME, False)])
def test_a_pause_is_seen_in_its_field_or_by_its_action(command: Command, wanted: bool) -> None:
    assert said(command, paused=wanted) == (Stage.ACCEPTED, "")
    assert said(command, paused=not wanted) is None
    assert said(command, paused=not wanted, actionStates=action("FINISHED")) == (Stage.ACCEPTED, "")
    assert said(command, paused=None, actionStates=action("FINISHED")) == (Stage.CONFIRMED, "action finished")
    assert said(command, paused=None, actionStates=action("RUNNING")) == (Stage.SENT, "")
    failed = action("FAILED", resultDescription="no")
    assert said(command, paused=None, actionStates=failed) == (Stage.REFUSED, "no")


def test_the_start_of_a_charge_is_seen_in_its_field_or_by_its_action() -> None:
    power, command = {"batteryCharge": 50.0}, StartCharging("agv")
    assert said(command, batteryState={**power, "charging": True}) == (Stage.ACCEPTED, "")
    assert said(command, batteryState={**power, "charging": False}) is None
    finished = action("FINISHED")
    assert said(command, batteryState=power, actionStates=finished) == (Stage.CONFIRMED, "action finished")


@pytest.mark.parametrize("command", [CLEAR, CancelOrder("agv", "o")])
def test_a_cancellation_ends_with_the_order(command: Command) -> None:
    left = [node("a", 2)]
    assert said(command, orderId="o", nodeStates=left, actionStates=action("RUNNING")) == (Stage.SENT, "")
    assert said(command, orderId="o", nodeStates=left, actionStates=action("FINISHED")) == (Stage.SENT, "")
    assert said(command, orderId="o", actionStates=action("FINISHED")) == (Stage.ACCEPTED, "")
    assert said(command, actionStates=action("FINISHED", id_="other")) is None
    none = error(type_="noOrderToCancel", text="none")
    assert said(command, errors=[none]) == (Stage.REFUSED, "noOrderToCancel: none")
    old = said(command, errors=[none], orderId="o", nodeStates=left, actionStates=action("RUNNING"))
    assert old == (Stage.SENT, ""), "an order runs: the error is of an earlier cancellation"
    assert (
        said(
            command,
            errors=[{**none, "errorReferences": [{"referenceKey": "actionId", "referenceValue": "x"}]}],
        )
        is None
    )


def test_a_cancellation_that_finished_was_not_rejected_by_the_error_of_an_earlier_one() -> None:
    earlier = error(type_="noOrderToCancel")
    assert said(CLEAR, actionStates=action("FINISHED"), errors=[earlier]) == (Stage.ACCEPTED, "")
    assert said(CLEAR, actionStates=action("FAILED"), errors=[earlier]) == (Stage.REFUSED, "noOrderToCancel")
    assert said(CLEAR, actionStates=action("WAITING"), errors=[earlier]) == (Stage.REFUSED, "noOrderToCancel")
