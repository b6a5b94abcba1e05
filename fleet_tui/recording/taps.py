"""Taps of recorders on a link; they come and go while it runs."""

from typing import TYPE_CHECKING

from fleet_tui.model.events import Event

if TYPE_CHECKING:
    from fleet_tui.recording.recorder import Recorder


class Taps:
    """The one tap of a link. Any thread may attach and detach."""

    def __init__(self) -> None:
        self._recorders: tuple[Recorder, ...] = ()

    def attach(self, recorder: "Recorder") -> "Recorder":
        """Let a recorder listen; it begins with all that is known."""
        self._recorders = (*self._recorders, recorder)
        return recorder

    def detach(self, recorder: "Recorder") -> None:
        """End a recording."""
        self._recorders = tuple(one for one in self._recorders if one is not recorder)
        recorder.close()

    def heard(self, link: str, channel: str, payload: bytes, is_binary: bool, at: float) -> None:
        """A frame came."""
        for recorder in self._recorders:
            recorder.heard(link, channel, payload, is_binary, at)

    def sent(self, link: str, channel: str, payload: bytes) -> None:
        """A frame left."""
        for recorder in self._recorders:
            recorder.sent(link, channel, payload)

    def told(self, event: Event) -> None:
        """Something happened."""
        for recorder in self._recorders:
            recorder.told(event)
