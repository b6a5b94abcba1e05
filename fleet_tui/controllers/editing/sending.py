"""Sends the draft of a graph to the selected robot, after its errors, warnings and differences are known."""

from collections.abc import Callable
from pathlib import Path

from fleet_tui.controllers.editing.checks import DraftChecks, counts_text
from fleet_tui.controllers.editing.editor import GraphEditor, live_floor
from fleet_tui.controllers.parts import SetUpParts
from fleet_tui.controllers.typed import Entry
from fleet_tui.errors import GraphError
from fleet_tui.graph_files.graph_file import WriteChoices
from fleet_tui.graph_files.writing import write_graph
from fleet_tui.maps.graph_versions import keep_version
from fleet_tui.model.graphs.document import DocumentFloor, GraphFormat, of_floor
from fleet_tui.model.graphs.live import roles_of, route_graph
from fleet_tui.model.kind import GRAPH
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.commands import SendGraph
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import counted


class DraftSending:
    """Errors stop it, warnings are shown. The robot's present graph is kept in `folder` first, the last 20 of
    each robot and floor."""

    def __init__(
        self,
        parts: SetUpParts,
        editor: GraphEditor,
        checks: DraftChecks,
        folder: Callable[[], Path | None],
    ) -> None:
        self._parts, self._editor, self._checks, self._folder = parts, editor, checks, folder

    def start(self) -> None:
        """Offer to send, with the number of warnings and differences."""
        opened, parts = self._editor.opened, self._parts
        if opened is None:
            return
        floor, robot = opened[0].floor, parts.store.state.robots[parts.navigation.robot]
        refusal = parts.dispatch.set_up_refusal()
        if not refusal and not robot.kind.can(GRAPH):
            refusal = robot.kind.lack(GRAPH)
        if not refusal and floor.name not in robot.maps:
            refusal = f"{robot.name} does not drive on {floor.name}"
        if refusal:
            parts.notices.say(sanitize(refusal))
            return
        if (checked := self._checks.of(floor)) is None:
            return
        if any(one.is_error for one in checked.found):
            parts.notices.say(f"not sent: {counts_text(checked.found)}: ! lists them")
            return
        count = len(self._checks.changes(floor))
        told = [f"{counted(count, 'difference')} from the live graph", counts_text(checked.found)]
        entries: list[Entry] = [
            (f"Send to {robot.name} (asks)", self._send),
            ("Show the differences", self._checks.compare),
            ("Show the findings", self._checks.show_findings),
        ]
        parts.open_menu(", ".join(filter(None, told)), entries)

    def _send(self) -> None:
        opened, parts = self._editor.opened, self._parts
        if opened is None:
            return
        floor, robot = opened[0].floor, parts.navigation.robot
        if problem := self._keep(robot):
            parts.notices.say(f"not sent: the present graph can't be kept: {sanitize(problem)}")
            return
        graph, labels = route_graph(floor, roles_of(self._editor.live_graph()))
        vertices, pairs = tuple(graph.vertices.values()), tuple(sorted(labels.items()))
        command = SendGraph(robot, floor.name, vertices, graph.edges, graph.directed, pairs)
        parts.dispatch.do(Request((command,)))

    def _keep(self, robot: str) -> str:
        """Write the robot's present graph to a file. Returns the reason if it can't be."""
        live: DocumentFloor = live_floor(self._parts.store.state, self._parts.navigation.selection)
        folder = self._folder()
        if folder is None or not live.vertices:
            return ""
        try:
            keep_version(
                folder, robot, live.name, write_graph(of_floor(live), GraphFormat.NATIVE, WriteChoices())
            )
        except (OSError, GraphError) as problem:
            return str(problem)
        return ""
