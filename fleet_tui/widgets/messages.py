"""What crosses panes: each message says what happened, never what to do about it."""

from textual.message import Message


class RobotPicked(Message):
    """The operator pointed at a robot on the map."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.name = name


class VertexPicked(Message):
    """The operator pointed at a vertex of the shown floor's graph."""

    def __init__(self, id: int) -> None:
        super().__init__()
        self.id = id
