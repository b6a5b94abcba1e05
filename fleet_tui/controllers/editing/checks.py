"""Checks of a draft while it is drawn: lint, reach, and the difference from the live graph."""

import logging
from collections.abc import Callable
from functools import partial
from typing import Any

from fleet_tui.controllers.editing.editor import EditorParts, GraphEditor, live_floor
from fleet_tui.controllers.typed import Entry
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Role
from fleet_tui.model.graphs.document import DocumentFloor, GraphFormat, of_floor
from fleet_tui.model.graphs.live import roles_of, route_graph
from fleet_tui.model.order import vertices_of
from fleet_tui.rules.graphs.difference import GraphChange, difference
from fleet_tui.rules.graphs.finding import GraphFinding, LintInputs
from fleet_tui.rules.graphs.lint import lint
from fleet_tui.rules.graphs.reach import longest_detour
from fleet_tui.text.sanitize import sanitize

InBackground = Callable[[Callable[[], Any], Callable[[Any], None]], None]
"""Does work in a thread, then calls with its result."""
LOG = logging.getLogger(__name__)
LISTED = 200
"""Lines of a list of findings or differences."""


class DraftChecks:
    """Checks the draft after each step, one check at a time and off the loop; the counts are in the
    banner."""

    def __init__(self, parts: EditorParts, editor: GraphEditor, in_background: InBackground) -> None:
        self._parts, self._editor, self._in_background = parts, editor, in_background
        self._checked: DocumentFloor | None = None
        self._is_busy = False
        self.found: tuple[GraphFinding, ...] = ()
        editor.changed = self._check

    def _check(self, floor: DocumentFloor | None) -> None:
        is_other = floor is None or self._checked is None or self._checked.name != floor.name
        self._checked = floor
        if is_other:
            self.found = ()
        if floor is None or self._is_busy:
            return
        self._is_busy = True
        self._in_background(partial(_linted, floor, self.inputs(floor)), partial(self._take, floor))

    def _take(self, floor: DocumentFloor, found: tuple[GraphFinding, ...]) -> None:
        self._is_busy = False
        mode = self._editor.mode
        if self._checked is None or mode is None:
            return
        if self._checked is not floor:
            self._check(self._checked)
            return
        self.found = found
        mode.note = counts_text(found)
        self._editor.refresh()

    def inputs(self, floor: DocumentFloor, target: GraphFormat | None = None) -> LintInputs:
        """Return all that is known beside a draft."""
        state, scene = self._parts.store.state, self._editor.picture.scene
        robot, live = state.robots[self._parts.navigation.robot], self._editor.live_graph()
        return LintInputs(
            grid=scene.grid if scene is not None and scene.floor == floor.name else None,
            width=robot.size[1] if robot.size else LintInputs().width,
            elsewhere=_elevators(state, floor.name),
            live=live,
            ordered=_ordered(state, floor.name),
            target=target,
            roles=roles_of(live),
        )

    def show_findings(self) -> None:
        """List the findings with the reach of the labels; each entry goes to its place."""
        opened = self._editor.opened
        if opened is None:
            return
        floor = opened[0].floor
        graph, labels = route_graph(floor, roles_of(self._editor.live_graph()))
        lost = sum(finding.rule == "reach" for finding in self.found)
        told = [
            counts_text(self.found) or "no findings",
            f"{len(labels) - lost} of {len(labels)} labels reachable",
        ]
        if (detour := longest_detour(graph, labels)) is not None:
            start, end = (sanitize(labels[id_]) for id_ in (detour.start, detour.end))
            told.append(f"longest detour {start} -> {end}: {detour.metres:.0f} m for {detour.straight:.0f} m")
        entries: list[Entry] = [
            (sanitize(f"{'error' if one.is_error else 'warning'}: {one.text}"), partial(self._go_to, one))
            for one in self.found[:LISTED]
        ]
        self._parts.open_menu(", ".join(told), entries or [("Nothing to mend", lambda: None)])

    def compare(self) -> None:
        """List the differences from the live graph; each entry goes to its place."""
        opened = self._editor.opened
        if opened is None:
            return
        changes = self.changes(opened[0].floor)
        entries: list[Entry] = [
            (sanitize(f"{one.kind} {one.text}"), partial(self._go_to_change, one)) for one in changes[:LISTED]
        ]
        title = f"{len(changes)} difference{'s' * (len(changes) != 1)} from the live graph"
        self._parts.open_menu(title, entries or [("The draft is the live graph", lambda: None)])

    def changes(self, floor: DocumentFloor) -> tuple[GraphChange, ...]:
        """Return the differences of a draft from the live graph."""
        live = live_floor(self._parts.store.state, self._parts.navigation.selection)
        return difference(live, floor)

    def _go_to_change(self, change: GraphChange) -> None:
        self._reveal(change.vertex, change.edge)

    def _go_to(self, finding: GraphFinding) -> None:
        self._reveal((*finding.vertices, "")[0], (*finding.edges, "")[0])

    def _reveal(self, vertex: str, edge: str) -> None:
        """Put the cursor on a vertex or the start of an edge, and select it."""
        opened = self._editor.opened
        if opened is None:
            return
        draft, mode, _ = opened
        mode.edge = edge if edge in draft.floor.edges else ""
        start = draft.floor.edges[mode.edge].start if mode.edge else vertex
        at = draft.floor.vertices.get(start)
        if at is None:
            self._parts.notices.say("it is not in the draft any more")
            return
        mode.selected, mode.cursor = "" if mode.edge else start, (at.x, at.y)
        self._parts.navigation.find_vertex(draft.floor.name, at.x, at.y)
        self._editor.refresh()


def _linted(floor: DocumentFloor, inputs: LintInputs) -> tuple[GraphFinding, ...]:
    """Check a floor; a fault of the check itself is a finding, too."""
    try:
        return lint(of_floor(floor), inputs)
    except Exception:  # it must not end the checks for good
        LOG.exception("check of a draft")
        return (GraphFinding("check", "the check itself failed: see the log", True),)


def counts_text(found: tuple[GraphFinding, ...]) -> str:
    """Return the numbers of errors and warnings, empty without any."""
    errors = sum(one.is_error for one in found)
    counts = ((errors, "error"), (len(found) - errors, "warning"))
    return ", ".join(f"{count} {name}{'s' * (count != 1)}" for count, name in counts if count)


def _elevators(state: FleetState, floor: str) -> frozenset[str] | None:
    """Return the labels of elevators on other floors, None if there are no others."""
    others = [name for name in state.floors if name != floor]
    if not others:
        return None
    found = set[str]()
    for robot in state.robots.values():
        for name in others:
            robot_map = robot.maps.get(name)
            graph = robot_map.graph if robot_map is not None else None
            if robot_map is not None and graph is not None:
                lifts = [id_ for id_, one in graph.vertices.items() if one.role is Role.ELEVATOR]
                found.update(robot_map.labels.get(id_, "") for id_ in lifts)
    return frozenset(found - {""})


def _ordered(state: FleetState, floor: str) -> dict[str, str]:
    """Return the orders that robots of a floor have, by the vertices they name."""
    return {
        vertex: f"order {order.id} of {robot.name}"
        for robot in state.robots.values()
        if robot.floor == floor
        for order in robot.orders.open
        for vertex in vertices_of(order.stops)
    }
