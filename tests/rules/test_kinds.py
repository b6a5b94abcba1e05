"""Kinds of robots made up: what one never reports or accepts is neither expected nor asked for."""

import math

import pytest

from fleet_tui.adapters.adapter import Site
from fleet_tui.adapters.oh_ressources.adapter import OhRessources
from fleet_tui.adapters.profile import Profile
from fleet_tui.cli.session import missing
from fleet_tui.model import events
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import CANCEL, CLEAR, ORDER, ORDER_TO, PAUSE, Kind
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.rules.commands.checks import acceptable, problems, unaccepted
from fleet_tui.rules.language.completion import complete
from fleet_tui.rules.language.lookup import destination_only, may_skip_start
from fleet_tui.rules.why.why import reasons
from tests.support.fleets import (
    R0,
    T0,
    battery,
    fleet,
    graph,
    labels,
    link_up,
    of_kinds,
    place_order,
    pose,
    queue,
    tick,
    told,
)

R1 = "robot_1"
BARE = Kind("bare", ("pose",))
"""Tells where it is, and takes no command."""
GOALS = Kind("goals", ("pose", "battery", "queue", "graph", "labels"), (ORDER, ORDER_TO, CANCEL, CLEAR))
FULL = fleet().robots[R0].kind


def heard(*kinds: Kind, at: float = T0 + 1.0) -> FleetState:
    """Robots of these kinds, all of which were just heard."""
    state = of_kinds(fleet(len(kinds)), *kinds)
    known = [fact for name in state.robots for fact in (graph(1, 2, robot=name), pose(at, robot=name))]
    return told(state, link_up(T0), *known, tick(at))


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
    assert found(heard(BARE), command) == [("not accepted", text, True)]
    assert unaccepted(heard(FULL), command) == ""


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
    assert unaccepted(heard(Kind(accepts=(accepts,))), command) == lack


def test_of_several_robots_those_that_can_do_not_wait_for_the_others() -> None:
    state = heard(FULL, BARE, FULL)
    every = Request(tuple(map(PauseRobot, state.robots)))
    able, left_out = acceptable(state, every)
    assert [one.robot for one in able.commands] == [R0, "robot_2"]
    assert [one.text for one in left_out] == ["robot_1: this kind has no pause"]
    assert problems(state, able, Permissions()) == []


def test_where_none_can_nothing_is_left_out_and_the_checks_say_it() -> None:
    state = heard(BARE, BARE)
    every = Request(tuple(map(PauseRobot, state.robots)))
    assert acceptable(state, every) == (every, [])
    assert found(state, *every.commands) == [
        ("not accepted", "robot_0, robot_1: this kind has no pause", True)
    ]


def test_an_order_to_one_place_needs_no_cargo_where_none_is_told_of() -> None:
    state = told(heard(GOALS), queue(T0 + 1.0))
    assert found(state, place_order(R0, 2)) == []
    carries = told(heard(FULL), queue(T0 + 1.0), events.CargoReported(R0, T0 + 1.0, False))
    assert [check for check, _, _ in found(carries, place_order(R0, 2))] == ["no cargo"]


def test_a_queue_that_comes_only_when_it_changes_is_not_waited_for() -> None:
    on_change = Kind("goals", GOALS.reports, GOALS.accepts, {"queue": math.inf})
    assert found(heard(on_change), place_order(R0, 2)) == []
    assert [check for check, _, _ in found(heard(GOALS), place_order(R0, 2))] == ["queue unheard"]


def test_a_robot_without_a_queue_is_not_said_to_have_no_orders() -> None:
    blind = Kind("blind", ("pose", "graph"), (CANCEL, CLEAR))
    assert found(heard(blind), ClearOrders(R0)) == []
    assert found(heard(blind), CancelOrder(R0, "7")) == []
    assert [check for check, _, _ in found(heard(GOALS), ClearOrders(R0))] == ["nothing to clear"]


def test_a_floor_without_a_graph_has_no_vertex_and_none_will_come() -> None:
    state = told(of_kinds(fleet(), Kind("drives", ("pose",), (ORDER_TO,))), link_up(T0), pose(T0), tick(T0))
    (problem,) = found(state, place_order(R0, 7))
    assert problem == ("unknown vertex", "robot_0 has no vertex 7: no graph of floor_0", True)


