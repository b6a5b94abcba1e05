"""The nearest idle robot: it is idle, no idle one is nearer, and without one the reasons are counted."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.routes.nearest import BATTERY_MARGIN, nearest, why_none, why_not
from fleet_tui.model.alarm import Alarm, Condition, Priority
from fleet_tui.model.commands import Stage
from fleet_tui.model.events import (
    CargoReported,
    Event,
    GraphReceived,
    PausedReported,
    PoseReported,
    QueueReported,
)
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.kind import ORDER
from fleet_tui.model.navigation_events import ModeReported
from fleet_tui.model.order import OrderQueue
from fleet_tui.text.language import Message
from tests.support.fleets import (
    F0,
    R0,
    T0,
    battery,
    commanded,
    fleet,
    graph,
    labels,
    link_up,
    of_kinds,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.kinds import FULL, KEEPING, MUTE

R1, R2 = "robot_1", "robot_2"
F1 = "floor_1"
BASE, STORE = Place("1", "Base", F0), Place("5", "Store", F0)
LOW = fleet().limits.battery_low


def idle(robot: str, x: float) -> list[Event]:
    """A robot on a row of five vertices, all known about it."""
    return [
        graph(1, 2, 3, 4, 5, robot=robot),
        labels({1: "Base", 5: "Store"}, robot=robot),
        pose(T0, x, robot=robot),
        battery(T0, 71.0, robot),
        CargoReported(robot, T0, False),
        queue(T0, robot=robot),
    ]


def state_of(*xs: float) -> FleetState:
    """Idle robots at these metres of the row; the first vertex is Base."""
    facts = [fact for n, x in enumerate(xs) for fact in idle(f"robot_{n}", x)]
    return reduced(fleet(len(xs)), link_up(T0), *facts, tick(T0))


def name(state: FleetState, *places: Place) -> str:
    found = nearest(state, places)
    return found.robot if found is not None else ""


def test_the_nearest_one_is_proposed_with_its_reason() -> None:
    found = nearest(state_of(3.0, 2.0, 4.0), [BASE])
    assert found is not None
    assert found.text == f"{R1}: idle, 2 m from Base, battery 71 %"


def test_the_metres_to_the_next_vertex_count() -> None:
    assert name(state_of(2.9, 2.2), BASE) == R1


@pytest.mark.parametrize(
    ("facts", "reason"),
    [
        ([queue(T0, (1, 1, 5, "W"), current=1)], "busy"),
        ([queue(T0, (1, 1, 5, "Q"))], "busy"),
        (commanded(1, place_order(R0, 1, 5), Stage.SENT), "busy"),
        ([CargoReported(R0, T0, True)], "with cargo on board"),
        ([battery(T0, LOW + BATTERY_MARGIN - 0.5)], "low on battery"),
        ([ModeReported(R0, T0, "mapping")], "mapping"),
        ([PausedReported(R0, T0, True)], "paused"),
        ([tick(T0 + 60)], "offline"),
    ],
)
def test_a_robot_that_is_not_idle_is_passed_over(facts: list[Event], reason: str) -> None:
    state = reduced(state_of(0.0), *facts)
    assert why_not(state, state.robots[R0]) == reason
    assert name(state, BASE) == ""
    assert why_none(state, [BASE]) == f"no idle robot can reach Base: 1 {reason}"


def test_an_order_that_waits_here_keeps_a_robot_busy() -> None:
    state = of_kinds(state_of(0.0), KEEPING)
    assert name(state, BASE) == R0
    assert name(reduced(state, *commanded(1, place_order(R0, 1, 5), Stage.WAITING)), BASE) == ""


def test_a_robot_with_an_alarm_that_holds_is_passed_over() -> None:
    state = state_of(0.0, 4.0)
    alarm = Alarm(Condition(R0, "data", Priority.LOW, Message("bad data"), Message("over")), 0.0, 0.0, T0)
    assert name(replace(state, alarms=(alarm,)), BASE) == R1
    assert name(replace(state, alarms=(replace(alarm, holds=False),)), BASE) == R0


def test_values_that_are_missing_or_old_are_not_trusted() -> None:
    state = state_of(0.0)
    robot = state.robots[R0]
    for field, reason in (
        ("battery", "without a battery report"),
        ("queue", "without a queue report"),
        ("pose", "without a pose"),
    ):
        lacking = replace(state, robots={R0: replace(robot, **{field: None})})
        assert why_not(lacking, lacking.robots[R0]) == reason


def test_a_kind_without_a_battery_passes_and_says_so() -> None:
    reports = tuple(one for one in FULL.reports if one != "battery")
    found = nearest(of_kinds(state_of(1.0), replace(FULL, reports=reports)), [BASE])
    assert found is not None and found.text.endswith("1 m from Base, battery unknown")


def test_a_kind_that_takes_no_order_with_a_start_is_never_proposed() -> None:
    state = of_kinds(state_of(1.0, 2.0), MUTE, FULL)
    assert name(state, BASE) == R1
    assert why_not(state, state.robots[R0]) == "of a kind without orders"
    assert ORDER in FULL.accepts


def test_a_label_is_meant_on_each_robots_own_graph() -> None:
    state = reduced(state_of(3.0, 0.0), labels({5: "Base", 1: "Store"}, robot=R1))
    found = nearest(state, [BASE, STORE])
    assert found is not None and found.robot == R0
    state = reduced(state, *idle(R0, 4.0), labels({5: "Base", 1: "Store"}, robot=R1), pose(T0, 3.0, robot=R1))
    found = nearest(state, [BASE, STORE])
    assert found is not None
    assert (found.robot, [place.vertex for place in found.places]) == (R1, ["5", "1"])


def test_the_order_itself_needs_a_way_too() -> None:
    one_way = RouteGraph(graph(1, 2, 3, 4, 5).graph.vertices, (Edge("0", "2", "1"),), directed=True)
    state = reduced(state_of(1.0, 4.0), GraphReceived(R0, F0, one_way))
    assert name(state, BASE) == R0
    assert name(state, BASE, STORE) == R1
    both = reduced(state, GraphReceived(R1, F0, one_way), pose(T0, 1.0, robot=R1))
    assert why_none(both, [BASE, STORE]) == "no idle robot can drive Base -> Store: 2 without a way"


def test_across_floors_only_a_lift_leads() -> None:
    def known(lift: Role) -> FleetState:
        row = graph(11, 12, floor=F1).graph
        joined = replace(row, vertices={**row.vertices, "11": replace(row.vertices["11"], role=lift)})
        ground = graph(1, 2, 3).graph
        below = replace(ground, vertices={**ground.vertices, "3": replace(ground.vertices["3"], role=lift)})
        ready = [*idle(R0, 0.0), GraphReceived(R0, F0, below), GraphReceived(R0, F1, joined)]
        return reduced(fleet(1, 2), link_up(T0), *ready, labels({12: "Attic"}, floor=F1), tick(T0))

    attic = Place("12", "Attic", F1)
    found = nearest(known(Role.ELEVATOR), [attic])
    assert found is not None and found.metres == 3.0
    assert nearest(known(Role.PLAIN), [attic]) is None
    stays = of_kinds(known(Role.ELEVATOR), replace(FULL, changes_floors=False))
    assert nearest(stays, [attic]) is None


def test_the_reasons_are_counted() -> None:
    state = reduced(
        state_of(0.0, 1.0, 2.0),
        queue(T0, (1, 1, 5, "W"), current=1),
        queue(T0, (1, 1, 5, "W"), current=1, robot=R1),
        PausedReported(R2, T0, True),
    )
    assert why_none(state, [BASE]) == "no idle robot can reach Base: 2 busy, 1 paused"


POINTS = st.integers(0, 9).map(lambda n: (n, n * n))
"""Never three on a line: no edge leads past a vertex that is not its end."""
BUSY = OrderQueue(1, "1", queue(T0, (1, 1, 2, "W")).queue.orders)


@given(
    st.lists(POINTS, min_size=2, max_size=6, unique=True),
    st.lists(st.tuples(st.integers(0, 5), st.integers(0, 5)), max_size=10),
    st.booleans(),
    st.lists(st.tuples(st.integers(0, 5), st.booleans()), min_size=1, max_size=4),
)
def test_the_proposed_robot_is_idle_and_no_idle_one_is_nearer(
    points: list[tuple[int, int]],
    joins: list[tuple[int, int]],
    directed: bool,
    robots: list[tuple[int, bool]],
) -> None:
    """Robots stand at vertices of any graph; every way is measured anew, edge by edge."""
    count = len(points)
    edges = [(a % count, b % count) for a, b in joins if a % count != b % count]
    vertices = {str(n): Vertex(str(n), float(x), float(y)) for n, (x, y) in enumerate(points)}
    routes = RouteGraph(
        vertices, tuple(Edge(str(n), str(a), str(b)) for n, (a, b) in enumerate(edges)), directed
    )
    metres = [[0.0 if a == b else math.inf for b in range(count)] for a in range(count)]
    for a, b in edges if directed else [*edges, *((b, a) for a, b in edges)]:
        metres[a][b] = math.dist(points[a], points[b])
    for via in range(count):
        for a in range(count):
            for b in range(count):
                metres[a][b] = min(metres[a][b], metres[a][via] + metres[via][b])
    state = reduced(fleet(len(robots)), link_up(T0))
    at = {f"robot_{n}": (place % count, is_busy) for n, (place, is_busy) in enumerate(robots)}
    on_graph = {vertex for edge in edges for vertex in edge}
    for robot, (place, is_busy) in at.items():
        x, y = points[place]
        state = reduced(
            state,
            *idle(robot, 0.0),
            GraphReceived(robot, F0, routes),
            labels({0: "Base"}, robot=robot),
            PoseReported(robot, T0, Pose(x, y), F0, None),
            QueueReported(robot, T0, BUSY if is_busy else OrderQueue(0, "", ())),
        )
    state = reduced(state, tick(T0))
    able = {
        robot: metres[place][0] for robot, (place, is_busy) in at.items() if not is_busy and place in on_graph
    }
    found = nearest(state, [Place("0", "Base", F0)])
    if found is not None and at[found.robot][0] in on_graph:
        assert not at[found.robot][1]
        assert found.metres == pytest.approx(metres[at[found.robot][0]][0])
        assert found.metres <= min(able.values()) + 1e-6
    elif found is None:
        assert not any(map(math.isfinite, able.values()))
