"""Textual's driver for a terminal, also of a process that was stopped without being asked."""

import termios
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from textual.drivers.linux_driver import LinuxDriver

from fleet_tui.text.ascii_fallback import PLAIN


class TerminalDriver(LinuxDriver):
    """Starts again only what a suspension has ended. After a SIGSTOP Textual would read keys and write a
    second time, beside the first one, and take its own modes for those of the shell."""

    repaint: Callable[[], object] = staticmethod(lambda: None)
    """Sends every cell again; called on the loop."""
    _modes: list[Any] | None = None

    def start_application_mode(self) -> None:
        """Take the terminal, and remember its modes."""
        super().start_application_mode()  # type: ignore[no-untyped-call]  # untyped in Textual
        with suppress(termios.error):
            self._modes = termios.tcgetattr(self.fileno)

    def _sigcont_application(self, *arguments: object) -> None:
        """Go on after a stop: a shell may have used the terminal in between."""
        if self._must_signal_resume:
            super()._sigcont_application(*arguments)
            return
        if self._modes is not None:
            with suppress(termios.error):
                termios.tcsetattr(self.fileno, termios.TCSANOW, self._modes)
        self._loop.call_soon_threadsafe(self.repaint)


class PlainDriver(TerminalDriver):
    """The driver for a terminal, with ASCII glyphs."""

    def write(self, data: str) -> None:
        """Send text, every glyph in ASCII. Each takes one cell, as before."""
        super().write(data.translate(PLAIN))
