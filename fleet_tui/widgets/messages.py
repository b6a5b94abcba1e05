"""Messages between panes: each describes an event, not the reaction to it."""

from collections.abc import Hashable

from textual.message import Message


class RobotPicked(Message):
    """The operator pointed at a robot on the map."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.name = name


class VertexPicked(Message):
    """The operator pointed at a vertex of the shown floor's graph."""

    def __init__(self, id: str) -> None:
        super().__init__()
        self.id = id


class RowPicked(Message):
    """The cursor of a pane moved to a row."""

    def __init__(self, pane: str, key: Hashable) -> None:
        super().__init__()
        self.pane = pane
        self.key = key


class RowChosen(Message):
    """The operator opened the menu of a pane's row."""

    def __init__(self, pane: str, key: Hashable) -> None:
        super().__init__()
        self.pane = pane
        self.key = key


class ButtonPressed(Message):
    """A button in a pane was pressed; `key` is its row's, None in the title."""

    def __init__(self, pane: str, name: str, key: Hashable) -> None:
        super().__init__()
        self.pane = pane
        self.name = name
        self.key = key


class TimePicked(Message):
    """A cell of the time line was clicked."""

    def __init__(self, x: int, width: int) -> None:
        super().__init__()
        self.x, self.width = x, width


Picked = RobotPicked | VertexPicked | RowPicked | RowChosen | ButtonPressed | TimePicked
