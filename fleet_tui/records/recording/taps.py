"""Taps of recorders on a link, attached and detached at run time."""

from typing import TYPE_CHECKING

from fleet_tui.model.events import Event

if TYPE_CHECKING:
    from fleet_tui.records.recording.recorder import Recorder


class Taps:
    """The one tap of a link. `attach` and `detach` are callable from any thread."""

    def __init__(self) -> None:
        self._recorders: tuple[Recorder, ...] = ()

    def attach(self, recorder: "Recorder") -> "Recorder":
        """Attach a recorder; it begins with the whole state."""
        self._recorders = (*self._recorders, recorder)
        return recorder

    def detach(self, recorder: "Recorder") -> None:
        self._recorders = tuple(one for one in self._recorders if one is not recorder)
        recorder.close()

    def on_received(self, link: str, channel: str, payload: bytes, is_binary: bool, at: float) -> None:
        """Take a received frame."""
        for recorder in self._recorders:
            recorder.on_received(link, channel, payload, is_binary, at)

    def on_sent(self, link: str, channel: str, payload: bytes) -> None:
        """Take a sent frame."""
        for recorder in self._recorders:
            recorder.on_sent(link, channel, payload)

    def on_event(self, event: Event) -> None:
        for recorder in self._recorders:
            recorder.on_event(event)
