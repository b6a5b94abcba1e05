"""The way to a bridge step by step: the first failure is named with its remedy, later steps are not tried."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.approach import STEPS, Approach
from fleet_tui.links.discovery.finding import Finding, Verdict
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.simulator.server import RosbridgeServer

Peer = Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]]


async def walked(url: str) -> dict[str, Finding]:
    """The findings of the steps to an address."""

    async def walk() -> list[Finding]:
        bridge = Link(url)
        wire = BridgeConnection(bridge)
        try:
            return [finding async for finding in Approach("rosbridge", bridge, wire).walk()]
        finally:
            wire.close()

    found = await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(walk(), network_loop()))
    return {finding.check: finding for finding in found}


@asynccontextmanager
async def peer(serve: Peer) -> AsyncIterator[int]:
    """A port on which something else than a bridge listens."""
    server = await asyncio.start_server(serve, "127.0.0.1", 0)
    async with server:
        yield server.sockets[0].getsockname()[1]


def failed(found: dict[str, Finding]) -> tuple[str, str]:
    """The step that failed, with all that is said of it; those after it are skipped."""
    verdicts = [found[step].verdict for step in STEPS if step in found]
    at = verdicts.index(Verdict.FAIL)
    assert verdicts == [Verdict.OK] * at + [Verdict.FAIL] + [Verdict.SKIPPED] * (len(verdicts) - at - 1)
    finding = list(found.values())[at]
    return finding.check, f"{finding.measured}; {finding.remedy}"


async def test_every_step_to_a_bridge_is_well(server: RosbridgeServer) -> None:
    found = await walked(server.url)
    assert list(found) == [step for step in STEPS if step != "tls"]
    assert {finding.verdict for finding in found.values()} == {Verdict.OK}
    assert found["name"].measured == "127.0.0.1 is an IP address"
    named = await walked(server.url.replace("127.0.0.1", "localhost"))
    assert "127.0.0.1" in named["name"].measured


async def test_nothing_listens_or_the_name_is_unknown() -> None:
    async def hang_up(_reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.close()

    async with peer(hang_up) as port:
        pass
    step, detail = failed(await walked(f"ws://127.0.0.1:{port}"))
    assert step == "tcp" and "refused" in detail and "start rosbridge on it" in detail
    step, detail = failed(await walked(f"ws://{'a' * 64}.invalid:{port}"))
    assert step == "name" and "correct rosbridge.url, or the name in DNS" in detail


async def test_a_web_server_is_no_bridge() -> None:
    async def page(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.read(1)
        writer.write(b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nhi")
        writer.close()

    async with peer(page) as port:
        step, detail = failed(await walked(f"ws://127.0.0.1:{port}"))
    assert step == "websocket" and "correct host, port and path in rosbridge.url" in detail


async def test_a_port_that_accepts_and_stays_silent_is_frozen() -> None:

    async def silent(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.read()
        writer.close()

    async with peer(silent) as port:
        step, detail = failed(await walked(f"ws://127.0.0.1:{port}"))
    assert step == "websocket" and "does not respond" in detail and "if it is not rosbridge" in detail


async def test_a_bridge_whose_master_is_gone_or_that_answers_no_call(server: RosbridgeServer) -> None:
    server.bridge.services.master_alive = False
    step, detail = failed(await walked(server.url))
    assert step == "rosbridge" and "start roscore, then the robot nodes" in detail
