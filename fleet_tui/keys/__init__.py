"""Every key of the console in one table, the source of bindings, help, palette, footer and config check."""

from collections.abc import Collection, Mapping

from fleet_tui.keys.console import CONSOLE
from fleet_tui.keys.diagnostics import DIAGNOSTICS, PAGES
from fleet_tui.keys.drive import DRIVE
from fleet_tui.keys.edit import EDIT
from fleet_tui.keys.history import HISTORY, HISTORY_PAGES
from fleet_tui.keys.key import LISTS, Key, Pane
from fleet_tui.keys.map import MAP
from fleet_tui.keys.place import PLACE
from fleet_tui.keys.recording import RECORDING
from fleet_tui.keys.tables import ROWS, TABLES

__all__ = [
    "BY_ID",
    "DIAGNOSTICS",
    "HISTORY",
    "HISTORY_PAGES",
    "KEYS",
    "LISTS",
    "PAGES",
    "ROWS",
    "Key",
    "Pane",
    "outdone",
]

KEYS: tuple[Key, ...] = (
    *CONSOLE,
    *TABLES,
    *RECORDING,
    *MAP,
    *PLACE,
    *EDIT,
    *DRIVE,
    *DIAGNOSTICS,
    *HISTORY,
    *ROWS,
)
BY_ID = {key.id: key for key in KEYS}


def outdone(chosen: Mapping[str, tuple[str, ...]], hidden: Collection[str]) -> frozenset[str]:
    """Return the ids of the keys that are not named, since another one that is offered has their action."""
    return frozenset(
        key.instead_of for key in KEYS if key.instead_of and chosen[key.id] and key.id not in hidden
    )
