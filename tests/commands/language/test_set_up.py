"""Set-up as it is typed."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.commands.language.completion import complete
from fleet_tui.commands.language.grammar import parse, written
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import Kind
from fleet_tui.model.order import Stop
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.commands import (
    CancelGoal,
    Localise,
    SendGoal,
    SendGraph,
    SetMapping,
    SetPose,
    Settle,
    StoreMap,
    StorePoseGraph,
)
from fleet_tui.text.errors import CommandError
from tests.support.fleets import F0, R0, T0, fleet, graph, labels, of_kinds, pose, reduced

HAS_GOALS = Kind("", ("graph",), ("pose", "goal", "mapping", "localise", "settle"))
NAVIGATES = Kind("nav2", (), ("order", "order to"), keeps_goals=True, takes_stops=True)


def site(kind: Kind = HAS_GOALS) -> FleetState:
    facts = graph(1, 2, 3), labels({2: "Base", 3: "Far end"}), pose(T0, 0.0, 0.0)
    return reduced(of_kinds(fleet(), kind), *facts)


@pytest.mark.parametrize(
    ("line", "command"),
    [
        ("set-pose robot_0 1.5 -2 90", SetPose(R0, F0, Pose(1.5, -2.0, math.pi / 2))),
        ("SET-POSE robot_0 0 0 450", SetPose(R0, F0, Pose(0.0, 0.0, math.pi / 2))),
        ("goto robot_0 1 2", SendGoal(R0, F0, Pose(1.0, 2.0))),
        ("goto robot_0 1 2 -180", SendGoal(R0, F0, Pose(1.0, 2.0, -math.pi))),
        ("localise robot_0", Localise(R0)),
        ("cancel robot_0 goal", CancelGoal(R0)),
        ("settle robot_0", Settle(R0)),
        ("settle robot_0 3", Settle(R0, 3)),
        ("mapping robot_0 on", SetMapping(R0, True)),
        ("mapping robot_0 off", SetMapping(R0, False)),
        ("store-map robot_0 hall", StoreMap(R0, "hall")),
        ("store-pose-graph robot_0 hall", StorePoseGraph(R0, "hall")),
    ],
)
def test_a_line_means_a_command(line: str, command: object) -> None:
    (found,) = parse(line, site()).commands
    assert found == command


def test_a_place_is_the_pose_of_its_vertex_where_goals_are_no_orders() -> None:
    (found,) = parse("goto robot_0 'Far end'", site()).commands
    vertex = site().robots[R0].maps[F0].graph
    assert vertex is not None and isinstance(found, SendGoal)
    there = vertex.vertices["3"]
    assert (found.pose.x, found.pose.y) == (there.x, there.y)
    assert math.isclose(found.pose.yaw, math.atan2(there.y, there.x))


def test_where_goals_are_orders_it_is_an_order_to_a_robot_without_any() -> None:
    state = site(NAVIGATES)
    expected = Request((PlaceOrder(R0, (Stop("2"),)),), (("2", F0),), alone=True)
    assert parse("goto robot_0 Base", state) == expected
    at = Stop(pose=Pose(1.0, 2.0, 0.0), turns_freely=True)
    assert parse("goto robot_0 1 2", state) == Request((PlaceOrder(R0, (at,)),), alone=True)


@pytest.mark.parametrize("word", ["nan", "inf", "1e5", "x", "1_0", "", "٣", "9" * 20])
def test_only_plain_numbers_are_numbers(word: str) -> None:
    with pytest.raises(CommandError, match="is not a number"):
        parse(f"set-pose robot_0 1 '{word}' 0", site())


def test_what_is_missing_is_shown() -> None:
    for line in (
        "set-pose robot_0 1 2",
        "goto robot_0",
        "mapping robot_0",
        "mapping robot_0 maybe",
        "settle robot_0 6",
        "localise",
    ):
        with pytest.raises(CommandError, match="usage: "):
            parse(line, site())
    with pytest.raises(CommandError, match="has no place 'Bse', did you mean Base"):
        parse("goto robot_0 Bse", site())
    with pytest.raises(CommandError, match="the floor of robot_0 is unknown: it has floor_0, floor_1"):
        parse("set-pose robot_0 1 2 3", fleet(floors=2))


@given(st.floats(-999.0, 999.0), st.floats(-999.0, 999.0), st.floats(-math.pi, math.pi))
def test_what_is_written_is_read_again(x: float, y: float, yaw: float) -> None:
    state = site()
    for kind in (SetPose, SendGoal):
        (found,) = parse(written(kind(R0, F0, Pose(round(x, 3), round(y, 3), yaw)), state), state).commands
        assert isinstance(found, kind)
        assert math.isclose(found.pose.x, x, abs_tol=6e-4) and math.isclose(found.pose.y, y, abs_tol=6e-4)
        assert abs(math.remainder(found.pose.yaw - yaw, math.tau)) < 1e-6
    for command in (
        CancelGoal(R0),
        Localise(R0),
        Settle(R0),
        Settle(R0, 1),
        SetMapping(R0, True),
        StoreMap(R0, "a b"),
        StorePoseGraph(R0, "c"),
    ):
        assert parse(written(command, state), state).commands == (command,)
    assert written(SendGraph(R0, F0), state) == ""
    assert written(PlaceOrder(R0, (Stop(pose=Pose(1.0, 2.0)),)), state) == "goto robot_0 1 2 0"


def test_the_goal_of_a_selected_robot_is_cancelled_where_goals_have_no_id() -> None:
    assert parse("cancel goal", site(), R0).commands == (CancelGoal(R0),)
    with pytest.raises(CommandError, match="is not an order id"):
        parse("cancel robot_0 goal", site(NAVIGATES))
    assert complete("cancel robot_0 ", site(Kind("", (), ("cancel", "goal cancel")))) == [
        "cancel robot_0 goal"
    ]
    assert complete("cancel robot_0 ", site(Kind("", (), ("cancel",)))) == []


def test_completion_offers_what_the_kind_takes() -> None:
    assert complete("set", site()) == ["set-pose ", "settle "]
    assert complete("goto ", site()) == ["goto robot_0 "]
    assert complete("goto robot_0 ", site()) == ["goto robot_0 Base", 'goto robot_0 "Far end"']
    assert complete("mapping robot_0 ", site()) == ["mapping robot_0 on", "mapping robot_0 off"]
    saves = site(Kind("", (), ("map save",)))
    assert complete("store-map robot_0 ", saves) == ["store-map robot_0 floor_0"]
    assert complete("store", saves) == ["store-map "]
    assert complete("localise ", site()) == ["localise robot_0"]
    assert complete("set-p", site(NAVIGATES)) == []
