"""The `graph convert` command."""

from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import click
from msgspec.structs import replace

from fleet_tui.features.graphs.cli.answers import GraphAnswers, answered, graph_counts, load
from fleet_tui.features.graphs.rules.finding import LintInputs
from fleet_tui.features.graphs.rules.targets import of_target
from fleet_tui.maps.formats.graph_file import GraphFile, MissingChoiceError, WriteChoices
from fleet_tui.maps.formats.losses import losses
from fleet_tui.maps.formats.reading import format_named, recognised
from fleet_tui.maps.formats.writing import ONE_FLOOR, WRITERS, named_format, write_graph
from fleet_tui.maps.graph_storage import graph_text, save_graph_file
from fleet_tui.model.graphs.document import GraphDocument, GraphFormat
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize


def convert(
    say: Callable[[str], None],
    source: str,
    target: str,
    to: str | None,
    wanted: str | None,
    answers: GraphAnswers,
) -> int:
    """Write a file in another format; return 1 if the format refuses the graph. Raises GraphError."""
    read, answers = load(source, wanted, replace(answers, to=to or ""))
    try:
        (format_, document, text), _ = answered(lambda given: _made(read, target, given), answers)
    except GraphError as problem:
        raise GraphError(Message("{source}: {problem}", source=source, problem=problem)) from None
    if _refused(document, format_, answers):
        return 1
    _list_losses(read, document, format_)
    try:
        kept = save_graph_file(Path(target), text)
    except GraphError as problem:
        raise GraphError(Message("{target}: {problem}", target=target, problem=problem)) from None
    old = f"; the old file is {kept.name}" if kept else ""
    say(sanitize(f"{target}: {format_.value}, {graph_counts(document)}{old}"))
    return 0


def _made(read: GraphFile, target: str, given: GraphAnswers) -> tuple[GraphFormat, GraphDocument, str]:
    """Return the format of OUT, the document for it and its text. Raises MissingChoiceError."""
    format_ = format_named(given.to) if given.to else _format_of(target)
    document = read.document
    if format_ in ONE_FLOOR and given.floor and len(document.floors) > 1:
        document = document.only(given.floor)
    at = datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%SZ")
    return format_, document, write_graph(document, format_, WriteChoices(given.vehicle_type, at))


def _format_of(target: str) -> GraphFormat:
    """Return the format of an existing file, else the one that its name tells."""
    path = Path(target)
    if path.is_file() and (found := _existing(path)):
        return found
    if (named := named_format(path.name)) is not None:
        return named
    choices = tuple(one.value for one in WRITERS)
    raise MissingChoiceError(
        Message("no format is known for {name}: {choices}", name=path.name, choices=", ".join(choices)),
        "--to",
        choices,
    )


def _existing(path: Path) -> GraphFormat | None:
    try:
        return recognised(graph_text(path))
    except GraphError:
        return None


def _refused(document: GraphDocument, format_: GraphFormat, answers: GraphAnswers) -> bool:
    """Print what the format's own readers refuse."""
    vehicle = answers.vehicle_type or "asked"  # without one the text could not be made
    found = list(of_target(document, LintInputs(target=format_, vehicle_type=vehicle)))
    for one in found[:100]:
        click.echo(sanitize(f"error: {one.text}"), err=True)
    if found:
        click.echo(f"not written: {format_.value} refuses the graph", err=True)
    return bool(found)


def _list_losses(read: GraphFile, document: GraphDocument, format_: GraphFormat) -> None:
    """Print, counted, what the conversion loses."""
    lines = [f"not read: {what}: {count}" for what, count in read.left_out.items()]
    lines += [loss.line for loss in losses(document, format_)]
    for line in lines:
        click.echo(sanitize(line), err=True)
