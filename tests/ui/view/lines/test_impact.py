"""The orders whose way is cut, in words."""

from msgspec.structs import replace

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.routes.impact import cut_orders
from fleet_tui.commands.routes.order_draft import Draft, DraftRoute, draft_route
from fleet_tui.model.desk.desk import ends_of
from fleet_tui.model.desk.events import DeskJoined, EdgeClosed
from fleet_tui.model.events import ObstacleReported
from fleet_tui.ui.view.lines.impact import draft_text, impact_lines, impact_text, why_impact
from tests.support.fleets import F0, R0, T0, labels, pose, queue, reduced
from tests.support.street import fleet_with

BLOCKED = ObstacleReported(R0, T0, 40.0)


def test_a_blocked_robot_names_the_orders_behind_it_with_their_detours() -> None:
    state = fleet_with(
        pose(T0, 14.0, 0.0),
        BLOCKED,
        labels({2: "Hall", 3: "Dock"}),
        pose(T0, 0.0, 0.0, robot="robot_1"),
        queue(T0, (7, 1, 5, "W"), current=7, robot="robot_1"),
    )
    assert why_impact(state, state.robots[R0]) == [
        "",
        "Blocked edge Hall - Dock may cut the way of 1 order, with a detour",
        "    robot_1 order 7, 1 -> 5: detour +6 m (36 m)",
    ]


def test_closed_edges_come_with_who_closed_them_and_orders_without_a_way_first() -> None:
    state = fleet_with(
        pose(T0, 0.0, 0.0),
        queue(T0, (1, 1, 3, "W"), (2, 3, 5, "W"), current=1),
        DeskJoined("ana"),
        EdgeClosed(ends_of(F0, "3", "5"), 0.0),
    )
    assert why_impact(state, state.robots[R0]) == [
        "",
        "Closed by ana: 3 - 5 cuts the way of 1 order, 1 without a detour",
        "    robot_0 order 2, 3 -> 5: no way",
    ]


def test_nothing_blocked_nothing_told_and_many_are_counted() -> None:
    state = fleet_with(pose(T0, 14.0, 0.0))
    assert why_impact(state, state.robots[R0]) == []
    assert impact_text([]) == "cuts the way of no order"
    orders = [(n, 2 + n % 2, 3 - n % 2, "W") for n in range(1, 14)]
    many = reduced(state, queue(T0, *orders, current=1))
    lines = list(impact_lines(many, cut_orders(many, ends_of(F0, "2", "3"))))
    assert len(lines) == 9 and lines[-1] == "and 5 more"


def test_an_order_that_is_typed_names_the_closed_edges_on_its_way() -> None:
    state = fleet_with(pose(T0, 0.0, 0.0), labels({2: "Hall"}), EdgeClosed(ends_of(F0, "3", "2"), 0.0))
    robot = state.robots[R0]
    for ends, expected in (
        (("1", "5"), "; closed: Hall - 3"),
        (("5", "1"), "; closed: Hall - 3"),
        (("1", "2"), ""),
    ):
        draft = Draft(R0, tuple(Place(one, one, F0) for one in ends))
        route = draft_route(robot, draft)
        assert route is not None
        assert draft_text(state, robot, route) == route.text + expected


def test_an_order_to_another_floor_says_while_typed_that_it_is_not_possible() -> None:
    state = fleet_with(pose(T0, 0.0, 0.0))
    robot = state.robots[R0]
    fixed = replace(robot, kind=replace(robot.kind, changes_floors=False))
    told = f"an order can't change floors: {R0} is on {F0}"
    for by_lift, lines in ((True, {F0: ()}), (False, {"floor_1": ()})):
        route = DraftRoute(lines, 40.0, by_lift)
        assert draft_text(state, fixed, route) == told
        assert draft_text(state, robot, route) == route.text
    assert draft_text(state, fixed, DraftRoute({F0: ()}, 40.0)).startswith("40 m")
