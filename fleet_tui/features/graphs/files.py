"""Writes the draft of a graph to a file, after what it loses and what is wrong with it is known."""

from datetime import UTC, datetime
from functools import partial
from pathlib import Path

from msgspec.structs import replace

from fleet_tui.config.schema import expanded
from fleet_tui.features.graphs.checks import DraftChecks, counts_text
from fleet_tui.features.graphs.editor import GraphEditor
from fleet_tui.features.graphs.old_files import OldFiles
from fleet_tui.features.graphs.rules.finding import LintInputs
from fleet_tui.features.graphs.rules.targets import of_target
from fleet_tui.maps.formats.graph_file import MissingChoiceError, ReadChoices, WriteChoices
from fleet_tui.maps.formats.losses import losses
from fleet_tui.maps.formats.reading import HAS_FLOORS, format_named, recognised
from fleet_tui.maps.formats.writing import WRITERS, named_format, write_graph
from fleet_tui.maps.graph_storage import graph_text, load_graph_file
from fleet_tui.maps.saving import file_name
from fleet_tui.model.graphs.document import DocumentFloor, GraphDocument, GraphFormat, of_floor
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import EMPTY, Message, counted, joined, message_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Typed

WORD = "write"
"""First word of a typed line that writes the draft."""
USUAL = GraphFormat.NATIVE
"""The format of a new file whose name tells none."""


class DraftFiles:
    """Writes to the floor's own graph file, or to one whose name is typed: `write FILE [FORMAT [VEHICLE]]`.
    LIF wants the type of the vehicles."""

    def __init__(
        self, console: Console, editor: GraphEditor, checks: DraftChecks, old_files: OldFiles
    ) -> None:
        self._console = console
        self._editor = editor
        self._checks = checks
        self._files = console.files
        self._ask = console.ask
        self._old_files = old_files

    def write(self) -> None:
        """Write to the floor's graph file; without one ask for a name."""
        opened = self._editor.opened
        if opened is None:
            return
        path = self._files.graph_file(opened[0].floor.name)
        if path is None:
            self._console.begin(f"{WORD} {file_name(opened[0].floor.name)}.yaml")
        else:
            self._write(path, None, "")

    def typed(self, line: str) -> Typed | None:
        """Parse a typed line as a file to write to, None for any other."""
        word, _, rest = line.strip().partition(" ")
        if word != WORD or not self._editor.is_open:
            return None
        if self._files.naming_refusal:
            return Typed(problem=self._files.naming_refusal)
        name, wanted, vehicle = (*rest.split(None, 2), "", "", "")[:3]
        formats = ", ".join(format_.value for format_ in WRITERS)
        if not name:
            return Typed(
                problem=Message("a file, then a format if its name tells none: {formats}", formats=formats)
            )
        try:
            format_ = format_named(wanted) if wanted else None
        except GraphError as problem:
            return Typed(problem=sanitize(message_of(problem)))
        shown = Message(" as {format}", format=Message(format_.value)) if format_ is not None else EMPTY
        return Typed(
            [
                (
                    Message("Write the draft to {name}{shown}", name=sanitize(name), shown=shown),
                    partial(self._write, expanded(name), format_, vehicle),
                )
            ]
        )

    def _write(self, path: Path, wanted: GraphFormat | None, vehicle: str) -> None:
        """Write, after a question if a file is replaced, something is lost or wrong."""
        opened, say = self._editor.opened, self._console.notices.say
        if opened is None or (checked := self._checks.of(opened[0].floor)) is None:
            return
        floor = checked.floor
        try:
            format_ = wanted or format_of(path)
            document = document_with(path, format_, floor)
            at = datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%SZ")
            text = write_graph(document, format_, WriteChoices(vehicle, at))
            doubts = _doubts(document, format_, vehicle)
            if self._old_files.is_kept(path, text):
                doubts.append("the old file is kept as .bak")
        except MissingChoiceError as missing:
            say(sanitize(Message("not written: {missing}: write FILE lif VEHICLE", missing=missing)))
            return
        except (GraphError, OSError, ValueError) as problem:
            say(sanitize(Message("not written: {path}: {problem}", path=path, problem=problem)))
            return
        if counts := counts_text(checked.found):
            doubts.append(Message("{counts}: ! lists them", counts=counts))
        save = partial(self._save, path, format_, text, floor)
        if not doubts:
            save()
            return
        question = joined(
            "\n",
            map(
                sanitize,
                (
                    Message("Write {name} as {format}?", name=path.name, format=Message(format_.value)),
                    *doubts,
                ),
            ),
        )
        self._ask(lambda: question, save)

    def _save(self, path: Path, format_: GraphFormat, text: str, floor: DocumentFloor) -> None:
        try:
            kept = self._old_files.save(path, text)
        except GraphError as problem:
            self._console.notices.say(sanitize(Message("{path}: {problem}", path=path, problem=problem)))
            return
        where = str(path).replace(str(Path.home()), "~", 1)
        said = Message(
            "{where}: {format}, {vertices}, {edges}",
            where=where,
            format=format_.value,
            vertices=counted("{count} vertex", "{count} vertices", len(floor.vertices)),
            edges=counted("{count} edge", "{count} edges", len(floor.edges)),
        )
        if kept is not None:
            said += Message("; the old file is {name}", name=kept.name)
        self._files.log("graph written", f"{floor.name}: {said}")
        self._console.notices.say(sanitize(said))


def _doubts(document: GraphDocument, format_: GraphFormat, vehicle: str) -> list[str]:
    """Return the losses of a format, and the objections of its readers."""
    inputs = LintInputs(target=format_, vehicle_type=vehicle)
    doubts = [loss.line for loss in losses(document, format_)]
    return doubts + [
        Message("{format} refuses: {text}", format=Message(format_.value), text=one.text)
        for one in of_target(document, inputs)
    ]


def format_of(path: Path) -> GraphFormat:
    """Return the format of an existing file, else the one that its name tells."""
    try:
        found = recognised(graph_text(path)) if path.is_file() else None
    except (GraphError, OSError):
        found = None  # what is unreadable is replaced, and kept beside it
    if found in WRITERS:
        return found
    return named_format(path.name) or USUAL


def document_with(path: Path, format_: GraphFormat, floor: DocumentFloor) -> GraphDocument:
    """Return the draft as a document, with all else that the file has: other floors, and values that robots
    do not report."""
    try:
        document = load_graph_file(path, None, ReadChoices(floor.name)).document
    except GraphError:
        return of_floor(floor)
    old = document.floors.get(floor.name)
    merged = floor if old is None else _merged(old, floor)
    return document.with_floor(merged) if format_ in HAS_FLOORS else of_floor(merged)


def _merged(old: DocumentFloor, new: DocumentFloor) -> DocumentFloor:
    """Return a drawn floor with the values of its file that the draft has not: headings, speeds, extras."""
    vertices = dict(new.vertices)
    for id_ in vertices.keys() & old.vertices.keys():
        one, was = vertices[id_], old.vertices[id_]
        heading = was.heading if one.heading is None else one.heading
        vertices[id_] = replace(one, heading=heading, extra=was.extra)
    edges = dict(new.edges)
    for id_ in edges.keys() & old.edges.keys():
        way, before = edges[id_], old.edges[id_]
        if {way.start, way.end} == {before.start, before.end}:
            speed = before.speed if way.speed is None else way.speed
            cost = before.cost if way.cost is None else way.cost
            drawn = replace(before, start=way.start, end=way.end, two_way=way.two_way)
            edges[id_] = replace(drawn, speed=speed, cost=cost)
    return replace(old, vertices=vertices, edges=edges)
