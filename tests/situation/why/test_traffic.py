"""Robots in the way of others: who holds whom up."""

from msgspec import structs

from fleet_tui.model.events import (
    Event,
    FrameReceived,
    GraphReceived,
    ObstacleReported,
    PoseReported,
    QueueReported,
)
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.kind import Kind
from fleet_tui.model.order import Order, at_vertices
from fleet_tui.situation.alarms.trouble import to_look_at
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import (
    R0,
    T0,
    fleet,
    graph,
    link_up,
    of_kinds,
    order_queue,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.situations import behind_another, first


def test_a_robot_behind_another_one_is_told_how_far_that_is() -> None:
    found = first(behind_another().run(4))
    assert found.evidence.startswith("robot_1 is 2.")
    assert found.keys == ("robot_1",)


def test_robots_in_different_frames_are_not_compared() -> None:
    """The other's map lies elsewhere: its numbers mean another place."""
    planted = behind_another()
    frame = planted.state.robots["robot_1"].maps["floor_0"].frame
    assert frame is not None
    moved = structs.replace(frame, origin=Pose(frame.origin.x + 5.0, frame.origin.y))
    planted.run(3)
    assert first(planted).name == "waiting behind robot_1"
    planted.tell(FrameReceived("robot_1", "floor_0", moved))
    assert first(planted).name == "waiting 3 s, nothing wrong so far"


def test_a_robot_that_drives_through_is_not_the_cause_of_a_long_standstill() -> None:
    here: list[Event] = [link_up(T0), graph(1, 2, 3), queue(T0, (1, 3, 1, "W"), current=1)]
    state = reduced(fleet(2), *here)
    for second in range(30):
        at = T0 + second
        other = PoseReported("robot_1", at, Pose(1.5 + max(0, 25 - second), 0.0), "floor_0", None)
        state = reduced(state, pose(at, x=0.2), other, queue(at, (1, 3, 1, "W"), current=1), tick(at))
    names = [reason.name for reason in reasons(state, state.robots[R0])]
    assert names and "waiting behind robot_1" not in names


def test_a_robot_beside_or_behind_is_not_in_the_way() -> None:
    here: list[Event] = [link_up(T0), graph(1, 2, 3), pose(T0, x=0.2), queue(T0, (1, 3, 1, "W"), current=1)]
    for x, y, waits in [(1.5, 0.0, True), (1.5, 1.2, False), (-0.5, 0.0, False), (1.5, 0.5, True)]:
        state = reduced(
            fleet(2), *here, PoseReported("robot_1", T0, Pose(x, y), "floor_0", None), tick(T0 + 2)
        )
        names = [reason.name for reason in reasons(state, state.robots[R0])]
        assert ("waiting behind robot_1" in names) is waits, (x, y)


def test_a_robot_a_hairs_breadth_before_its_vertex_has_reasons_as_any_other() -> None:
    here: list[Event] = [
        link_up(T0),
        graph(1, 2, 3),
        pose(T0, x=1e-200),
        queue(T0, (0, 1, 0, "W"), current=0),
    ]
    other = PoseReported("robot_1", T0, Pose(0.0, 0.0), "floor_0", None)
    state = reduced(fleet(2), *here, other, tick(T0 + 2))
    assert reasons(state, state.robots[R0])


def test_only_a_near_robot_or_one_under_way_on_the_next_edge_is_in_the_way() -> None:
    vertices = {id_: Vertex(id_, x, 0.0) for id_, x in (("1", 0.0), ("2", 16.0))}
    edge = GraphReceived(R0, "floor_0", RouteGraph(vertices, (Edge("0", "1", "2"),)))

    bound_for_2 = QueueReported(R0, T0, order_queue(1, 1, Order("1", at_vertices("2"), None, "", 1)))

    def found(x: float, *, drives: bool, keeps_goals: bool = False) -> list[str]:
        state = of_kinds(fleet(2), *(Kind("one", ("pose", "queue"), keeps_goals=keeps_goals),) * 2)
        here: list[Event] = [link_up(T0), edge, pose(T0), bound_for_2]
        there: list[Event] = [PoseReported("robot_1", T0, Pose(x, 0.0), "floor_0", None)]
        if drives:
            there.append(queue(T0, (2, 2, 1, "W"), current=2, robot="robot_1"))
        state = reduced(state, *here, *there, tick(T0 + 2))
        return [f"{one.name} {one.strength.name}" for one in reasons(state, state.robots[R0])]

    assert found(8.0, drives=True)[0] == "waiting behind robot_1 LIKELY"
    unknown = "waiting 0 s, nothing wrong so far NONE"
    assert found(8.0, drives=False)[0] == found(8.0, drives=True, keeps_goals=True)[0] == unknown
    assert found(3.0, drives=False) == ["waiting behind robot_1 POSSIBLE", unknown]


def test_a_robot_with_an_order_and_a_pose_beside_all_edges_is_said_to_be_off_the_graph() -> None:
    """It drives: its localisation is wrong, not its way."""
    drives: list[Event] = [link_up(T0 - 9), graph(1, 2, 3), pose(T0 - 0.5, 1.0, 2.5), pose(T0, 1.4, 2.6)]
    busy = reduced(fleet(), *drives, queue(T0, (1, 3, 1, "W"), current=1), tick(T0))
    found = reasons(busy, busy.robots[R0])[0]
    assert found.name == "pose doubtful: 2.6 m off the route graph" and found.keys[0] == "pause"
    later = reduced(busy, pose(T0 + 1, 1.8, 2.6), tick(T0 + 1))  # poses are compared with it once a second
    assert to_look_at(later) == (R0,)
    assert "pose doubtful" in [text for text, _ in news(later, later.robots[R0])]
    left = reduced(later, pose(T0 + 6, 1.9, 0.5), tick(T0 + 6))
    assert reasons(left, left.robots[R0])[0].name == "pose doubtful: off the route graph 5 s ago"
    idle = reduced(fleet(), *drives, queue(T0), tick(T0))
    near = reduced(busy, pose(T0 + 0.1, 1.4, 1.9), tick(T0 + 0.1))
    for state in (idle, near):
        assert reasons(state, state.robots[R0])[0].name == "robot_0 is driving"


def test_a_pose_that_was_wrong_for_long_comes_before_an_obstacle_of_a_moment() -> None:
    state = reduced(fleet(), link_up(T0), graph(1, 2, 3), queue(T0, (1, 3, 1, "W"), current=1), tick(T0))
    for second in range(24):
        at = T0 + second
        state = reduced(
            state, pose(at, 1.4 + 0.1 * second, 2.6), queue(at, (1, 3, 1, "W"), current=1), tick(at)
        )
    state = reduced(state, ObstacleReported(R0, T0 + 23, 4.0), tick(T0 + 23.1))
    found = [(one.name, one.strength.name) for one in reasons(state, state.robots[R0])]
    assert [name.split()[0] for name, _ in found[:2]] == ["pose", "obstacle"]
    assert found[0][1] == "CERTAIN"
