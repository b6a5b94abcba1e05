"""Graphs for robots that load a file: written before the call, followed until the robot has answered."""

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple, TypeVar

from fleet_tui.config.trust import doubt
from fleet_tui.features.graphs.editor import GraphEditor
from fleet_tui.features.graphs.files import document_with, format_of
from fleet_tui.features.graphs.old_files import OldFiles
from fleet_tui.features.graphs.rules.finding import LintInputs
from fleet_tui.features.graphs.rules.targets import of_target
from fleet_tui.maps.formats.geojson import new_ids
from fleet_tui.maps.formats.graph_file import WriteChoices
from fleet_tui.maps.formats.losses import losses
from fleet_tui.maps.formats.writing import write_graph
from fleet_tui.maps.route_graphs import load_floor_graph
from fleet_tui.model.commands import CommandRecord, Stage
from fleet_tui.model.events import FloorGraphLoaded
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex, GraphFormat
from fleet_tui.model.graphs.draft import Change
from fleet_tui.model.graphs.live import route_graph
from fleet_tui.model.set_up.commands import SendGraph
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console

FORMAT = GraphFormat.GEOJSON
"""The format that Nav2's route server reads."""
E = TypeVar("E", DocumentVertex, DocumentEdge)


class RouteFile(NamedTuple):
    """The file that a robot is to load: its text and its floor, whose ids are as in the file. `lost` are the
    parts of the draft that the file has not."""

    path: Path
    text: str
    floor: DocumentFloor
    lost: tuple[str, ...]


class SentFile(NamedTuple):
    """A file that was written for a robot: the graph in it, and a note on the old file."""

    loaded: FloorGraphLoaded
    file: RouteFile
    note: Message


class RouteFiles:
    """Writes the floor's graph file just before a robot is told to load it. Once it has, the graph of that
    file is the live one here; until then, and if it has not, the earlier one stays."""

    def __init__(self, console: Console, editor: GraphEditor, old_files: OldFiles) -> None:
        self._old_files = old_files
        self._notices = console.notices
        self._editor = editor
        self._files = console.files
        self._post = console.backend.post
        self._sent: dict[SendGraph, SentFile] = {}
        console.store.watchers.append(self._watch)

    def refusal(self, floor: str) -> Message:
        """Return the reason that a floor has no file to load, with its remedy; empty if it has one."""
        path = self._files.graph_file(floor)
        if path is None:
            return Message(
                'not sent: set graph = "FILE.geojson" in [[floors]] of {floor}, the robot loads that file',
                floor=floor,
            )
        if (format_ := format_of(path)) is not FORMAT:
            remedy = Message("run fleet-tui graph convert, and name the new file in [[floors]] graph")
            return Message(
                "not sent: {name} is {format}, not geojson: {remedy}",
                name=path.name,
                format=Message(format_.value),
                remedy=remedy,
            )
        # The robot reads it after it was written here.
        return Message("not sent: {problem}", problem=found) if (found := doubt(path)) else EMPTY

    def file_of(self, floor: DocumentFloor) -> RouteFile:
        """Return the file for a draft. Raises GraphError, also for what the route server refuses."""
        path = self._files.graph_file(floor.name)
        if path is None:
            raise GraphError(Message("{name} has no graph file", name=floor.name))
        document = document_with(path, FORMAT, floor)
        for one in of_target(document, LintInputs(target=FORMAT)):
            if one.is_error:
                raise GraphError(one.text)
        lost = tuple(loss.line for loss in losses(document, FORMAT))
        text = write_graph(document, FORMAT, WriteChoices())
        return RouteFile(path.absolute(), text, new_ids(floor).floor, lost)

    def command(self, robot: str, file: RouteFile) -> SendGraph:
        graph, labels = route_graph(file.floor)
        vertices, pairs = tuple(graph.vertices.values()), tuple(sorted(labels.items()))
        floor, path, is_kept = file.floor.name, str(file.path), self._old_files.is_kept(file.path, file.text)
        return SendGraph(robot, floor, vertices, graph.edges, graph.directed, pairs, path, is_kept)

    def write(self, command: SendGraph, file: RouteFile) -> Message:
        """Write the file of a command that is about to be sent. Returns the reason that it can't be."""
        try:
            kept = self._old_files.save(file.path, file.text, is_sent=True)
        except GraphError as problem:
            return sanitize(Message("not sent: {path}: {problem}", path=file.path, problem=problem))
        self._renumber(file.floor)
        note = Message(" (before: {name})", name=kept.name) if kept is not None else EMPTY
        self._sent[command] = SentFile(load_floor_graph(file.floor.name, file.path), file, note)
        self._files.log(
            "graph written",
            Message(
                "{name}: {path} for {robot}{note}",
                name=file.floor.name,
                path=file.path,
                robot=command.robot,
                note=note,
            ),
        )
        return EMPTY

    def _renumber(self, floor: DocumentFloor) -> None:
        """Give the draft the ids of its file, as a step: the robot has no others."""
        draft = self._editor.draft
        if draft is None or draft.floor.name != floor.name:
            return
        vertices = _pairs(draft.floor.vertices, floor.vertices)
        edges = _pairs(draft.floor.edges, floor.edges)
        if vertices or edges:
            self._editor.do(Change(Message("ids as in the file"), vertices, edges))

    def _watch(self, before: FleetState, after: FleetState) -> None:
        """Note the end of each command to load a file. Runs in the thread of the store's writer."""
        if not self._sent or before.commands is after.commands:
            return
        ended = {record.id for record in before.commands if record.is_decided}
        for record in after.commands:
            if record.is_decided and record.id not in ended:
                self._end(record)

    def _end(self, record: CommandRecord) -> None:
        command = record.command
        if not isinstance(command, SendGraph) or (sent := self._sent.pop(command, None)) is None:
            return
        if record.stage is Stage.CONFIRMED:
            self._old_files.loaded(sent.file.path, sent.file.text)
            self._post(sent.loaded)
            return
        loaded = (
            Message("may have loaded it or not")
            if record.stage is Stage.NOT_CONFIRMED
            else Message("has not loaded it")
        )
        name = Path(command.path).name
        self._notices.note(
            sanitize(
                Message(
                    "{name} is written, {robot} {loaded}{note}",
                    name=name,
                    robot=command.robot,
                    loaded=loaded,
                    note=sent.note,
                )
            )
        )


def _pairs(old: Mapping[str, E], new: Mapping[str, E]) -> tuple[tuple[E | None, E | None], ...]:
    """Return each element that differs, before and after."""
    ids = {**old, **new}
    return tuple((old.get(id_), new.get(id_)) for id_ in ids if old.get(id_) != new.get(id_))
