"""Starts and stops a recording, by one action."""

import logging
from collections.abc import Callable
from pathlib import Path

from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.console import Console

LOG = logging.getLogger(__name__)


class RecordingSwitch:
    """Works in a thread, as a disk may be slow."""

    def __init__(self, console: Console, in_thread: Callable[[Callable[[], None]], object]) -> None:
        self._files = console.files
        self._say = console.notices.say
        self._say_from_thread = console.say_from_thread
        self._in_thread = in_thread
        self._switching = False

    def turn(self) -> None:
        """Start a recording, or stop it."""
        if self._files.recordings is None:
            self._say(Message("nothing to record: not a live console"))
        elif self._files.refusal:
            self._say(self._files.refusal)
        elif not self._switching:
            self._switching = True
            self._in_thread(self._turn)

    def _turn(self) -> None:
        """Start or stop, in a thread."""
        recordings = self._files.recordings
        assert recordings is not None
        try:
            if recordings.recorder is not None:
                said = recordings.stop()
            else:
                # The usual path fits 80 columns.
                said = Message(
                    "recording to {path}", path=str(recordings.start()).replace(str(Path.home()), "~", 1)
                )
        except FleetError as problem:
            said = Message("recording failed: {problem}", problem=problem)
        finally:
            self._switching = False
        LOG.info("%s", said)
        self._say_from_thread(said)
