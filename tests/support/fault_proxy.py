"""A TCP proxy before a real server that does to connections what networks and other servers do."""

import asyncio
import base64
import hashlib
import ssl
import time
from collections.abc import AsyncIterator, Awaitable, Callable, Sequence
from contextlib import asynccontextmanager, suppress

Attend = Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]]


class FaultProxy:
    """Passes everything on to `port` of this machine, unless told otherwise. Change it while it runs."""

    def __init__(self, port: int, tls: ssl.SSLContext | None = None) -> None:
        self.attend: Attend = self.relay
        """The treatment of every new connection."""
        self.tries: list[float] = []
        """When each connection came, in monotonic seconds."""
        self.swallows = False
        """Half-open: nothing gets through, and nobody is told."""
        self.bytes_per_second = 0
        """Speed at which the server is heard; 0 is as fast as it can be."""
        self.cut_after: int | None = None
        """The server is heard for so many bytes more, then every connection is cut: inside a frame."""
        self._port, self._tls, self._own_port = port, tls, 0
        self._server: asyncio.Server | None = None
        self._writers: set[asyncio.StreamWriter] = set()

    @property
    def url(self) -> str:
        return f"{'wss' if self._tls else 'ws'}://localhost:{self._own_port}"

    async def listen(self) -> None:
        """Begin, or begin again on the same port."""
        self._server = await asyncio.start_server(self._take, "127.0.0.1", self._own_port, ssl=self._tls)
        self._own_port = self._server.sockets[0].getsockname()[1]

    async def refuse(self) -> None:
        """Nobody listens any more, and who is connected is cut off."""
        assert self._server is not None
        self._server.close()
        self.cut()
        await self._server.wait_closed()

    def cut(self) -> None:
        """Every connection ends without a goodbye."""
        for writer in self._writers:
            writer.transport.abort()

    async def _take(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self.tries.append(time.monotonic())
        self._writers.add(writer)
        try:
            with suppress(OSError, asyncio.IncompleteReadError):
                await self.attend(reader, writer)
        finally:
            self._writers.discard(writer)
            writer.transport.abort()

    async def relay(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """Pass everything on."""
        from_server, to_server = await asyncio.open_connection("127.0.0.1", self._port)
        self._writers.add(to_server)
        ways = [self._pass(reader, to_server, False), self._pass(from_server, writer, True)]
        try:
            await asyncio.wait([asyncio.ensure_future(way) for way in ways], return_when="FIRST_COMPLETED")
        finally:
            self._writers.discard(to_server)
            to_server.transport.abort()

    async def _pass(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, received: bool) -> None:
        with suppress(OSError):
            while data := await reader.read((received and self.bytes_per_second) or 65536):
                if self.swallows:
                    continue
                if received and self.cut_after is not None:
                    data = data[: self.cut_after]
                    self.cut_after -= len(data)
                writer.write(data)
                await writer.drain()
                if received and self.cut_after == 0:
                    self.cut_after = None
                    self.cut()
                if received and self.bytes_per_second:
                    await asyncio.sleep(1.0)


async def mute(reader: asyncio.StreamReader, _: asyncio.StreamWriter) -> None:
    """Take the connection and say nothing."""
    while await reader.read(65536):
        pass


async def drop(_: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    """Drop the connection at once."""
    writer.transport.abort()


def answer(status: str, *headers: str) -> Attend:
    """Answer the handshake so, as another kind of server does. `{accept}` is the right answer to the key."""

    async def attend(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await _shake_hands(reader, writer, status, headers)
        await reader.read()

    return attend


async def _shake_hands(
    reader: asyncio.StreamReader, writer: asyncio.StreamWriter, status: str, headers: Sequence[str]
) -> None:
    request = (await reader.readuntil(b"\r\n\r\n")).decode()
    key = next(line[19:] for line in request.splitlines() if line.lower().startswith("sec-websocket-key"))
    magic = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
    accept = base64.b64encode(hashlib.sha1((key + magic).encode()).digest()).decode()
    lines = [f"HTTP/1.1 {status}", *headers, "Content-Length: 0", "", ""]
    writer.write("\r\n".join(lines).replace("{accept}", accept).encode())
    await writer.drain()


UPGRADE = ("Upgrade: websocket", "Connection: Upgrade", "Sec-WebSocket-Accept: {accept}")


def goodbye(agreed: Callable[[], None]) -> Attend:
    """Open a WebSocket, close it, and do not hang up; `agreed`: the other side has closed it, too."""

    async def attend(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await _shake_hands(reader, writer, "101 Switching", UPGRADE)
        writer.write(b"\x88\x02\x03\xe8")
        await reader.readuntil(b"\x88\x82")
        agreed()
        await reader.read()

    return attend


@asynccontextmanager
async def before(url: str, tls: ssl.SSLContext | None = None) -> AsyncIterator[FaultProxy]:
    """A proxy before the server at a url."""
    proxy = FaultProxy(int(url.rpartition(":")[2]), tls)
    await proxy.listen()
    try:
        yield proxy
    finally:
        await proxy.refuse()
