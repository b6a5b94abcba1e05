"""The main screen's part in recordings: one action begins and ends one, the status line says so."""

import logging
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from fleet_tui.errors import FleetError
from fleet_tui.screens.part import Part

if TYPE_CHECKING:
    from fleet_tui.recording.recordings import Recordings

LOG = logging.getLogger(__name__)


class RecordingActions(Part):
    """`recordings` is None where there is nothing to record."""

    recordings: "Recordings | None" = None
    _switching = False
    say: Callable[[str], None]

    def recording_notes(self) -> list[str]:
        """What is recorded, and what of it fails."""
        return self.recordings.notes() if self.recordings else []

    def action_record(self) -> None:
        """Begin a recording, or end it. A disk may take its time."""
        if self.recordings is None:
            self.say("nothing to record here: this is no live console")
        elif not self._switching:
            self._switching = True
            self.run_worker(self._switch, thread=True)

    def _switch(self) -> None:
        """In a thread."""
        assert self.recordings is not None
        try:
            if self.recordings.recorder is not None:
                said = self.recordings.stop()
            else:
                said = f"recording to {self.recordings.start()}"
        except FleetError as problem:
            said = f"not recording: {problem}"
        finally:
            self._switching = False
        LOG.info("%s", said)
        # The usual place fits 80 columns.
        self.app.call_from_thread(self.say, said.replace(str(Path.home()), "~", 1))
