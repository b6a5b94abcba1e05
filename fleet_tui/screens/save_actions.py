"""The main screen's `:save [FILE]`: the configuration of this console as a file."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from fleet_tui.config.saving import USUAL, Saving
from fleet_tui.config.schema import expanded
from fleet_tui.errors import FleetError
from fleet_tui.screens.part import Part
from fleet_tui.text.sanitize import sanitize

if TYPE_CHECKING:
    from fleet_tui.screens.confirm import Confirm
    from fleet_tui.screens.palette import Palette
    from fleet_tui.screens.typed import Typed

WORD = "save"


class SaveActions(Part):
    """`saving` is None where there is nothing to keep: a demo, a recording."""

    saving: Saving | None = None
    confirm: "Confirm"
    palette: "Palette"
    say: Callable[[str], None]

    def action_save(self) -> None:
        """Type where to, where it is in no file yet."""
        is_kept = self.saving is None or self.saving.path
        self.palette.show(WORD if is_kept else f"{WORD} {USUAL}")

    def as_save(self, line: str) -> "Typed | None":
        """A typed line as a file to save to, None where it is none."""
        from fleet_tui.screens.typed import Typed

        word, _, name = line.strip().partition(" ")
        if word.casefold() != WORD:
            return None
        name = name.strip()
        if problem := self._unsavable(name):
            return Typed([(problem, partial(self.say, problem))])
        assert self.saving is not None
        name = name or USUAL
        return Typed(
            [(f"Save this configuration to {sanitize(name)}", partial(self._save, self.saving, name))]
        )

    def _unsavable(self, name: str) -> str:
        """Say why there is nothing to write, empty where there is."""
        if self.saving is None:
            return "nothing to save: this is no console on a fleet of your own"
        path = self.saving.path
        if path and (not name or expanded(name).resolve() == Path(path).resolve()):
            return f"this configuration is in {sanitize(path)} already: {WORD} FILE writes a copy"
        return ""

    def _save(self, saving: Saving, name: str) -> None:
        """Write it, after asking where something is there already."""
        if expanded(name).exists():
            question = f"{sanitize(name)} is there already. Write over it?"
            self.confirm.ask(lambda: question, partial(self._write, saving, name))
        else:
            self._write(saving, name)

    def _write(self, saving: Saving, name: str) -> None:
        try:
            path = saving.write(name)
        except FleetError as problem:
            self.say(sanitize(f"not saved: {problem}"))
        else:
            where = str(path).replace(str(Path.home()), "~", 1)
            self.say(sanitize(f"saved to {where}" + ": fleet-tui opens it here" * (name == USUAL)))
