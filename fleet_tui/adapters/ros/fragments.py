"""Messages that come in pieces: a bridge of ROS 2 cuts those that are larger than it sends at once."""

from dataclasses import dataclass, field

from fleet_tui.adapters.ros.operations import Fragment
from fleet_tui.errors import WireError

MOST_MESSAGES = 4
"""Messages of which pieces are kept: one connection sends them one after the other."""
MOST_PIECES = 10_000


@dataclass(slots=True)
class _Message:
    total: int
    pieces: dict[int, str] = field(default_factory=dict)
    size: int = 0


class Fragments:
    """Puts the pieces of one connection together; a message may have `limit` characters."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._messages: dict[str, _Message] = {}

    def add(self, piece: Fragment) -> bytes | None:
        """Take one piece. Returns the message when it is whole.

        Raises WireError for one that is too large, or whose pieces don't fit together."""
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
        """Forget what is not whole: on a new connection nothing more of it comes."""
        self._messages.clear()
