"""Taps: every event that changes the state passes here, in order."""

from typing import Protocol

from fleet_tui.model.events import Event


class Tap(Protocol):
    """Hears all that comes, leaves and happens. Called on the network loop, so it must not wait."""

    def heard(self, link: str, channel: str, payload: bytes, is_binary: bool, at: float) -> None:
        """A frame came at `at` (monotonic seconds); what it means is told to the store next."""

    def sent(self, link: str, channel: str, payload: bytes) -> None:
        """A frame left. No frame with a secret in it comes here."""

    def told(self, event: Event) -> None:
        """Something happened that no frame brought; the store is told next."""
