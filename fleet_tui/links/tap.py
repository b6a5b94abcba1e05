"""Taps: every event that changes the state passes here, in order."""

from typing import Protocol

from fleet_tui.model.events import Event


class Tap(Protocol):
    """Receives every frame in, frame out and event. Called on the network loop, so it must not block."""

    def on_received(self, link: str, channel: str, payload: bytes, is_binary: bool, at: float) -> None:
        """Take a frame that arrived at `at` (monotonic seconds); its events follow."""

    def on_sent(self, link: str, channel: str, payload: bytes) -> None:
        """Take a sent frame. Frames with secrets are never passed."""

    def on_event(self, event: Event) -> None:
        """Take an event without a frame; the store gets it next."""
