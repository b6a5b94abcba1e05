"""Parts of a reason: since when a robot stands, names of vertices, orders in words."""

from msgspec.structs import replace

from fleet_tui.situation.why.reason import mission, name_of, stationary_since
from tests.support.fleets import R0, T0, fleet, graph, labels, order, pose, reduced

STATE = reduced(fleet(), graph(1, 2), labels({1: "Base"}), pose(T0, 1.0), pose(T0 + 5, 1.0))


def test_it_stands_since_its_pose_is_the_same() -> None:
    assert stationary_since(STATE.robots[R0]) == T0
    assert stationary_since(reduced(STATE, pose(T0 + 6, 4.0)).robots[R0]) == T0 + 6
    assert stationary_since(fleet().robots[R0]) is None


def test_an_order_is_named_by_its_label_or_its_stops_and_an_unknown_vertex_is_marked() -> None:
    robot = STATE.robots[R0]
    assert [name_of(robot, id_) for id_ in ("1", "2", "3")] == ["Base", "2", "3?"]
    given = order(7, 1, 3, "W")
    assert mission(robot, given) == "order 7, Base -> 3?"
    assert mission(robot, replace(given, label="to the dock")) == "order 7, to the dock"
