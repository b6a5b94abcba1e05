"""Kinds that accept less: what one has nothing for is never sent, and said in words."""

import math

import pytest

from fleet_tui.commands.abilities import unaccepted
from fleet_tui.commands.checks import acceptable, problems
from fleet_tui.model import events
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import CANCEL, CLEAR, ORDER, ORDER_TO, Kind
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.robots.adapter import Site
from fleet_tui.robots.oh_ressources.adapter import OhRessources
from fleet_tui.robots.profile import Profile
from tests.support.fleets import R0, T0, fleet, link_up, of_kinds, place_order, pose, queue, reduced, tick
from tests.support.kinds import FULL, GOALS, MUTE, moved


def found(state: FleetState, *commands: Command) -> list[tuple[str, str, bool]]:
    problems_ = problems(state, Request(commands), Permissions())
    return [(one.check, one.text, one.blocks) for one in problems_]


@pytest.mark.parametrize(
    ("command", "lack"),
    [
        (PauseRobot(R0), "pause"),
        (ResumeRobot(R0), "resume"),
        (CancelOrder(R0, "1"), "cancel"),
        (ClearOrders(R0), "clear"),
        (place_order(R0, 1, 2), "orders"),
        (place_order(R0, 1), "orders"),
    ],
)
def test_what_a_kind_does_not_accept_is_never_sent(command: Command, lack: str) -> None:
    text = f"robot_0: this kind has no {lack}"
    assert found(moved(MUTE), command) == [("not accepted", text, True)]
    assert unaccepted(moved(FULL), command) == ""


@pytest.mark.parametrize(
    ("accepts", "command", "lack"),
    [
        (ORDER, place_order(R0, 1), "this kind has no order without a start"),
        (ORDER_TO, place_order(R0, 1, 2), "this kind has no order with a start"),
        (ORDER_TO, place_order(R0, 1), ""),
        (ORDER, place_order(R0, 1, 2), ""),
    ],
)
def test_one_form_of_order_is_not_the_other(accepts: str, command: Command, lack: str) -> None:
    assert unaccepted(moved(Kind(accepts=(accepts,))), command) == lack


def test_of_several_robots_those_that_can_do_not_wait_for_the_others() -> None:
    state = moved(FULL, MUTE, FULL)
    every = Request(tuple(map(PauseRobot, state.robots)))
    able, left_out = acceptable(state, every)
    assert [one.robot for one in able.commands] == [R0, "robot_2"]
    assert [one.text for one in left_out] == ["robot_1: this kind has no pause"]
    assert problems(state, able, Permissions()) == []


def test_where_none_can_nothing_is_left_out_and_the_checks_say_it() -> None:
    state = moved(MUTE, MUTE)
    every = Request(tuple(map(PauseRobot, state.robots)))
    assert acceptable(state, every) == (every, [])
    assert found(state, *every.commands) == [
        ("not accepted", "robot_0, robot_1: this kind has no pause", True)
    ]


def test_an_order_to_one_place_needs_no_cargo_where_none_is_told_of() -> None:
    state = reduced(moved(GOALS), queue(T0 + 1.0))
    assert found(state, place_order(R0, 2)) == []
    carries = reduced(moved(FULL), queue(T0 + 1.0), events.CargoReported(R0, T0 + 1.0, False))
    assert [check for check, _, _ in found(carries, place_order(R0, 2))] == ["no cargo"]


def test_a_queue_that_comes_only_when_it_changes_is_not_waited_for() -> None:
    on_change = Kind("goals", GOALS.reports, GOALS.accepts, {"queue": math.inf})
    assert found(moved(on_change), place_order(R0, 2)) == []
    assert [check for check, _, _ in found(moved(GOALS), place_order(R0, 2))] == ["queue unheard"]


def test_a_robot_without_a_queue_is_not_said_to_have_no_orders() -> None:
    blind = Kind("blind", ("pose", "graph"), (CANCEL, CLEAR))
    assert found(moved(blind), ClearOrders(R0)) == []
    assert found(moved(blind), CancelOrder(R0, "7")) == []
    assert [check for check, _, _ in found(moved(GOALS), ClearOrders(R0))] == ["nothing to clear"]


def test_a_floor_without_a_graph_has_no_vertex_and_none_will_come() -> None:
    state = reduced(
        of_kinds(fleet(), Kind("drives", ("pose",), (ORDER_TO,))), link_up(T0), pose(T0), tick(T0)
    )
    (problem,) = found(state, place_order(R0, 7))
    assert problem == ("unknown vertex", "robot_0 has no vertex 7: no graph of floor_0", True)


def test_a_site_that_leaves_a_service_out_has_no_such_command() -> None:
    profile = Profile(services={"pause": "", "order_with_cargo": ""})
    kind = OhRessources(profile, Site(table="profiles.a")).kind
    assert [found(moved(kind), command)[0][1] for command in (PauseRobot(R0), place_order(R0, 1))] == [
        "robot_0: profiles.a.services.pause is empty: no pause",
        "robot_0: profiles.a.services.order_with_cargo is empty: no order without a start",
    ]
    assert unaccepted(moved(kind), place_order(R0, 1, 2)) == ""
