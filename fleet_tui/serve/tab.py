"""A browser's tab: a console in a process of its own, connected by textual-serve's packets."""

import asyncio
import os
import signal
from asyncio.subprocess import PIPE, Process
from collections.abc import Sequence
from contextlib import suppress

from aiohttp import web
from textual_serve.app_service import AppService
from textual_serve.download_manager import DownloadManager

PATIENCE = 1.5
"""Seconds for a console to end by itself once its tab is closed."""
WIDEST = 1000
HIGHEST = 500
"""Maximum cells; a page may send any number."""

SETTINGS = {
    "TEXTUAL_DRIVER": "fleet_tui.terminal.browser_driver:BrowserDriver",
    "TEXTUAL_COLOR_SYSTEM": "truecolor",
    "TERM": "xterm-256color",
    "COLORTERM": "truecolor",
    "PYTHONIOENCODING": "utf-8",
}
_OUR_TERMINAL = ("TMUX", "STY", "TERM_PROGRAM", "TERM_PROGRAM_VERSION", "LINES")


class Tab(AppService):
    """Like textual-serve's, but without a shell, with a guaranteed end that the page is notified of."""

    def __init__(self, command: Sequence[str], websocket: web.WebSocketResponse) -> None:
        super().__init__(
            "",
            write_bytes=websocket.send_bytes,
            write_str=websocket.send_str,
            close=self._close,
            download_manager=DownloadManager(),
        )
        self._arguments = command
        self._websocket = websocket

    async def _close(self) -> None:
        """Close the page's end, with the reason."""
        await self._websocket.close(message=b"The console has ended.")

    def _build_environment(self, width: int = 80, height: int = 24) -> dict[str, str]:
        """Return our environment, secrets included: they are in no argument. Its terminal settings don't
        apply there."""
        ours = {name: value for name, value in os.environ.items() if name not in _OUR_TERMINAL}
        return {**ours, **SETTINGS, "COLUMNS": str(width), "ROWS": str(height)}

    async def _open_app_process(self, width: int = 80, height: int = 24) -> Process:
        width, height = within(width, height)
        self._process = await asyncio.create_subprocess_exec(
            *self._arguments,
            stdin=PIPE,
            stdout=PIPE,
            stderr=PIPE,
            env=self._build_environment(width, height),
            start_new_session=True,
        )
        self._stdin = self._process.stdin
        return self._process

    async def run(self) -> None:
        """Forward the console's output. When it ends, for any reason, the page must not look live."""
        await super().run()
        with suppress(ConnectionError):
            await self._close()

    async def stop(self) -> None:
        """Stop the process, by force if needed."""
        process = self._process
        if process is None:
            return
        with suppress(TimeoutError):
            async with asyncio.timeout(PATIENCE):
                await self.send_meta({"type": "quit"})
                await process.wait()
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)  # also its child processes
        if self._task is not None:
            self._task.cancel()
        with suppress(TimeoutError):
            await asyncio.wait_for(process.wait(), PATIENCE)

    async def on_message(self, message: object) -> None:
        """Handle a message of the page; others are ignored."""
        match message:
            case ["stdin", str(keys)]:
                await self.send_bytes(keys.encode("utf-8", "replace"))
            case ["resize", {"width": int(width), "height": int(height)}]:
                await self.set_terminal_size(*within(width, height))
            case ["ping", str(sent)]:
                await self._websocket.send_json(["pong", sent])
            case ["blur"]:
                await self.blur()
            case ["focus"]:
                await self.focus()


def within(width: int, height: int) -> tuple[int, int]:
    """Return a terminal size limited to one that can be painted."""
    return max(1, min(WIDEST, width)), max(1, min(HIGHEST, height))
