"""For terminals that show ASCII alone: what the console itself draws with is sent as the nearest ASCII sign.

The names and words of robots are left as they are: they are the site's own.
"""

from textual.drivers.linux_driver import LinuxDriver

from fleet_tui.text.ascii_fallback import PLAIN


class PlainDriver(LinuxDriver):
    """Textual's own, but for the signs."""

    def write(self, data: str) -> None:
        """Send it, every sign in ASCII. Each takes one cell, as before."""
        super().write(data.translate(PLAIN))
