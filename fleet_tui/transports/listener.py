"""The listener of a connection."""

from typing import Protocol


class Listener(Protocol):
    """Receives the events of a connection. Everything is called on the network loop."""

    def on_connecting(self) -> None:
        """A connection attempt has begun."""

    def on_open(self) -> None:
        """Frames can be sent."""

    def on_lost(self, reason: str, next_try_in: float) -> None:
        """Take the loss of the connection; the next try is in `next_try_in` seconds."""

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """A frame arrived."""

    def on_sent(self, payload: bytes) -> None:
        """A frame was sent."""

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        """A message of `size` bytes was dropped; `head` is its beginning."""
