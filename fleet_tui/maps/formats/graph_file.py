"""A graph file that was read, and the choices that some formats need for it."""

from collections.abc import Mapping

from msgspec import Struct

from fleet_tui.model.graphs.document import GraphDocument, GraphFormat
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message


class ReadChoices(Struct, frozen=True):
    """The answers to what a file leaves open. floor: the floor's name where the format has none;
    building_graph: the graph of several in an RMF building; vehicle_type: of several in a LIF file; lengths
    (m, mm) and angles (rad, deg): the units of a LIF file, where they are not the format's own; ask: raise
    MissingChoiceError where the units are in doubt."""

    floor: str = "floor"
    building_graph: int | None = None
    vehicle_type: str = ""
    lengths: str = ""
    angles: str = ""
    ask: bool = False


class WriteChoices(Struct, frozen=True):
    """The answers to what a format wants beyond the document. vehicle_type: for LIF, the vehicles that may
    use the graph; at: the time of writing, ISO 8601 in UTC."""

    vehicle_type: str = ""
    at: str = ""


class GraphFile(Struct, frozen=True):
    """A document with the format of its file. notes: what a reader should know; left_out: counts of the
    file's other contents."""

    format: GraphFormat
    document: GraphDocument
    notes: tuple[str, ...] = ()
    left_out: Mapping[str, int] = {}


class MissingChoiceError(GraphError):
    """A file or a format that needs an answer. `option`: the command line's option for it; `choices`: the
    possible answers, none for free text."""

    def __init__(self, text: Message, option: str, choices: tuple[str, ...] = ()) -> None:
        super().__init__(text)
        self.option = option
        self.choices = choices
