"""The announcement of alarms: by the terminal, and by a program of the operator's own."""

from collections.abc import Callable

from fleet_tui.config.schema import Config
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.history.notifying import alarm_program
from fleet_tui.text.language import Message
from fleet_tui.ui.backend import Backend, LiveBackend
from fleet_tui.ui.terminal.annunciator import Annunciator


def announcing(
    config: Config, backend: Backend, send: Callable[[str], bool], say: Callable[[Message], None]
) -> Callable[[FleetState], None]:
    """Return what is called with every state. `send` writes to the terminal, `say` tells the operator that
    the program failed; what a recording shows calls nobody else."""
    annunciator = Annunciator(config.alarms, send)
    program = alarm_program(config, say) if isinstance(backend, LiveBackend) else None

    def look(state: FleetState) -> None:
        annunciator.look(state)
        if program is not None:
            program.look(state)

    return look
