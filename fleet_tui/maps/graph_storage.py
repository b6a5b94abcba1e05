"""Graph files on the disk: read with bounds, written whole, with the old version beside the new one."""

from pathlib import Path

from fleet_tui.config.small_file import read_text
from fleet_tui.config.trust import written_file
from fleet_tui.maps.formats.graph_file import GraphFile, ReadChoices
from fleet_tui.maps.formats.reading import LARGEST, read_graph
from fleet_tui.model.graphs.document import GraphFormat
from fleet_tui.storage.whole_file import write_whole
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message


def graph_text(path: Path) -> str:
    """Return the text of a graph file. Raises GraphError."""
    try:
        return read_text(path, LARGEST)
    except FileNotFoundError:
        raise GraphError(Message("no such file")) from None
    except UnicodeDecodeError as problem:
        raise GraphError(
            Message("not UTF-8 at byte {start}: save it as UTF-8", start=f"{problem.start:,}")
        ) from None
    except IsADirectoryError:
        raise GraphError(Message("is a folder: name a file")) from None
    except OSError as problem:
        raise GraphError(Message("unreadable: {strerror}", strerror=problem.strerror or problem)) from None
    except ValueError as problem:
        raise GraphError(Message("unreadable: {problem}", problem=problem)) from None


def load_graph_file(path: Path, format_: GraphFormat | None, choices: ReadChoices) -> GraphFile:
    """Return the document of a file. Raises GraphError, MissingChoiceError."""
    return read_graph(graph_text(path), format_, choices)


def save_graph_file(path: Path, text: str, keep: bool = True) -> Path | None:
    """Write a file whole or not at all; with `keep` return the name of its old version, if there was one.

    Raises GraphError.
    """
    # A stream that happens to be a file would be replaced under the hands of whoever reads it.
    if path.absolute().parts[1:2] in (("dev",), ("proc",)):
        raise GraphError(Message("not a regular file"))
    if path.is_dir():
        raise GraphError(Message("is a folder: name a file"))
    if path.exists() and not path.is_file():
        raise GraphError(Message("not a regular file"))
    try:
        path = written_file(path)
        return write_whole(path, text.encode(), keep=keep, is_shared=True)
    except OSError as problem:
        raise GraphError(
            Message("cannot be written: {strerror}", strerror=problem.strerror or problem)
        ) from None
