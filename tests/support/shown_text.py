"""The text that an operator reads: top line, fleet, alarms, the line of commands, what needs attention."""

from fleet_tui.cli.status.status import table
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.language import EMPTY
from fleet_tui.ui.view.lines.commands import message_line
from fleet_tui.ui.view.lines.status import console_notes


def shown(state: FleetState) -> str:
    """All of it as one text."""
    notes = console_notes(state, read_only=False, armed=True, standstill=0.0)
    commands = "".join(text for text, _ in message_line(state, EMPTY, 0.0, 500)) if state.commands else ""
    return "\n".join([*notes, table(state), commands])
