"""Checks before a command is sent: each by name, errors and warnings apart."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.commands.checks import CHECKS, FIRST, problems, repeated
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.events import CargoReported, CommandPathChanged, Event, GraphReceived, PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.link import CommandPath
from fleet_tui.model.order import vertices_of
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request, chain
from fleet_tui.text.language import Message
from tests.support.checked_orders import F1, floor, found, ready
from tests.support.fleets import (
    F0,
    LINK,
    R0,
    T0,
    fleet,
    graph,
    link_lost,
    link_up,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)

ORDER = place_order(R0, 1, 2)


def test_nothing_speaks_against_what_is_all_right() -> None:
    assert found(ready(), ORDER) == []
    assert found(ready(queue(T0, (4, 1, 2, "Q"))), CancelOrder(R0, "4"), ClearOrders(R0)) == []


@pytest.mark.parametrize(
    ("facts", "command", "problem"),
    [
        ((), place_order(R0, 1, 77), ("unknown vertex", True)),
        ((), place_order("robot_9", 1), ("unknown robot", True)),
        ((), place_order(R0, 2, 2), ("same place", True)),
        ((graph(1), floor(1, 2, joined=False)), ORDER, ("no path", True)),
        ((), CancelOrder(R0, "4"), ("not in the queue", True)),
        ((), CancelOrder(R0, "0"), ("id means all", True)),
        ((), CancelOrder(R0, "-1"), ("id means all", True)),
        ((), ClearOrders(R0), ("nothing to clear", True)),
        ((link_lost(T0),), ORDER, ("no link", True)),
        ((CommandPathChanged(LINK, CommandPath.DEAD, Message("master gone")),), ORDER, ("no link", True)),
        ((link_lost(T0),), ResumeRobot(R0), ("no link", True)),
        ((), place_order(R0, 1), ("no cargo", True)),
        ((tick(T0 + 60),), ORDER, ("offline", False)),
        ((PausedReported(R0, T0, True),), ORDER, ("paused", False)),
        ((CargoReported(R0, T0, True),), ORDER, ("cargo on board", False)),
        (
            (CargoReported(R0, T0, True), queue(T0, (4, 1, 2, "W"))),
            place_order(R0, 2),
            ("cargo on board", False),
        ),
    ],
)
def test_each_check_by_name(facts: tuple[Event, ...], command: Command, problem: tuple[str, bool]) -> None:
    late = any(getattr(fact, "at", T0) > T0 + 1 for fact in facts)
    state = reduced(ready(*facts), *([tick(T0 + 60)] if late else []))
    assert found(state, command) == [problem]


def texts(state: FleetState, *commands: Command) -> str:
    return "; ".join(problem.text for problem in problems(state, Request(commands), Permissions()))


def test_problems_name_the_thing_and_the_nearest_right_one() -> None:
    assert texts(ready(), PauseRobot("robot_O"), ORDER) == "unknown robot robot_O, did you mean robot_0?"
    assert texts(ready(), place_order(R0, 1, 22)) == "robot_0 has no vertex 22, did you mean 2?"
    assert texts(reduced(ready(), tick(T0 + 41)), ORDER) == "robot_0 is offline 41 s"
    assert texts(ready(), place_order(R0, 1, 1)) == "From and To are the same place: Base"


def test_a_robot_never_seen_and_a_graph_that_has_not_come_are_warned_of() -> None:
    state = reduced(fleet(), link_up(T0), tick(T0))
    assert found(state, ORDER) == [
        ("unknown vertex", False),
        ("unknown vertex", False),
        ("never seen", False),
    ]
    assert found(state, CancelOrder(R0, "4")) == [("not in the queue", False), ("never seen", False)]
    assert found(state, ClearOrders(R0)) == [("nothing to clear", False), ("never seen", False)]
    assert found(state, place_order(R0, 1))[-1] == ("no cargo", False)


def test_of_a_chain_each_order_is_looked_at_but_what_comes_before_it_is_its_own() -> None:
    loaded = ready(CargoReported(R0, T0, True))
    assert found(loaded, *chain(R0, ["1", "2", "3"], with_cargo=True)) == []
    assert found(ready(), *chain(R0, ["1", "2", "77"])) == [("unknown vertex", True)]
    assert found(reduced(ready(), tick(T0 + 60)), *chain(R0, ["1", "2", "3"])) == [("offline", False)]


def test_a_pause_is_never_held_back() -> None:
    pauses = Request((PauseRobot(R0), PauseRobot("robot_1")))
    for state in (ready(), ready(link_lost(T0)), fleet()):
        assert problems(state, pauses, Permissions(read_only=True, armed=False)) == []


def test_a_console_that_may_not_sends_nothing() -> None:
    for allowed, name in (
        (Permissions(read_only=True), "read-only"),
        (Permissions(armed=False), "not armed"),
    ):
        first = problems(ready(), Request((ORDER,)), allowed)[0]
        assert (first.check, first.blocks) == (name, True)


def test_the_same_orders_again_within_a_second_are_a_slip() -> None:
    request, given = Request(chain(R0, ["1", "2", "1", "2"])), {chain(R0, ["1", "2", "1", "2"]): T0}
    assert [p.text for p in repeated(request, given, T0 + 0.3)] == ["same order sent 0.3 s ago"]
    assert repeated(request, given, T0 + 1.0) == []
    assert repeated(Request((ORDER,)), given, T0 + 0.1) == []
    for command in (CancelOrder(R0, "1"), PauseRobot(R0), ClearOrders(R0)):
        assert repeated(Request((command,)), {(command,): T0}, T0) == []


ids = st.integers(-2, 12).map(str) | st.text(max_size=3)
orders = st.one_of(st.builds(place_order, st.just(R0), ids, ids), st.builds(place_order, st.just(R0), ids))
destructive = st.one_of(st.builds(CancelOrder, st.just(R0), ids), st.just(ClearOrders(R0)))
facts = st.lists(
    st.sampled_from(
        [
            link_lost(T0),
            pose(T0, frame="nowhere"),
            pose(T0, frame=F1),
            queue(T0, (4, 1, 2, "W")),
            CargoReported(R0, T0, True),
            GraphReceived(R0, F0, RouteGraph()),
            floor(9, 10, lift=9),
            floor(1, 2, 3, lift=1),
            graph(1, 2, 5),
        ]
    )
)


@given(facts, st.lists(st.one_of(orders, destructive), min_size=1, max_size=3))
def test_whatever_is_known_every_wish_is_judged_and_each_problem_once(
    told_of: list[Event], commands: list[Command]
) -> None:
    state = ready(*told_of, floors=2)
    judged = problems(state, Request(tuple(commands)), Permissions())
    assert len(judged) == len(set(judged))
    assert [problem.blocks for problem in judged] == sorted((p.blocks for p in judged), reverse=True)
    assert all(problem.text and problem.check for problem in judged)
    # An order to a vertex that no graph has, once all have come, is never sent.
    robot = state.robots[R0]
    for command in commands:
        if (
            isinstance(command, PlaceOrder)
            and robot.knows_all_graphs()
            and None in map(robot.name_of, vertices_of(command.stops))
        ):
            assert judged[0].blocks
        if isinstance(command, CancelOrder) and command.order_id in ("-2", "-1", "0"):
            assert judged[0].blocks


def test_every_check_has_a_name_of_its_own() -> None:
    assert len({check.__name__ for check in CHECKS + FIRST}) == len(CHECKS + FIRST)
