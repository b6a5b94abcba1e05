"""The `:note TEXT` command: a remark for whoever takes over, in the history and in the report."""

from functools import partial

from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Typed

WORD = "note"


class NoteCommand:
    """Writes into the history of the console."""

    def __init__(self, console: Console) -> None:
        self._files = console.files
        self._say = console.notices.say

    def typed(self, line: str) -> Typed | None:
        """Parse a typed line as a note, None if it is not one."""
        word, _, text = line.strip().partition(" ")
        if word.casefold() != WORD:
            return None
        text = truncate(text.strip())
        if self._files.history is None:
            return Typed(problem=Message("no note: this console keeps no history"))
        if self._files.refusal:
            return Typed(problem=self._files.refusal)
        if not text:
            return Typed(problem=Message("note TEXT: what should the next shift know?"))
        remark = sanitize(text)
        return Typed(
            [(Message("Note for the next shift: {remark}", remark=remark), partial(self._write, text))]
        )

    def _write(self, text: str) -> None:
        assert self._files.history is not None
        note = self._files.history.add_note(text)
        if self._files.desk is not None:
            self._files.desk.share_note(note)
        self._files.log("note", text)
        remark = sanitize(text)
        self._say(Message("noted for the next shift: {remark}", remark=remark))
