"""The protocol knows one master control."""

from typing import Any

import pytest
from msgspec.structs import replace

from fleet_tui.commands.checks import problems
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
from fleet_tui.model.problem import Permissions, Problem
from fleet_tui.model.request import Request
from fleet_tui.orders.local_queue import next_to_send
from tests.support.fleets import commanded
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import error, message, node, state

ORDER = PlaceOrder("agv", at_vertices("n0"))


def site(**fields: Any) -> VehicleSite:
    found = VehicleSite()
    found.read("state", state(**fields))
    found.wait(0.1)
    return found


def named(found: VehicleSite, command: Command) -> dict[str, Problem]:
    return {one.check: one for one in problems(found.state, Request((command,)), Permissions())}


def test_an_order_of_another_hand_forbids_ours_for_a_minute() -> None:
    found = site()
    found.read("order", message(orderId="theirs", nodes=[], edges=[]))
    for command in (ORDER, ClearOrders("agv"), CancelOrder("agv", "x")):
        problem = named(found, command)["another master"]
        assert problem.blocks and "another master control commands agv (order theirs" in problem.text
    assert "another master" not in named(found, PauseRobot("agv"))
    found.wait(61)
    found.read("state", state())
    assert "another master" not in named(found, ORDER)


def test_a_foreign_order_that_is_driven_forbids_ours() -> None:
    found = site(orderId="theirs", nodeStates=[node("a", 2)])
    problem = named(found, ORDER)["another master"]
    assert problem.text == "agv drives order theirs of another master control"


def test_a_mode_without_orders_forbids_them_and_an_emergency_stop_asks() -> None:
    assert (
        named(site(operatingMode="MANUAL"), ORDER)["mode"].text == "agv is in mode manual: it takes no orders"
    )
    problem = named(site(safetyState={"eStop": "MANUAL"}), ORDER)["e-stop"]
    assert not problem.blocks


def test_a_pause_of_another_hand_is_lifted_only_after_asking() -> None:
    found = site(paused=True)
    assert not named(found, ResumeRobot("agv"))["paused elsewhere"].blocks
    ours = {**found.state.robots, "agv": replace(found.agv, paused_by_us=True)}
    found.state = replace(found.state, robots=ours)
    assert "paused elsewhere" not in named(found, ResumeRobot("agv"))


@pytest.mark.parametrize(
    ("fields", "told"),
    [
        ({"safetyState": {"eStop": "MANUAL"}}, "agv is stopped: e-stop (manual)"),
        ({"operatingMode": "MANUAL"}, "agv is in mode manual: it takes no orders"),
        ({"errors": [{"errorType": "lift", "errorLevel": "FATAL"}]}, "agv reports fatal lift"),
    ],
)
def test_an_order_that_waits_here_leaves_after_no_stop_that_nobody_was_asked_about(
    fields: dict[str, Any], told: str
) -> None:
    found = site()
    found.apply(*commanded(1, ORDER, Stage.WAITING, at=found.now))
    found.wait(0.1)
    following = next_to_send(found.state, found.agv)
    assert following is not None and following.id == 1 and found.agv.held == ""
    found.read("state", state(**fields))
    assert next_to_send(found.state, found.agv) is None
    found.wait(0.1)
    found.read("state", state())
    found.wait(0.1)
    assert next_to_send(found.state, found.agv) is None and found.agv.held == told


@pytest.mark.parametrize("by", ["the order", "a resume"])
def test_an_order_that_waits_here_leaves_despite_a_fault_that_was_asked_about(by: str) -> None:
    fatal: dict[str, Any] = {"errors": [error("FATAL", "lift")]}
    found = site(**(fatal if by == "the order" else {}))
    found.apply(*commanded(1, ORDER, Stage.WAITING, at=found.now))
    found.read("state", state(**fatal))
    found.wait(0.1)
    if by == "a resume":
        assert found.agv.held == "agv reports fatal lift"
        found.apply(
            *commanded(2, ResumeRobot("agv"), Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED, at=found.now)
        )
        found.wait(0.1)
    following = next_to_send(found.state, found.agv)
    assert following is not None and following.id == 1 and found.agv.held == ""
    found.read("state", state())
    found.wait(0.1)
    found.read("state", state(**fatal))
    found.wait(0.1)
    assert found.agv.held == "agv reports fatal lift", "it went, and came again"
