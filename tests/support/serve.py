"""`fleet-tui serve` as a person starts it, and a page that speaks to it as textual.js does."""

import asyncio
import json
import signal
import time
from asyncio.subprocess import Process
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path

import pyte
from aiohttp import web
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed
from websockets.typing import Origin

from fleet_tui.features.serve.run import Consoles
from tests.support.cli import config_file, started

WIDTH, HEIGHT = 120, 40
WITHIN = 40.0
"""Seconds for anything: each console takes a second of a processor to start, and others want it too."""


class Served:
    """The page at an address."""

    def __init__(self, url: str) -> None:
        self.url = url
        self.place = url.removeprefix("http://").rstrip("/")

    @asynccontextmanager
    async def tab(self, origin: str | None = None) -> AsyncIterator["Page"]:
        """A page of its own, unless another origin is named."""
        address = f"ws://{self.place}/ws?width={WIDTH}&height={HEIGHT}"
        ours = Origin(origin or f"http://{self.place}")
        async with connect(address, origin=ours, open_timeout=WITHIN) as socket:
            page = Page(socket)
            reading = asyncio.create_task(page.read())
            yield page
        await reading


class Serving(Served):
    """A running `fleet-tui serve`."""

    def __init__(self, process: Process, url: str) -> None:
        super().__init__(url)
        self.process = process

    def consoles(self) -> list[int]:
        """The processes behind its tabs."""
        pid = self.process.pid
        return [int(one) for one in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]

    async def ended(self, *pids: int) -> None:
        """Wait until none of these processes is left."""
        await until(lambda: not any(map(_lives, pids)))

    async def stop(self, number: int = signal.SIGTERM) -> tuple[int, str]:
        """Ask it to end; its exit code, and what it said on stderr."""
        self.process.send_signal(number)
        _, err = await asyncio.wait_for(self.process.communicate(), WITHIN)
        return self.process.returncode or 0, err.decode()


class Page:
    """The text of a tab."""

    def __init__(self, socket: ClientConnection) -> None:
        self.socket = socket
        self.received = 0
        self.screen = pyte.Screen(WIDTH, HEIGHT)
        self._stream = pyte.ByteStream(self.screen)

    async def read(self) -> None:
        with suppress(ConnectionClosed):
            async for message in self.socket:
                if isinstance(message, bytes):
                    self.received += len(message)
                    self._stream.feed(message)

    def text(self) -> str:
        return "\n".join(self.screen.display)

    async def shows(self, detail: str) -> None:
        await until(lambda: detail in self.text(), lambda: f"{detail!r} in\n{self.text()}")

    async def closed(self) -> str:
        """Wait until the server has closed it; the reason."""
        await asyncio.wait_for(self.socket.wait_closed(), WITHIN)
        return self.socket.close_reason or ""

    async def say(self, *message: object) -> None:
        await self.socket.send(json.dumps(message))

    async def press(self, keys: str) -> None:
        await self.say("stdin", keys)

    async def resize(self, width: int, height: int) -> None:
        self.screen.resize(height, width)
        await self.say("resize", {"width": width, "height": height})


def _lives(process: int) -> bool:
    """Tell whether it runs. The system may take a while to remove it."""
    try:
        return b"\nState:\tZ" not in about(process, "status")
    except (FileNotFoundError, ProcessLookupError):
        return False


def about(process: int, what: str) -> bytes:
    """The system's data on a process."""
    return Path(f"/proc/{process}/{what}").read_bytes()


async def until(holds: Callable[[], object], what: Callable[[], str] = lambda: "") -> None:
    """Wait until it holds."""
    end = time.monotonic() + WITHIN
    while not holds():
        assert time.monotonic() < end, what()
        await asyncio.sleep(0.01)


@asynccontextmanager
async def serving(folder: Path, url: str, *args: str) -> AsyncIterator[Serving]:
    """A server on a free port for the robots behind `url`."""
    config_file(folder, url, robots=2, floors=2)
    process = await started(folder, "serve", "--port", "0", *args)
    assert process.stdout is not None
    line = await asyncio.wait_for(process.stdout.readline(), WITHIN)
    running = Serving(process, line.decode().strip())
    try:
        yield running
    finally:
        if process.returncode is None:
            await running.stop()


@asynccontextmanager
async def served_here(*command: str) -> AsyncIterator[Served]:
    """The page, served by this process; a tab opens a console by a command."""
    runner = web.AppRunner(Consoles(command).application("127.0.0.1"))
    await runner.setup()
    await web.TCPSite(runner, "127.0.0.1", 0).start()
    try:
        yield Served(f"http://127.0.0.1:{runner.addresses[0][1]}/")
    finally:
        await runner.cleanup()
