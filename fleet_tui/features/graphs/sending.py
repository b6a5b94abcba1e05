"""Sends the draft of a graph to the selected robot, after its errors, warnings and differences are known."""

from functools import partial

from fleet_tui.features.graphs.checks import DraftChecks, counts_text
from fleet_tui.features.graphs.editor import GraphEditor, live_floor
from fleet_tui.features.graphs.route_files import RouteFile, RouteFiles
from fleet_tui.maps.formats.graph_file import WriteChoices
from fleet_tui.maps.formats.writing import write_graph
from fleet_tui.maps.graph_versions import keep_version
from fleet_tui.model.graphs.document import DocumentFloor, GraphFormat, of_floor
from fleet_tui.model.graphs.live import roles_of, route_graph
from fleet_tui.model.kind import GRAPH
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SendGraph
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import EMPTY, Message, counted, joined, message_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Entry


class DraftSending:
    """Errors stop it, warnings are shown. The robot's present graph is kept in the folder of `files` first,
    the last 20 of each robot and floor. A robot that loads a file gets one before the call."""

    def __init__(
        self, console: Console, editor: GraphEditor, checks: DraftChecks, route_files: RouteFiles
    ) -> None:
        self._console = console
        self._editor = editor
        self._checks = checks
        self._files = console.files
        self._route_files = route_files

    def start(self) -> None:
        """Offer to send, with the number of warnings and differences."""
        opened, console = self._editor.opened, self._console
        if opened is None:
            return
        floor, robot = opened[0].floor, console.store.state.robots[console.navigation.robot]
        doubt, refusal = console.settings.doubt, console.dispatch.set_up_refusal()
        if not refusal and doubt:
            refusal = Message("not sent: {problem}", problem=doubt)
        if not refusal and not robot.kind.can(GRAPH):
            refusal = robot.kind.lack(GRAPH)
        if not refusal and floor.name not in robot.maps:
            refusal = Message("{name} does not drive on {floor}", name=robot.name, floor=floor.name)
        if not refusal and robot.kind.loads_graphs:
            refusal = self._route_files.refusal(floor.name)
        if refusal:
            console.notices.say(sanitize(refusal))
            return
        if (checked := self._checks.of(floor)) is None:
            return
        if any(one.is_error for one in checked.found):
            console.notices.say(
                Message("not sent: {counts_text}: ! lists them", counts_text=counts_text(checked.found))
            )
            return
        self._offer(floor, robot, counts_text(checked.found))

    def _offer(self, floor: DocumentFloor, robot: Robot, counts: Message) -> None:
        changes = len(self._checks.changes(floor))
        told: list[str] = [
            counted(
                "{count} difference from the live graph", "{count} differences from the live graph", changes
            ),
            counts,
        ]
        send = self._send
        if robot.kind.loads_graphs:
            try:
                file = self._route_files.file_of(floor)
            except (GraphError, ValueError) as problem:
                self._console.notices.say(sanitize(Message("not sent: {problem}", problem=problem)))
                return
            told += file.lost
            send = partial(self._send_file, robot.name, file)
        entries: list[Entry] = [
            (Message("Send to {name} (asks)", name=robot.name), send),
            (Message("Show the differences"), self._checks.compare),
            (Message("Show the findings"), self._checks.show_findings),
        ]
        self._console.open_menu(joined(", ", filter(None, told)), entries)

    def _send_file(self, robot: str, file: RouteFile) -> None:
        """Send the path of a file, which is written after the question."""
        if self._is_kept(robot):
            command = self._route_files.command(robot, file)
            prepare = partial(self._route_files.write, command, file)
            self._console.dispatch.do(Request((command,)), prepare=prepare)

    def _send(self) -> None:
        opened, console = self._editor.opened, self._console
        if opened is None:
            return
        floor, robot = opened[0].floor, console.navigation.robot
        if not self._is_kept(robot):
            return
        graph, labels = route_graph(floor, roles_of(self._editor.live_graph()))
        vertices, pairs = tuple(graph.vertices.values()), tuple(sorted(labels.items()))
        command = SendGraph(robot, floor.name, vertices, graph.edges, graph.directed, pairs)
        console.dispatch.do(Request((command,)))

    def _is_kept(self, robot: str) -> bool:
        """Keep the robot's present graph; say so if it can't be."""
        if problem := self._keep(robot):
            self._console.notices.say(
                Message("not sent: the present graph can't be kept: {problem}", problem=sanitize(problem))
            )
        return not problem

    def _keep(self, robot: str) -> Message:
        """Write the robot's present graph to a file. Returns the reason if it can't be."""
        live: DocumentFloor = live_floor(self._console.store.state, self._console.navigation.selection)
        folder = self._files.folder
        if folder is None or not live.vertices:
            return EMPTY
        try:
            keep_version(
                folder, robot, live.name, write_graph(of_floor(live), GraphFormat.NATIVE, WriteChoices())
            )
        except (OSError, GraphError) as problem:
            return message_of(problem)
        return EMPTY
