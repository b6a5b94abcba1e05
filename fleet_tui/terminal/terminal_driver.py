"""Textual's driver for a terminal, also of a process that was stopped without being asked."""

from textual.drivers.linux_driver import LinuxDriver


class TerminalDriver(LinuxDriver):
    """Gives the terminal back before it takes it again."""

    def _sigcont_application(self, *_: object) -> None:
        """Go on after a stop. Before one by SIGTSTP the terminal was given back; after a SIGSTOP
        Textual would take its own modes for those of the shell, and leave them to it at the end."""
        if self._auto_restart and not self._must_signal_resume:
            self.suspend_application_mode()
            self._must_signal_resume = True
        super()._sigcont_application()
