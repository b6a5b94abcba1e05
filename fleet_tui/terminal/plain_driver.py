"""The driver for ASCII-only terminals: the console's own glyphs are sent as the nearest ASCII character.

Names and texts of robots are not changed.
"""

from fleet_tui.terminal.terminal_driver import TerminalDriver
from fleet_tui.text.ascii_fallback import PLAIN


class PlainDriver(TerminalDriver):
    """The driver for a terminal, with ASCII glyphs."""

    def write(self, data: str) -> None:
        """Send text, every glyph in ASCII. Each takes one cell, as before."""
        super().write(data.translate(PLAIN))
