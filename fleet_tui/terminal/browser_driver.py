"""The way to a browser's tab: packets on pipes, as textual-serve has them."""

import io
from collections.abc import Callable
from typing import Any

from textual import messages
from textual.app import App
from textual.drivers._writer_thread import WriterThread
from textual.drivers.web_driver import WebDriver

from fleet_tui.terminal.ending import PATIENCE, end_within


class _Packets(io.StringIO):
    """Takes text as a file does."""

    def __init__(self, send: Callable[[str], None]) -> None:
        super().__init__()
        self._send = send

    def write(self, text: str) -> int:
        """Send it as one packet."""
        self._send(text)
        return len(text)


class BrowserDriver(WebDriver):
    """Textual's own, which waits for a slow browser and outlives a dead server. This one doesn't."""

    def __init__(self, app: App[Any], **options: Any) -> None:
        super().__init__(app, **options)
        self._writer_thread = WriterThread(_Packets(super().write))

    def write(self, data: str) -> None:
        """Hand it to the writer. The app looks at its queue, and leaves pictures out while nobody reads."""
        self._writer_thread.write(data)

    def start_application_mode(self) -> None:
        """Begin. The first line is no packet: the writer comes after it."""
        super().start_application_mode()
        self._writer_thread.start()

    def stop_application_mode(self) -> None:
        """End: the last packet comes after the writer's."""
        self._writer_thread.stop()
        super().stop_application_mode()

    def run_input_thread(self) -> None:
        """Read until the server has gone, however suddenly: nobody could end the console then."""
        super().run_input_thread()
        if not self.exit_event.is_set():
            end_within(PATIENCE, 0)
            self._app.post_message(messages.ExitApp())
