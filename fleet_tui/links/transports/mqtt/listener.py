"""The listener of a connection to a broker."""

from typing import Protocol

from fleet_tui.text.language import Message


class BrokerListener(Protocol):
    """Receives the events of a connection. Everything is called on the network loop."""

    def on_connecting(self) -> None:
        """A connection attempt has begun."""

    def on_open(self) -> None:
        """Subscriptions and messages can be sent."""

    def on_lost(self, reason: Message, next_try_in: float) -> None:
        """Take the loss of the connection; the next try is in `next_try_in` seconds."""

    def on_message(self, topic: str, payload: bytes, retained: bool) -> None:
        """A message arrived; `retained`: the broker kept it from before the subscription."""

    def on_subscribed(self, pattern: str, granted: bool) -> None:
        """The broker answered a subscription."""

    def on_answer(self, seconds: float) -> None:
        """The broker answered our sign of life after so many seconds."""

    def on_sent(self, topic: str, payload: bytes) -> None:
        """A message was sent."""

    def on_too_large(self, topic: str, size: int) -> None:
        """A message of `size` bytes was dropped."""
