"""Every key of the console in one table, the source of bindings, help, palette, footer and config check."""

from typing import Any

from fleet_tui.keys.console import CONSOLE
from fleet_tui.keys.diagnostics import DIAGNOSTICS, PAGES
from fleet_tui.keys.key import LISTS, Key, Pane, by_id
from fleet_tui.keys.map import MAP
from fleet_tui.keys.recording import RECORDING
from fleet_tui.keys.rows import ROWS

__all__ = ["BY_ID", "DIAGNOSTICS", "KEYS", "LISTS", "PAGES", "ROWS", "Key", "Pane", "by_id"]

KEYS: tuple[Key[Any], ...] = (*CONSOLE, *RECORDING, *MAP, *DIAGNOSTICS, *ROWS)
BY_ID = {key.id: key for key in KEYS}
