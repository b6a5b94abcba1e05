"""Fragmented messages: a bridge of ROS 2 splits those above its fragment size."""

from dataclasses import dataclass, field

from fleet_tui.robots.ros.operations import Fragment
from fleet_tui.text.errors import WireError

MOST_MESSAGES = 4
"""Number of messages whose fragments are kept: a connection sends them one by one."""
MOST_PIECES = 10_000


@dataclass(slots=True)
class _Message:
    total: int
    pieces: dict[int, str] = field(default_factory=dict)
    size: int = 0


class Fragments:
    """Joins the fragments of one connection; a message may have `limit` characters."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._messages: dict[str, _Message] = {}

    def add(self, piece: Fragment) -> bytes | None:
        """Take one fragment. Returns the message when it is complete.

        Raises WireError for one that is too large, or whose fragments don't fit together.
        """
        message = self._messages.setdefault(piece.id, _Message(piece.total))
        if not 0 <= piece.num < piece.total <= MOST_PIECES or piece.total != message.total:
            del self._messages[piece.id]
            raise WireError(f"piece {piece.num} of {piece.total} without a message")
        message.size += len(piece.data) - len(message.pieces.get(piece.num, ""))
        message.pieces[piece.num] = piece.data
        if message.size > self._limit:
            del self._messages[piece.id]
            raise WireError(
                f"a message in {piece.total} pieces exceeds the limit of {self._limit:,} characters"
            )
        if len(message.pieces) < message.total:
            while len(self._messages) > MOST_MESSAGES:
                del self._messages[next(iter(self._messages))]
            return None
        del self._messages[piece.id]
        return "".join(message.pieces[n] for n in range(message.total)).encode()

    def clear(self) -> None:
        """Drop incomplete messages: a new connection can't complete them."""
        self._messages.clear()
