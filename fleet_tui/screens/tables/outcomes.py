"""The outcomes of commands to several rows, one line each, until all are known."""

import math
from collections.abc import Callable, Sequence
from time import monotonic

from textual.widgets import Static

from fleet_tui.model.commands import Command, CommandRecord
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.details import detail_text
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.lines.commands import command_text, stage_text

SHOWN = 9
"""Lines; the number of others follows."""
STAYS = 8.0
"""Seconds for which it stays after the last outcome."""


class Outcomes(Static):
    """Over the tables, without the focus: keys go on to where they went."""

    def __init__(self, state: Callable[[], FleetState]) -> None:
        super().__init__(id="outcomes", markup=False)
        self.border_title = tr("Outcomes")
        self.border_subtitle = tr("marks cleared, Esc closes")
        self._state = state
        self._told: Sequence[tuple[Command, str]] = ()
        self._since = 0.0
        self._ends = math.inf
        self.display = False

    def show(self, told: Sequence[tuple[Command, str]], since: float) -> None:
        """Show the outcome of each of these commands, sent from `since` (monotonic) on, or the reason that it
        was not sent."""
        self._told = told
        self._since = since
        self._ends = math.inf
        self.display = True
        self.look()

    def close(self) -> bool:
        """Close it; False if it was not open."""
        was_open, self.display = self.display, False
        return was_open

    def look(self) -> None:
        """Show the newest stage of each, and close when all have been known for a while."""
        if not self.display:
            return
        state, now = self._state(), monotonic()
        records = [
            None if problem else _record(state, command, self._since) for command, problem in self._told
        ]
        if all(record is None or record.is_decided for record in records):
            self._ends = min(self._ends, now + STAYS)
        if now >= self._ends or self._is_outdated(state):
            self.display = False
            return
        told = zip(self._told, records, strict=True)
        lines = [_line(state, command, problem, record) for (command, problem), record in told]
        more = [tr(f"and {len(lines) - SHOWN} more: L has all")] if len(lines) > SHOWN else []
        text = "\n".join([*lines[:SHOWN], *more])
        if text != self.content:
            self.update(text)

    def _is_outdated(self, state: FleetState) -> bool:
        """Tell whether another command was given since."""
        told = [command for command, _ in self._told]
        return any(one.issued_at >= self._since and one.command not in told for one in state.commands)


def _record(state: FleetState, command: Command, since: float) -> CommandRecord | None:
    """Return the newest record of a command given from `since` (monotonic) on."""
    found = (record for record in reversed(state.commands) if record.command == command)
    return next((record for record in found if record.issued_at >= since), None)


def _line(state: FleetState, command: Command, problem: str, record: CommandRecord | None) -> str:
    text = command_text(state, command)
    if record is None:
        return f"{text}: {tr(sanitize(problem)) or tr('sending')}"
    return f"{text}: {stage_text(record, state.now)}{detail_text(tr(sanitize(record.detail)))}"
