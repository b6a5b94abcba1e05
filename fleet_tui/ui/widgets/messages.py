"""Messages between panes: each describes an event, not the reaction to it."""

from collections.abc import Hashable
from dataclasses import dataclass

from textual.message import Message


@dataclass
class RobotPicked(Message):
    """The operator pointed at a robot on the map."""

    name: str


@dataclass
class VertexPicked(Message):
    """The operator pointed at a vertex of the shown floor's graph."""

    id: str


@dataclass
class FloorPicked(Message):
    """The operator pointed at the small map of a floor."""

    name: str


@dataclass
class PlacePicked(Message):
    """The operator clicked at a place of the map where its mode takes clicks; `dragged`: he moved something
    there."""

    dragged: bool


@dataclass
class RowPicked(Message):
    """The cursor of a pane moved to a row."""

    pane: str
    key: Hashable


@dataclass
class RowChosen(Message):
    """The operator opened the menu of a pane's row."""

    pane: str
    key: Hashable


@dataclass
class ButtonPressed(Message):
    """A button in a pane was pressed; `key` is its row's, None in the title."""

    pane: str
    name: str
    key: Hashable


@dataclass
class TimePicked(Message):
    """A cell of the time line was clicked."""

    x: int
    width: int


Picked = (
    RobotPicked
    | VertexPicked
    | FloorPicked
    | PlacePicked
    | RowPicked
    | RowChosen
    | ButtonPressed
    | TimePicked
)
