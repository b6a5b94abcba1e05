"""The connection to a browser's tab: packets on pipes, as used by textual-serve."""

import io
from collections.abc import Callable
from typing import Any

from textual import messages
from textual.app import App
from textual.drivers._writer_thread import WriterThread
from textual.drivers.web_driver import WebDriver

from fleet_tui.ui.terminal.ending import PATIENCE, end_within


class _Packets(io.StringIO):
    """Takes text like a file."""

    def __init__(self, send: Callable[[str], None]) -> None:
        super().__init__()
        self._send = send

    def write(self, text: str) -> int:
        """Send it as one packet."""
        self._send(text)
        return len(text)


class BrowserDriver(WebDriver):
    """Textual's driver waits for a slow browser and survives a dead server. This one doesn't."""

    def __init__(self, app: App[Any], **options: Any) -> None:
        super().__init__(app, **options)
        self._writer_thread = WriterThread(_Packets(super().write))

    def write(self, data: str) -> None:
        """Pass it to the writer. The app checks its queue, and skips pictures while the browser does not
        read."""
        self._writer_thread.write(data)

    def start_application_mode(self) -> None:
        """Begin. The first line is no packet: the writer starts after it."""
        super().start_application_mode()
        self._writer_thread.start()

    def stop_application_mode(self) -> None:
        """End: the last packet follows the writer's."""
        self._writer_thread.stop()
        super().stop_application_mode()

    def run_input_thread(self) -> None:
        """Read until the server ends, even suddenly: nothing else would end the console."""
        super().run_input_thread()
        if not self.exit_event.is_set():
            end_within(PATIENCE, 0)
            self._app.post_message(messages.ExitApp())
