"""The seam to roslibpy: each of its gaps, closed. An upgrade that changes one goes red here."""

import asyncio
import logging
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from typing import Any

import pytest
import roslibpy
import websockets
from websockets.asyncio.server import ServerConnection, serve

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.links.transports.rosbridge.connection import LONGEST_DELAY, Connection
from fleet_tui.text.errors import LinkError
from tests.support.polling import HANGS


class Ear:
    """A listener that keeps what it hears, for the test's own loop to wait on."""

    def __init__(self) -> None:
        self._loop = asyncio.get_running_loop()
        self._queue: asyncio.Queue[tuple[Any, ...]] = asyncio.Queue()

    def _put(self, *what: Any) -> None:
        self._loop.call_soon_threadsafe(self._queue.put_nowait, what)

    def on_connecting(self) -> None:
        self._put("connecting")

    def on_open(self) -> None:
        self._put("open")

    def on_lost(self, reason: str, next_try_in: float) -> None:
        self._put("lost", reason, next_try_in)

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        self._put("frame", payload, is_binary)

    def on_sent(self, payload: bytes) -> None:
        self._put("sent", payload)

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        self._put("too large", head, is_binary, size)

    async def next(self, kind: str) -> tuple[Any, ...]:
        """The next of a kind; what comes before it is passed over."""
        async with asyncio.timeout(HANGS):
            while (received := await self._queue.get())[0] != kind:
                pass
        return received[1:]


async def on_loop(function: Callable[..., Any], *args: Any) -> Any:
    """Call on the network loop and wait for the result."""

    async def call() -> Any:
        return function(*args)

    return await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(call(), network_loop()))


@asynccontextmanager
async def connected(bridge: str | Link) -> AsyncIterator[tuple[Connection, Ear]]:
    ear = Ear()
    network_loop()
    connection = Connection(bridge if isinstance(bridge, Link) else Link(bridge), ear)
    await on_loop(connection.connect)
    try:
        yield connection, ear
    finally:
        await on_loop(connection.shut)


@asynccontextmanager
async def a_server(attend: Callable[[ServerConnection], Any], port: int = 0) -> AsyncIterator[str]:
    async with serve(attend, "127.0.0.1", port) as running:
        yield f"ws://127.0.0.1:{next(iter(running.sockets)).getsockname()[1]}"


async def _keep_open(connection: ServerConnection) -> None:
    await connection.wait_closed()


def test_the_pinned_version_is_the_one_that_was_studied() -> None:
    assert roslibpy.__version__ == "2.1.0"


async def test_without_a_link_nothing_is_kept_for_later() -> None:
    got: list[list[str | bytes]] = []  # by connection: others of this machine may know the port

    async def attend(connection: ServerConnection) -> None:
        frames: list[str | bytes] = []
        got.append(frames)
        async for frame in connection:
            frames.append(frame)
            await connection.send("{}")

    async with a_server(_keep_open) as url:
        pass
    port = int(url.rpartition(":")[2])
    async with connected(url) as (connection, ear):
        assert (await ear.next("lost"))[0] == "connection refused"
        call = roslibpy.ServiceRequest({})
        for send in (
            lambda: connection.send(b"late"),
            lambda: connection.send_on_ready(roslibpy.Message({"op": "publish"})),
            lambda: roslibpy.Service(connection, "/pause", "std_srvs/Trigger").call(call, print, print),
            lambda: roslibpy.Topic(connection, "/t", "std_msgs/Bool").publish(roslibpy.Message({})),
        ):
            with pytest.raises(LinkError, match="no link"):
                await on_loop(send)
        async with a_server(attend, port):
            await ear.next("open")
            await on_loop(connection.send, b"now")
            await ear.next("frame")
    assert ["now"] in got and not any("late" in frames or b"late" in frames for frames in got)


async def test_the_next_try_is_never_further_than_five_seconds() -> None:
    async with connected("ws://127.0.0.1:9") as (connection, ear):
        delays = []
        await ear.next("lost")
        for _ in range(8):
            # Straight to the delay that the next failure would give: waiting them out takes a minute.
            await on_loop(connection.factory._schedule_reconnect)
            delays.append((await ear.next("lost"))[1])
        await on_loop(connection.factory.stop)
    assert delays[0] >= 1.0
    assert max(delays) <= LONGEST_DELAY
    assert delays[-1] > 4.0


async def test_a_binary_frame_arrives_whole() -> None:
    async def attend(connection: ServerConnection) -> None:
        await connection.send(b"\xa1\x00\x01")
        await connection.send("text")
        await connection.wait_closed()

    async with a_server(attend) as url, connected(url) as (_, ear):
        assert await ear.next("frame") == (b"\xa1\x00\x01", True)
        assert await ear.next("frame") == (b"text", False)


