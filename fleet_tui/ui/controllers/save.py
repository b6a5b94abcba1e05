"""The `:save [FILE]` command: the configuration of this console as a file."""

from functools import partial
from pathlib import Path

from fleet_tui.config.saving import USUAL, Saving
from fleet_tui.config.schema import expanded
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Typed

WORD = "save"


class SaveCommand:
    """Writes a file, asking before it overwrites; `begin` opens the palette with a line."""

    def __init__(self, console: Console) -> None:
        self._files = console.files
        self._ask = console.ask
        self._begin = console.begin
        self._say = console.notices.say

    def start(self) -> None:
        """Ask for a path if the configuration is in no file yet."""
        is_kept = self._files.saving is None or self._files.saving.path
        self._begin(WORD if is_kept else f"{WORD} {USUAL}")

    def typed(self, line: str) -> Typed | None:
        """Parse a typed line as a file to save to, None if it is not one."""
        word, _, name = line.strip().partition(" ")
        if word.casefold() != WORD:
            return None
        name = name.strip()
        if problem := self._unsavable(name):
            return Typed([(problem, partial(self._say, problem))])
        saving, name = self._files.saving, name or USUAL
        assert saving is not None
        return Typed(
            [
                (
                    Message("Save this configuration to {name}", name=sanitize(name)),
                    partial(self._save, saving, name),
                )
            ]
        )

    def _unsavable(self, name: str) -> Message:
        """Return the reason that nothing can be saved, empty if something can."""
        if self._files.saving is None:
            return Message("nothing to save: this console has no fleet of its own")
        if self._files.naming_refusal:
            return self._files.naming_refusal
        path = self._files.saving.path
        if path and (not name or expanded(name).resolve() == Path(path).resolve()):
            return Message(
                "already saved in {path}: {command} FILE writes a copy", path=sanitize(path), command=WORD
            )
        return EMPTY

    def _save(self, saving: Saving, name: str) -> None:
        """Save, asking before overwriting a file."""
        if expanded(name).exists():
            question = Message("{name} exists. Overwrite?", name=sanitize(name))
            self._ask(lambda: question, partial(self._write, saving, name))
        else:
            self._write(saving, name)

    def _write(self, saving: Saving, name: str) -> None:
        try:
            path = saving.write(name)
        except FleetError as problem:
            self._say(sanitize(Message("not saved: {problem}", problem=problem)))
        else:
            where = str(path).replace(str(Path.home()), "~", 1)
            said = Message("saved to {path}", path=where)
            if name == USUAL:
                said += Message(": fleet-tui opens it here")
            self._say(sanitize(said))
