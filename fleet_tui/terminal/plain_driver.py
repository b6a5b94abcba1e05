"""The driver for ASCII-only terminals: the console's own glyphs are sent as the nearest ASCII character.

Names and texts of robots are not changed.
"""

from textual.drivers.linux_driver import LinuxDriver

from fleet_tui.text.ascii_fallback import PLAIN


class PlainDriver(LinuxDriver):
    """Textual's driver, with ASCII glyphs."""

    def write(self, data: str) -> None:
        """Send text, every glyph in ASCII. Each takes one cell, as before."""
        super().write(data.translate(PLAIN))
