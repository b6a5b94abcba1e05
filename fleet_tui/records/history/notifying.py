"""The one process of a site that notifies, of several consoles and collectors."""

from collections.abc import Callable
from functools import partial
from zlib import crc32

from fleet_tui.config.log_file import state_folder
from fleet_tui.config.schema import Config
from fleet_tui.programs.notify import AlarmProgram
from fleet_tui.records.history.writer import takes, turn_at
from fleet_tui.text.language import Message


def alarm_program(config: Config, say: Callable[[Message], None]) -> AlarmProgram | None:
    """Return the program for a site's alarms, None without one. It is called by the process of this user that
    looked first; when that ends, by another one."""
    if not config.notify.command:
        return None
    path = config.path.absolute()
    turn = turn_at(state_folder() / f"notify-{crc32(bytes(path)):08x}")
    return AlarmProgram(config.notify, path.parent, say, partial(takes, turn))
