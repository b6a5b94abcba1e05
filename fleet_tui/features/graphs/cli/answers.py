"""The options of the `graph` commands, and questions for the missing ones."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click
from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.maps.formats.graph_file import GraphFile, MissingChoiceError, ReadChoices
from fleet_tui.maps.formats.reading import format_named
from fleet_tui.maps.graph_storage import load_graph_file
from fleet_tui.model.graphs.document import GraphDocument
from fleet_tui.text.errors import GraphError, did_you_mean
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import counted


def graph_counts(document: GraphDocument) -> str:
    """Return the numbers of floors, vertices, edges and labels."""
    floors = document.floors.values()
    return ", ".join(
        (
            counted(len(floors), "floor"),
            counted(sum(len(floor.vertices) for floor in floors), "vertex", "vertices"),
            counted(sum(len(floor.edges) for floor in floors), "edge"),
            counted(sum(len(floor.labels) for floor in floors), "label"),
        )
    )


Made = TypeVar("Made")


class GraphAnswers(Struct, frozen=True):
    """The values of options, as far as they are given. is_terminal: the missing ones can be asked."""

    floor: str = ""
    building_graph: int | None = None
    vehicle_type: str = ""
    lengths: str = ""
    angles: str = ""
    to: str = ""
    is_terminal: bool = False


def answered(make: Callable[[GraphAnswers], Made], answers: GraphAnswers) -> tuple[Made, GraphAnswers]:
    """Return what is made with the answers, and these; missing ones are asked on a terminal.

    Raises GraphError.
    """
    while True:
        try:
            return make(answers), answers
        except MissingChoiceError as missing:
            answers = _asked(missing, answers)


def _asked(missing: MissingChoiceError, answers: GraphAnswers) -> GraphAnswers:
    if not answers.is_terminal:
        raise GraphError(
            Message("{missing}: {option} is missing", missing=missing, option=missing.option)
        ) from None
    name = missing.option.removeprefix("--").replace("-", "_")
    kind: Any = click.Choice(missing.choices) if missing.choices else str
    if name == "building_graph":
        kind = click.IntRange(0)
    question = f"{sanitize(str(missing))}\n{missing.option}"
    return replace(answers, **{name: click.prompt(question, type=kind, err=True)})


def load(file: str, wanted: str | None, answers: GraphAnswers) -> tuple[GraphFile, GraphAnswers]:
    """Return a file's graphs, the chosen floor alone if one is named; notes go to stderr.

    Raises GraphError with the file's name.
    """
    path = Path(file)
    format_ = format_named(wanted) if wanted else None

    def make(given: GraphAnswers) -> GraphFile:
        choices = ReadChoices(
            given.floor or stem(path),
            given.building_graph,
            given.vehicle_type,
            given.lengths,
            given.angles,
            given.is_terminal,
        )
        return load_graph_file(path, format_, choices)

    try:
        read, answers = answered(make, answers)
        found = replace(read, document=_chosen(read.document, answers.floor))
    except GraphError as problem:
        raise GraphError(Message("{file}: {problem}", file=file, problem=problem)) from None
    for note in found.notes:
        click.echo(sanitize(f"{file}: {note}"), err=True)
    return found, answers


def stem(path: Path) -> str:
    """Return a file's name without its endings."""
    return path.name.partition(".")[0] or path.name


def _chosen(document: GraphDocument, floor: str) -> GraphDocument:
    if not floor:
        return document
    if floor not in document.floors:
        names = ", ".join(list(document.floors)[:10]) or "none"
        raise GraphError(
            Message(
                "no floor {floor}{did_you_mean}; it has {names}",
                floor=f"{floor!r}",
                did_you_mean=did_you_mean(floor, document.floors),
                names=names,
            )
        )
    return document.only(floor) if len(document.floors) > 1 else document


def is_terminal() -> bool:
    """Tell whether questions can be asked and seen."""
    return sys.stdin.isatty() and sys.stderr.isatty()