def test_each_value_is_old_after_its_own_silence() -> None:
    slow = Kind("slow", ("pose", "battery", "queue"), silence={"battery": 60.0, "queue": math.inf})
    state = told(of_kinds(fleet(2), slow, FULL), link_up(T0))
    for name in state.robots:
        state = told(state, battery(T0, robot=name), queue(T0, robot=name), pose(T0 + 40, robot=name))
    state = told(state, tick(T0 + 41))
    one, other = state.robots[R0], state.robots[R1]
    assert not state.is_old(one, "battery") and not state.is_old(one, "queue")
    assert state.is_old(other, "battery") and state.is_old(other, "queue")
    later = told(state, pose(T0 + 70), tick(T0 + 70))
    assert later.is_old(later.robots[R0], "battery") and not later.is_old(later.robots[R0], "queue")


def test_of_a_robot_that_is_offline_everything_is_old() -> None:
    kind = Kind("slow", ("pose", "queue"), silence={"queue": math.inf, "pose": 60.0})
    state = told(of_kinds(fleet(), kind), link_up(T0), queue(T0), pose(T0), tick(T0 + 6))
    robot = state.robots[R0]
    assert state.is_old(robot, "queue") and state.is_old(robot, "pose")
    assert not state.is_old(robot, "battery") and not state.is_fresh(robot, "battery")


def test_only_what_is_reported_again_and_again_is_missing() -> None:
    kind = Kind("some", ("pose", "battery", "queue", "labels"), silence={"queue": math.inf})
    state = of_kinds(fleet(), kind)
    assert missing(state.robots[R0]) == ["pose", "battery", "labels of floor_0"]
    assert missing(of_kinds(fleet(), BARE).robots[R0]) == ["pose"]


@pytest.mark.parametrize(
    ("kind", "only_to", "may_skip"),
    [
        (FULL, False, False),
        (GOALS, False, True),
        (Kind(accepts=(ORDER_TO,)), True, False),
        (Kind(accepts=(ORDER,)), False, False),
    ],
)
def test_which_orders_need_a_start(kind: Kind, only_to: bool, may_skip: bool) -> None:
    robot = heard(kind).robots[R0]
    assert (destination_only(robot), may_skip_start(robot)) == (only_to, may_skip)


def test_only_accepted_verbs_and_robots_complete_a_line() -> None:
    state = told(heard(BARE, Kind("p", accepts=(PAUSE,))), labels({1: "Base"}))
    assert complete("p", state) == ["pause "]
    assert complete("cl", state) == []
    assert complete("pause ", state) == ["pause all", "pause robot_1"]
    assert complete("robot_0 ", state) == []
    assert complete("robot_0 ", told(heard(FULL), labels({1: "Base"}))) == ["robot_0 Base "]


def names(state: FleetState) -> list[str]:
    return [reason.name for reason in reasons(state, state.robots[R0])]


def test_no_reason_is_made_of_what_is_never_reported() -> None:
    still = told(heard(BARE), pose(T0 + 9), tick(T0 + 9))
    assert names(still) == ["cause unknown"]
    assert names(told(heard(Kind("silent")), battery(T0 + 9), tick(T0 + 9))) == ["cause unknown"]
    assert "queue unknown" in names(told(heard(FULL), pose(T0 + 9), tick(T0 + 9)))


def test_a_robot_without_cargo_does_not_load() -> None:
    order = (1, 1, 2, "W")
    for kind, name in ((GOALS, "cause unknown"), (FULL, "loading at 1")):
        driving = told(
            heard(kind), queue(T0 + 1, order, current=1), pose(T0 + 9), queue(T0 + 9, order, current=1)
        )
        assert name in names(told(driving, tick(T0 + 9)))


def test_a_site_that_leaves_a_service_out_has_no_such_command() -> None:
    profile = Profile(services={"pause": "", "order_with_cargo": ""})
    kind = OhRessources(profile, Site(table="profiles.a")).kind
    assert [found(heard(kind), command)[0][1] for command in (PauseRobot(R0), place_order(R0, 1))] == [
        "robot_0: profiles.a.services.pause is empty: no pause",
        "robot_0: profiles.a.services.order_with_cargo is empty: no order without a start",
    ]
    assert unaccepted(heard(kind), place_order(R0, 1, 2)) == ""
