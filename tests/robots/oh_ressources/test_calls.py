"""Calls to the robots of the source: each request complete, and none that would mean all."""

import re
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop, at_vertices
from fleet_tui.model.robot import Robot
from fleet_tui.robots.adapter import ServiceCall
from fleet_tui.robots.profile import Profile
from fleet_tui.text.errors import CommandError
from tests.support.adapters import adapter_of
from tests.support.fleets import place_order

ORDER = place_order("r1", 0, 7)


INT32 = st.integers(-(2**31), 2**31 - 1)


SERVICE = "/r1/Application_layout/"


def call(command: Command, request_id: int = 5, profile: Profile | None = None) -> ServiceCall:
    (made,) = adapter_of(profile).outgoing(command, request_id, Robot("r1", 1, "", {}))
    assert isinstance(made, ServiceCall)
    return made


@pytest.mark.parametrize(
    ("command", "service", "args"),
    [
        (place_order("r1", 0, 7), "Execute_order", {"request_id": 5, "initial_point": 0, "end_point": 7}),
        (place_order("r1", 7), "Execute_order_with_cargo", {"request_id": 5, "agent": "r1", "end_point": 7}),
        (CancelOrder("r1", "3"), "Cancel_order", {"robot": "r1", "ind": 3}),
        (ClearOrders("r1"), "Clear_orders", {"robot": "r1", "ind": 0}),
        (PauseRobot("r1"), "Pause", {}),
        (ResumeRobot("r1"), "Resume", {}),
    ],
)
def test_every_request_is_complete_and_typed(command: Command, service: str, args: dict[str, Any]) -> None:
    """A bridge fills what is missing with zeros and takes it for an order 0 -> 0."""
    made = call(command)
    assert (made.address, dict(made.args)) == (SERVICE + service, args)
    assert {name: type(value) for name, value in made.args.items()} == {
        name: type(value) for name, value in args.items()
    }


@pytest.mark.parametrize("order_id", [0, -1, -(2**31)])
def test_a_cancel_that_would_mean_all_is_refused(order_id: int) -> None:
    with pytest.raises(CommandError, match="clear"):
        call(CancelOrder("r1", str(order_id)))


@pytest.mark.parametrize("beyond", [2**31, -(2**31) - 1, 10**30])
def test_what_does_not_fit_the_robots_ids_is_refused(beyond: int) -> None:
    for command in (place_order("r1", beyond, 1), place_order("r1", 1, beyond), place_order("r1", beyond)):
        with pytest.raises(CommandError, match=str(beyond)):
            call(command)
    with pytest.raises(CommandError):
        call(CancelOrder("r1", str(beyond)))
    with pytest.raises(CommandError):
        call(place_order("r1", 1, 2), request_id=beyond)


@given(st.text(max_size=12).filter(lambda id_: not re.fullmatch(r"-?[0-9]{1,100}", id_, re.ASCII)))
@example("dock A")
@example("٣")
@example("3f2a77")
@example("1_0")
@example("1" * 5000)
def test_an_id_that_is_no_number_never_leaves_for_these_robots(id_: str) -> None:
    for command in (place_order("r1", id_, 1), place_order("r1", 1, id_), place_order("r1", id_)):
        with pytest.raises(CommandError, match="is not a number"):
            call(command)
    with pytest.raises(CommandError, match="is not a number"):
        call(CancelOrder("r1", id_))


def test_what_these_robots_can_not_drive_never_leaves() -> None:
    with pytest.raises(CommandError, match="to vertices, not to poses"):
        call(PlaceOrder("r1", (Stop(pose=Pose(1.0, 2.0)),)))
    for stops, count in (((), 0), (at_vertices("1", "2", "3"), 3)):
        with pytest.raises(CommandError, match=f"one or two stops, not {count}"):
            call(PlaceOrder("r1", stops))


@given(INT32, INT32, st.integers(1, 2**31 - 1))
def test_whatever_fits_is_sent_as_it_is(start: int, end: int, order_id: int) -> None:
    assert dict(call(place_order("r1", start, end)).args) == {
        "request_id": 5,
        "initial_point": start,
        "end_point": end,
    }
    assert call(CancelOrder("r1", str(order_id))).args["ind"] == order_id


def test_calls_under_other_names() -> None:
    names = {
        "order_call.request_id": "rid",
        "order_call.initial_point": "from",
        "order_call.end_point": "to",
        "cargo_call.agent": "who",
        "cancel_call.robot": "name",
        "cancel_call.ind": "number",
    }
    profile = Profile(fields=names, services={"order": "/fleet/{robot}/go"})
    made = call(place_order("r1", 0, 7), profile=profile)
    assert (made.address, made.args) == ("/fleet/r1/go", {"rid": 5, "from": 0, "to": 7})
    assert call(place_order("r1", 7), profile=profile).args == {"request_id": 5, "who": "r1", "end_point": 7}
    assert call(CancelOrder("r1", "3"), profile=profile).args == {"name": "r1", "number": 3}
    assert call(ClearOrders("r1"), profile=profile).args == {"name": "r1", "number": 0}