async def test_a_compressed_message_over_the_limit_is_passed_over_without_compression() -> None:
    async def attend(connection: ServerConnection) -> None:
        await connection.send(" " * 60_000)
        await connection.send("small")
        await connection.wait_closed()

    async with serve(attend, "127.0.0.1", 0, compression="deflate") as running:
        port = next(iter(running.sockets)).getsockname()[1]
        async with connected(Link(f"ws://127.0.0.1:{port}", max_message_mb=0.05)) as (_, ear):
            head, is_binary, size = await ear.next("too large")
            assert (head.strip(), is_binary, size) == (b"", False, 60_000)
            assert await ear.next("frame") == (b"small", False)


async def test_a_message_in_parts_is_counted_whole() -> None:
    async def attend(connection: ServerConnection) -> None:
        await connection.send("x" * 40_000 for _ in range(3))
        await connection.send("small")
        await connection.wait_closed()

    async with serve(attend, "127.0.0.1", 0, compression=None) as running:
        port = next(iter(running.sockets)).getsockname()[1]
        async with connected(Link(f"ws://127.0.0.1:{port}", max_message_mb=0.05)) as (_, ear):
            head, _, size = await ear.next("too large")
            assert (head, size) == (b"x" * 1000, 120_000)
            assert await ear.next("frame") == (b"small", False)


async def test_any_operation_reaches_the_listener_and_nothing_reaches_stderr(
    capfd: pytest.CaptureFixture[str],
) -> None:
    async def attend(connection: ServerConnection) -> None:
        await connection.send('{"op":"status","level":"error","msg":"no"}')
        await connection.send('{"op":"fragment"}')
        await connection.wait_closed()

    async with a_server(attend) as url, connected(url) as (_, ear):
        assert b"status" in (await ear.next("frame"))[0]
        assert b"fragment" in (await ear.next("frame"))[0]
    assert capfd.readouterr().err == ""


async def test_an_error_in_a_listener_costs_only_its_frame(caplog: pytest.LogCaptureFixture) -> None:
    class Broken(Ear):
        def on_frame(self, payload: bytes, is_binary: bool) -> None:
            super().on_frame(payload, is_binary)
            raise ValueError("a bug of ours")

    async def attend(connection: ServerConnection) -> None:
        await connection.send("one")
        await connection.send("two")
        await connection.wait_closed()

    async with a_server(attend) as url:
        ear = Broken()
        connection = Connection(Link(url), ear)
        with caplog.at_level(logging.ERROR):
            await on_loop(connection.connect)
            assert await ear.next("frame") == (b"one", False)
            assert await ear.next("frame") == (b"two", False)
        await on_loop(connection.shut)
    assert "a bug of ours" in caplog.text


async def test_a_frozen_server_is_noticed() -> None:
    """One that takes the connection and then neither reads nor answers pings."""
    frozen: list[asyncio.StreamWriter] = []

    async def attend(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        request = (await reader.readuntil(b"\r\n\r\n")).decode()
        key = next(
            line.split(": ")[1]
            for line in request.split("\r\n")
            if line.lower().startswith("sec-websocket-key")
        )
        answer = websockets.utils.accept_key(key)
        writer.write(
            b"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            + f"Sec-WebSocket-Accept: {answer}\r\n\r\n".encode()
        )
        # Held, so that nobody closes it.
        frozen.append(writer)

    server = await asyncio.start_server(attend, "127.0.0.1", 0)
    async with server:
        url = f"ws://127.0.0.1:{server.sockets[0].getsockname()[1]}"
        async with connected(url) as (_, ear):
            await ear.next("open")
            reason, _ = await ear.next("lost")
        # A server waits for its connections before it ends.
        for writer in frozen:
            writer.close()
    assert frozen
    assert reason == "server not responding"


async def test_a_server_that_is_no_rosbridge_is_named() -> None:
    async def attend(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.readuntil(b"\r\n\r\n")
        writer.write(b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n")
        await writer.drain()

    server = await asyncio.start_server(attend, "127.0.0.1", 0)
    async with server, connected(f"ws://127.0.0.1:{server.sockets[0].getsockname()[1]}") as (_, ear):
        reason, _ = await ear.next("lost")
    assert reason == "path not found, correct url (HTTP 404)"


async def test_an_unknown_host_is_named() -> None:
    async with connected("ws://no-such-host.invalid:9090") as (_, ear):
        assert (await ear.next("lost"))[0] == "unknown host"
