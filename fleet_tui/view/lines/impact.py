"""The orders whose way an edge is on, in words."""

from collections.abc import Iterator, Sequence

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.rules.alarms.trouble import in_trouble
from fleet_tui.rules.language.edges import edge_text
from fleet_tui.rules.routes.impact import CutOrder, closed_on_way, cut_orders, edge_under, is_in_the_way
from fleet_tui.rules.routes.order_draft import DraftRoute
from fleet_tui.rules.why.reason import mission
from fleet_tui.text.language import tr
from fleet_tui.text.limits import some
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import counted

MOST_EDGES = 3
"""Edges whose impact is listed."""
MOST_SHOWN, MOST_BESIDE = 8, 3
"""Orders that are listed alone, and beside reasons; the number of others follows."""


def impact_text(cut: Sequence[CutOrder]) -> str:
    """Return how many ways an edge cuts, and how many orders have no other."""
    if not cut:
        return tr("cuts the way of no order")
    lost = sum(one.around is None for one in cut)
    rest = tr(f", {lost} without a detour") if lost else tr(", with a detour")
    return tr(f"cuts the way of {counted(len(cut), 'order')}{rest}")


def draft_text(state: FleetState, robot: Robot, route: DraftRoute) -> str:
    """Return the length and time of an order that is being typed, and the closed edges on its way."""
    closed = closed_on_way(state.desk.closed, robot, route.lines)
    named = some([edge_text(robot, edge.ends) for edge in closed])
    return tr(sanitize(f"{route.text}; closed: {named}" if closed else route.text))


def why_impact(state: FleetState, robot: Robot) -> list[str]:
    """Return the orders whose way is cut by the edge that a blocked robot is on, and by closed ones, those of
    its floor first."""
    under = edge_under(robot) if is_in_the_way(state, robot, in_trouble(state)) else None
    edges = [(under, tr("Blocked edge"))] if under is not None else []
    closed = sorted(state.desk.closed, key=lambda edge: edge.ends[0] != robot.floor)
    edges += [
        (edge.ends, tr(f"Closed by {edge.by or tr('this console')}:"))
        for edge in closed
        if edge.ends != under
    ]
    lines = []
    for ends, what in edges[:MOST_EDGES]:
        cut = [one for one in cut_orders(state, ends) if ends != under or one.robot != robot.name]
        if ends == under and not cut:
            continue
        lines += ["", sanitize(f"{what} {edge_text(robot, ends)} {impact_text(cut)}")]
        lines += [f"    {line}" for line in impact_lines(state, cut, MOST_BESIDE)]
    return lines


def impact_lines(state: FleetState, cut: Sequence[CutOrder], most: int = MOST_SHOWN) -> Iterator[str]:
    """Yield each order whose way is cut, with its detour, the longest first after those without a way."""
    for one in sorted(cut, key=lambda found: -found.further)[:most]:
        told = mission(state.robots[one.robot], one.order)
        yield sanitize(f"{one.robot} {tr(told)}: {tr(one.text)}")
    if len(cut) > most:
        yield tr(f"and {len(cut) - most} more")
