"""The findings of lint, and what it needs to know beside the graph."""

from collections.abc import Callable, Mapping, Set

from msgspec import Struct

from fleet_tui.model.graph import Role, RouteGraph
from fleet_tui.model.graphs.document import GraphFormat
from fleet_tui.model.graphs.live import role_of
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.text.language import Message

MOST = 200
"""Maximum findings of one rule on one floor; the last one has the number of the others."""


class GraphFinding(Struct, frozen=True):
    """One finding. Errors stop sending and writing, warnings ask. vertices, edges: the ids concerned."""

    rule: str
    text: Message
    is_error: bool
    floor: str = ""
    vertices: tuple[str, ...] = ()
    edges: tuple[str, ...] = ()


class LintInputs(Struct, frozen=True):
    """Facts beside the graph; a rule without its facts is silent. width: of the robot in metres; types: known
    to the profile; elsewhere: labels of elevators on other floors, None if unknown; live: the robots' graph;
    ordered: orders waiting or in process, by the vertex they name."""

    grid: OccupancyGrid | None = None
    width: float = 0.6
    types: Set[str] | None = None
    elsewhere: Set[str] | None = None
    live: RouteGraph | None = None
    ordered: Mapping[str, str] = {}
    target: GraphFormat | None = None
    vehicle_type: str = ""
    roles: Callable[[str], Role] = role_of


def limited(findings: list[GraphFinding]) -> list[GraphFinding]:
    """Return the findings of one rule, at most a screenful or two of them."""
    if len(findings) <= MOST:
        return findings
    more = GraphFinding(
        findings[0].rule, Message("and {count} more", count=len(findings) - MOST), findings[0].is_error
    )
    return [*findings[:MOST], more]
