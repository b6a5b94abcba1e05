"""Files that a console writes."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from fleet_tui.text.language import EMPTY, Message

if TYPE_CHECKING:
    from fleet_tui.config.saving import Saving
    from fleet_tui.maps.draft_file import DraftFile
    from fleet_tui.records.audit.log import Audit
    from fleet_tui.records.desk.desk import SharedDesk
    from fleet_tui.records.history.writer import HistoryWriter
    from fleet_tui.records.recording.recordings import Recordings

Pack = Callable[[str, Callable[[], bool]], Path]
"""From a screenshot (SVG) to the archive; ends early once cancelled. Raises OSError."""


READ_ONLY = Message("not here: this console is read-only")
IN_A_TAB = Message("not in a browser: any visitor of the page could name any file on this machine")


class ConsoleFiles:
    """The audit log, the recordings, the history, the desk, the incident archive and the configuration.
    None: not written here. `refusal`: why a person may write nothing from here, empty if they may;
    `naming_refusal`: why they may name no file to write."""

    def __init__(
        self,
        open_them: "Callable[[ConsoleFiles], None]" = lambda _files: None,
        pack: Pack | None = None,
        saving: "Saving | None" = None,
        draft: "Callable[[str], DraftFile | None]" = lambda _floor: None,
        graph_file: Callable[[str], Path | None] = lambda _floor: None,
        folder: Path | None = None,
    ) -> None:
        """`open_them` opens the audit log and the recordings: after the first picture, before the link.
        `draft` returns the file of a floor's drawn graph, `graph_file` that of its own graph if it has
        one; `folder` keeps earlier versions."""
        self._open_them = open_them
        self.pack = pack
        self.saving = saving
        self.folder = folder
        self.draft = draft
        self.graph_file = graph_file
        self.refusal = self.naming_refusal = EMPTY
        self.audit: Audit | None = None
        self.recordings: Recordings | None = None
        self.history: HistoryWriter | None = None
        self.desk: SharedDesk | None = None

    def open(self) -> None:
        """Open the audit log, the recordings and the history."""
        self._open_them(self)

    @property
    def operator(self) -> str:
        """The operator's name in the audit log."""
        return self.audit.origin.operator if self.audit else ""

    def log(self, change: str, words: str) -> None:
        """Write an event of the console to the audit log, if there is one."""
        if self.audit is not None:
            self.audit.log_console(change, words)

    def notes(self) -> list[Message]:
        """Return notes on recording and its failures."""
        audit = self.audit.notes if self.audit else []
        recordings = self.recordings.notes() if self.recordings else []
        history = self.history.notes if self.history else []
        return [*audit, *recordings, *history, *(self.desk.notes if self.desk else [])]
