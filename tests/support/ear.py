"""A tap that remembers all that it takes."""

from fleet_tui.model import events


class Ear:
    def __init__(self) -> None:
        self.heard_frames: list[tuple[str, str, bytes, float]] = []
        self.sent_frames: list[tuple[str, str, bytes]] = []
        self.facts: list[events.Event] = []

    def on_received(self, link: str, channel: str, payload: bytes, is_binary: bool, at: float) -> None:
        self.heard_frames.append((link, channel, payload, at))

    def on_sent(self, link: str, channel: str, payload: bytes) -> None:
        self.sent_frames.append((link, channel, payload))

    def on_event(self, event: events.Event) -> None:
        self.facts.append(event)
