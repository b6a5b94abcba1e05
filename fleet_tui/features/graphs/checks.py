"""Checks of a draft while it is drawn: lint, reach, and the difference from the live graph."""

import logging
from functools import partial
from typing import NamedTuple

from fleet_tui.features.graphs.editor import GraphEditor, live_floor
from fleet_tui.features.graphs.rules.difference import GraphChange, difference
from fleet_tui.features.graphs.rules.finding import GraphFinding, LintInputs
from fleet_tui.features.graphs.rules.lint import lint
from fleet_tui.features.graphs.rules.reach import longest_detour
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Role
from fleet_tui.model.graphs.document import DocumentFloor, of_floor
from fleet_tui.model.graphs.live import roles_of, route_graph
from fleet_tui.model.order import vertices_of
from fleet_tui.text.language import Message, counted, joined
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Entry

LOG = logging.getLogger(__name__)
LISTED = 200
"""Lines of a list of findings or differences."""


class Checked(NamedTuple):
    """The check of a draft: its findings, and the ways between its labels in words."""

    floor: DocumentFloor
    found: tuple[GraphFinding, ...]
    ways: Message


class DraftChecks:
    """Checks the draft after each step, one check at a time and off the loop; the counts are in the
    banner."""

    def __init__(self, console: Console, editor: GraphEditor) -> None:
        self._console = console
        self._editor = editor
        self._in_background = console.in_background
        self._newest: DocumentFloor | None = None
        self._last: Checked | None = None
        self._is_busy = False
        editor.changed = self._check

    def _check(self, floor: DocumentFloor | None) -> None:
        self._newest = floor
        if floor is None or self._is_busy:
            return
        self._is_busy = True
        self._in_background(partial(_checked, floor, self.inputs(floor)), self._take)

    def _take(self, checked: Checked) -> None:
        self._is_busy = False
        mode = self._editor.mode
        if mode is None or self._newest is not checked.floor:
            self._check(self._newest)
            return
        self._last = checked
        mode.note = short_counts(checked.found)
        self._editor.refresh()

    def of(self, floor: DocumentFloor) -> Checked | None:
        """Return the check of a draft, None while it is under way; say so."""
        if self._last is not None and self._last.floor is floor:
            return self._last
        self._console.notices.say(Message("the draft is being checked: press again"))
        return None

    def inputs(self, floor: DocumentFloor) -> LintInputs:
        """Return all that is known beside a draft."""
        state, scene = self._console.store.state, self._editor.picture.scene
        robot, live = state.robots[self._console.navigation.robot], self._editor.live_graph()
        return LintInputs(
            grid=scene.grid if scene is not None and scene.floor == floor.name else None,
            width=robot.size[1] if robot.size else LintInputs().width,
            elsewhere=_elevators(state, floor.name),
            live=live,
            ordered=_ordered(state, floor.name),
            roles=roles_of(live),
        )

    def show_findings(self) -> None:
        """List the findings with the reach of the labels; each entry goes to its place."""
        opened = self._editor.opened
        if opened is None or (checked := self.of(opened[0].floor)) is None:
            return
        entries: list[Entry] = [
            (
                Message(
                    "{kind}: {text}",
                    kind=Message("error") if one.is_error else Message("warning"),
                    text=sanitize(one.text),
                ),
                partial(self._go_to, one),
            )
            for one in checked.found[:LISTED]
        ]
        title = Message(
            "{counts_text}, {ways}",
            counts_text=counts_text(checked.found) or Message("no findings"),
            ways=checked.ways,
        )
        self._console.open_menu(title, entries or [(Message("Nothing to fix"), lambda: None)], searched=True)

    def compare(self) -> None:
        """List the differences from the live graph; each entry goes to its place."""
        opened = self._editor.opened
        if opened is None:
            return
        changes = self.changes(opened[0].floor)
        entries: list[Entry] = [
            (
                Message("{kind} {text}", kind=Message(one.kind), text=sanitize(one.text)),
                partial(self._go_to_change, one),
            )
            for one in changes[:LISTED]
        ]
        title = counted(
            "{count} difference from the live graph", "{count} differences from the live graph", len(changes)
        )
        self._console.open_menu(
            title, entries or [(Message("The draft is the live graph"), lambda: None)], searched=True
        )

    def changes(self, floor: DocumentFloor) -> tuple[GraphChange, ...]:
        """Return the differences of a draft from the live graph."""
        live = live_floor(self._console.store.state, self._console.navigation.selection)
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
            self._console.notices.say(Message("no longer in the draft"))
            return
        mode.selected = "" if mode.edge else start
        mode.cursor = (at.x, at.y)
        self._console.navigation.find_vertex(draft.floor.name, at.x, at.y)
        self._editor.refresh()


def _checked(floor: DocumentFloor, inputs: LintInputs) -> Checked:
    """Check a floor; a fault of the check itself is a finding, too."""
    try:
        found = lint(of_floor(floor), inputs)
        return Checked(floor, found, _ways(floor, inputs, found))
    except Exception:  # it must not end the checks for good
        LOG.exception("check of a draft")
        failed = GraphFinding("check", Message("the check itself failed: see the log"), True)
        return Checked(floor, (failed,), Message("ways not checked"))


def _ways(floor: DocumentFloor, inputs: LintInputs, found: tuple[GraphFinding, ...]) -> Message:
    """Return the number of reachable labels, and the longest detour between two."""
    graph, labels = route_graph(floor, inputs.roles)
    lost = sum(finding.rule == "reach" for finding in found)
    text = Message(
        "{reachable} of {labels} reachable",
        reachable=len(labels) - lost,
        labels=counted("{count} label", "{count} labels", len(labels)),
    )
    if (detour := longest_detour(graph, labels)) is None:
        return text
    start, end = (sanitize(labels[id_]) for id_ in (detour.start, detour.end))
    return Message(
        "{text}, longest detour {start} -> {end}: {metres} m for {straight} m",
        text=text,
        start=start,
        end=end,
        metres=f"{detour.metres:.0f}",
        straight=f"{detour.straight:.0f}",
    )


def short_counts(found: tuple[GraphFinding, ...]) -> Message:
    """Return the numbers of errors and warnings for the map's title, empty without any: `1E 2W`."""
    errors = sum(one.is_error for one in found)
    counts = ((errors, "E"), (len(found) - errors, "W"))
    return joined(" ", (f"{count}{letter}" for count, letter in counts if count))


def counts_text(found: tuple[GraphFinding, ...]) -> Message:
    """Return the numbers of errors and warnings, empty without any."""
    errors = sum(one.is_error for one in found)
    warnings = len(found) - errors
    counts = (
        counted("{count} error", "{count} errors", errors) if errors else "",
        counted("{count} warning", "{count} warnings", warnings) if warnings else "",
    )
    return joined(", ", filter(None, counts))


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
        vertex: Message("order {id} of {name}", id=order.id, name=robot.name)
        for robot in state.robots.values()
        if robot.floor == floor
        for order in robot.orders.open
        for vertex in vertices_of(order.stops)
    }
