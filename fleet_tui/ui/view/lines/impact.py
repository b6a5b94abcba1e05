"""The orders whose way an edge is on, in words."""

from collections.abc import Iterator, Sequence

from fleet_tui.commands.language.edges import edge_text
from fleet_tui.commands.routes.blocked import blocked_edge
from fleet_tui.commands.routes.impact import CutOrder, closed_on_way, cut_orders
from fleet_tui.commands.routes.order_draft import DraftRoute
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.why.reason import mission
from fleet_tui.text.language import Message, counted, tr, translate
from fleet_tui.text.limits import some
from fleet_tui.text.sanitize import sanitize

MOST_EDGES = 3
"""Edges whose impact is listed."""
MOST_SHOWN = 8
MOST_BESIDE = 3
"""Orders that are listed alone, and beside reasons; the number of others follows."""


def impact_text(cut: Sequence[CutOrder], may: bool = False) -> Message:
    """Return how many ways an edge cuts, or may cut, and how many orders have no other."""
    if not cut:
        return Message("cuts the way of no order")
    lost = sum(one.around is None for one in cut)
    rest = Message(", {lost} without a detour", lost=lost) if lost else Message(", with a detour")
    count = len(cut)
    if may:
        return counted(
            "may cut the way of {count} order{rest}",
            "may cut the way of {count} orders{rest}",
            count,
            rest=rest,
        )
    return counted(
        "cuts the way of {count} order{rest}", "cuts the way of {count} orders{rest}", count, rest=rest
    )


def draft_text(state: FleetState, robot: Robot, route: DraftRoute) -> str:
    """Return the length and time of an order that is being typed, and the closed edges on its way; of one
    that is not possible why."""
    floors = {*route.lines, robot.floor} - {None}
    if not robot.kind.changes_floors and (route.by_lift or len(floors) > 1):
        return tr(
            "an order can't change floors: {name} is on {floor}",
            name=robot.name,
            floor=sanitize(robot.floor or "-"),
        )
    closed = closed_on_way(state.desk.closed, robot, route.lines)
    named = some([edge_text(robot, edge.ends) for edge in closed])
    return translate(
        sanitize(Message("{text}; closed: {named}", text=route.text, named=named) if closed else route.text)
    )


def why_impact(state: FleetState, robot: Robot) -> list[str]:
    """Return the orders whose way may be cut where a robot is held up, and those of closed edges, the ones of
    its floor first."""
    lines = []
    held_up = blocked_edge(state, robot.name)
    if held_up is not None:
        others = [one for one in cut_orders(state, held_up) if one.robot != robot.name]
        if others:
            edge, what = edge_text(robot, held_up), tr("Blocked edge")
            lines += ["", sanitize(f"{what} {edge} {translate(impact_text(others, may=True))}")]
            lines += [f"    {line}" for line in impact_lines(state, others, MOST_BESIDE)]
    closed = [edge for edge in state.desk.closed if edge.ends != held_up]
    for one in sorted(closed, key=lambda edge: edge.ends[0] != robot.floor)[: MOST_EDGES - bool(lines)]:
        cut, by = cut_orders(state, one.ends), tr("Closed by {by}:", by=one.by or tr("this console"))
        lines += ["", sanitize(f"{by} {edge_text(robot, one.ends)} {translate(impact_text(cut))}")]
        lines += [f"    {line}" for line in impact_lines(state, cut, MOST_BESIDE)]
    return lines


def impact_lines(state: FleetState, cut: Sequence[CutOrder], most: int = MOST_SHOWN) -> Iterator[str]:
    """Yield each order whose way is cut, with its detour, the longest first after those without a way."""
    for one in sorted(cut, key=lambda found: -found.further)[:most]:
        told = mission(state.robots[one.robot], one.order)
        yield sanitize(f"{one.robot} {translate(told)}: {translate(one.text)}")
    if len(cut) > most:
        yield tr("and {count} more", count=len(cut) - most)
