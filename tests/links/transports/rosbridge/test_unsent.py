"""Bytes on their way: none to a computer that takes them, some to one that does not."""

import asyncio
from collections.abc import Callable

from websockets.asyncio.server import ServerConnection, serve

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.links.transports.rosbridge.unsent import unsent
from tests.support.polling import HANGS

MORE_THAN_BUFFERS = 2**26


class Opened:
    """A listener that waits for the connection."""

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        self._loop, self.opened = loop, asyncio.Event()

    def on_connecting(self) -> None: ...

    def on_open(self) -> None:
        self._loop.call_soon_threadsafe(self.opened.set)

    def on_lost(self, reason: str, next_try_in: float) -> None: ...

    def on_frame(self, payload: bytes, is_binary: bool) -> None: ...

    def on_sent(self, payload: bytes) -> None: ...

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None: ...


async def on_loop(do: Callable[[], int | None]) -> int | None:
    async def call() -> int | None:
        return do()

    return await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(call(), network_loop()))


async def test_what_is_not_read_is_on_its_way() -> None:
    is_deaf, done = asyncio.Event(), asyncio.Event()

    async def deaf(connection: ServerConnection) -> None:
        connection.transport.pause_reading()
        is_deaf.set()
        await done.wait()
        connection.transport.abort()  # deaf, it would not hear of a close either

    async with serve(deaf, "127.0.0.1", 0, max_size=None) as server:
        host, port = next(iter(server.sockets)).getsockname()
        listener = Opened(asyncio.get_running_loop())
        network_loop()
        connection = Connection(Link(f"ws://{host}:{port}"), listener)
        assert await on_loop(lambda: unsent(connection)) == 0
        await on_loop(connection.connect)
        async with asyncio.timeout(HANGS):
            await listener.opened.wait()
            await is_deaf.wait()
        await on_loop(lambda: connection.send(b" " * MORE_THAN_BUFFERS))
        assert await on_loop(lambda: unsent(connection))
        done.set()
        await on_loop(connection.shut)
