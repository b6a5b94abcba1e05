"""Network faults, and unexpected servers."""

import asyncio
import socket
import time
from collections.abc import Sequence
from itertools import pairwise
from types import SimpleNamespace

import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Link
from fleet_tui.links.rosbridge import probes as pulse
from fleet_tui.links.transports.rosbridge import connection as transport
from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import LinkChanged, MessageRejected
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.errors import LinkError
from tests.support.fault_proxy import UPGRADE, Attend, answer, before, drop, goodbye, mute
from tests.support.fault_report import report
from tests.support.invariants import linked
from tests.support.links import finished
from tests.support.polling import HANGS
from tests.support.proxied_link import Stopwatch, fresh, lost, through
from tests.support.watched_store import config_of


async def test_a_refused_port(server: RosbridgeServer) -> None:
    async with through(server) as (proxy, link, store, watch):
        watch.start()
        await proxy.refuse()
        noticed = await watch.until(lost("connection refused"))
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.NOT_SENT
        await proxy.listen()
        watch.start()
        healed = await watch.until(fresh())
    report("refused port", "the listener closes", "connection refused", noticed, healed)
    assert noticed < 3 and healed < 8


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (socket.gaierror(socket.EAI_NONAME, "not known"), "unknown host"),
        (socket.gaierror(socket.EAI_AGAIN, "failure"), "DNS lookup failed"),
    ],
)
async def test_dns_fails(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch, error: OSError, words: str
) -> None:
    real, fails = socket.getaddrinfo, True

    def look_up(*args: object, **more: object) -> object:
        if fails and args[0] == "localhost":
            raise error
        return real(*args, **more)  # type: ignore[arg-type]  # passed on as they came

    monkeypatch.setattr(socket, "getaddrinfo", look_up)
    async with before(server.url) as proxy, linked(config_of(proxy.url, 2)) as (_, store):
        watch = Stopwatch(store)
        noticed = await watch.until(lost(words))
        fails = False
        watch.start()
        healed = await watch.until(fresh())
    report(f"DNS: {error.strerror}", "the resolver reports it", words, noticed, healed)
    assert healed < 8


@pytest.mark.parametrize(
    ("name", "attend", "words"),
    [
        ("says nothing", mute, "reached, but no answer"),
        ("HTTP 200", answer("200 OK"), "a web server, not rosbridge (HTTP 200)"),
        ("HTTP 401", answer("401 No"), "access denied (HTTP 401): set authorization_file"),
        ("HTTP 404", answer("404 Not Found"), "path not found, correct url (HTTP 404)"),
        ("HTTP 502", answer("502 Bad"), "rosbridge down behind a web server (HTTP 502)"),
        (
            "wrong subprotocol",
            answer("101 Switching", *UPGRADE, "Sec-WebSocket-Protocol: chat"),
            "not rosbridge: wrong subprotocol",
        ),
        (
            "wrong Sec-WebSocket-Accept",
            answer("101 Switching", *UPGRADE[:2], "Sec-WebSocket-Accept: AAAA"),
            "not rosbridge: wrong Sec-WebSocket-Accept",
        ),
        ("drops at once", drop, "connection dropped at once: not rosbridge, or wss://?"),
    ],
)
async def test_another_server(server: RosbridgeServer, name: str, attend: Attend, words: str) -> None:
    async with through(server) as (proxy, _, _, watch):
        proxy.attend = attend
        watch.start()
        proxy.cut()
        noticed = await watch.until(lost(words))
        proxy.attend = proxy.relay
        watch.start()
        healed = await watch.until(fresh())
    report(f"handshake: {name}", "the server does so after a disconnect", words, noticed, healed)
    assert noticed < 10 and healed < 8


async def test_killed_inside_a_frame(server: RosbridgeServer) -> None:
    async with through(server) as (proxy, link, store, watch):
        server.bridge.services.silent_services.add("/robot_0/Application_layout/Pause")
        command = link.submit(PauseRobot("robot_0"))
        await store.until(lambda _: server.bridge.services.calls)
        faults = store.state.links["rosbridge"].faults
        watch.start()
        proxy.cut_after = 301
        noticed = await watch.until(lost("connection lost"))
        await store.until(lambda state: Stage.UNKNOWN in [step.stage for step in state.commands[-1].steps])
        watch.start()
        healed = await watch.until(fresh())
        assert store.state.links["rosbridge"].faults == faults
        assert store.state.commands[-1].id == command
    assert len(server.bridge.services.calls) == 1
    report("connection cut inside a frame", "reset after 301 more bytes", "connection lost", noticed, healed)
    assert noticed < 2 and healed < 4


async def test_a_goodbye_without_hanging_up(server: RosbridgeServer) -> None:
    """For seconds the connection stands, and takes nothing any more: a command is not lost in it."""
    agreed = asyncio.Semaphore(0)
    async with through(server) as (proxy, link, store, watch):
        proxy.attend = goodbye(agreed.release)
        watch.start()
        proxy.cut()
        for _ in ("commands", "topics"):
            await agreed.acquire()
        record = await finished(link, store, PauseRobot("robot_0"))
        assert (record.stage, record.detail) == (Stage.NOT_SENT, "no link")
        noticed = await watch.until(lost("server not responding"))
        proxy.attend = proxy.relay
        watch.start()
        healed = await watch.until(fresh())
    seen = "server not responding"
    report(
        "WebSocket close without disconnect",
        "the server sends Close and keeps the connection open",
        seen,
        noticed,
        healed,
    )
    assert noticed < 10 and healed < 8


async def test_a_half_open_connection(server: RosbridgeServer) -> None:
    async with through(server) as (proxy, link, store, watch):
        watch.start()
        proxy.swallows = True
        is_lost = lost("server not responding")
        await watch.until(
            lambda state: is_lost(state) or state.now - (state.links["rosbridge"].last_received or 0) > 2.1
        )
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.NOT_SENT
        noticed = await watch.until(is_lost)
        proxy.swallows = False
        watch.start()
        healed = await watch.until(fresh())
    assert noticed < 10 and healed < 12
    seen = "the age of the last message grows; then server not responding"
    report("half-open connection", "packets vanish both ways", seen, noticed, healed)
    assert not server.bridge.services.calls


async def test_a_slow_server(server: RosbridgeServer) -> None:
    """One byte a second: every age grows, robots go offline, and no command is put into it."""
    async with through(server) as (proxy, link, store, watch):
        watch.start()
        proxy.bytes_per_second = 1
        proxy.cut()
        noticed = await watch.until(lost("reached, but no answer"))
        proxy.bytes_per_second = 0
        watch.start()
        healed = await watch.until(fresh())
        proxy.bytes_per_second = 1
        watch.start()
        await watch.until(lambda state: not any(map(state.is_online, state.robots.values())))
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.NOT_SENT
    report(
        "slow server",
        "it sends 1 byte a second",
        "reached, but no answer; robots offline with their age",
        noticed,
        healed,
    )
    assert noticed < 12 and healed < 12


async def test_a_long_message_is_no_dead_server(server: RosbridgeServer) -> None:
    """The answer to a ping waiting behind a map: a line that still brings bytes is not given up."""

    async def slowly(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await proxy.relay(reader, _Slow(writer))  # type: ignore[arg-type]  # a writer that takes its time

    async with before(server.url) as proxy:
        proxy.attend = slowly
        async with linked(config_of(proxy.url, 1)) as (_, store):
            await store.until(lambda state: state.robots["robot_0"].pose)
            frame = '{"op":"publish","topic":"/robot_0/cargo","msg":{"data":true,"x":"%s"}}' % (
                "x" * int(60_000 * (transport.PING_INTERVAL + transport.PING_TIMEOUT + 1))
            )
            server.bridge.publish_raw("/robot_0/cargo", frame)
            await store.until(lambda state: state.robots["robot_0"].has_cargo, within=HANGS)
            assert store.state.links["rosbridge"].phase is Phase.UP
            assert [change.phase for change in _changes(store.events)] == [Phase.CONNECTING, Phase.UP]


class _Slow:
    """A writer over which 60,000 bytes take a second."""

    def __init__(self, writer: asyncio.StreamWriter) -> None:
        self._writer = writer
        self.transport = SimpleNamespace(abort=writer.transport.abort)

    def write(self, data: bytes) -> None:
        self._data = data

    async def drain(self) -> None:
        due = time.monotonic()
        for start in range(0, len(self._data), 3000):
            self._writer.write(self._data[start : start + 3000])
            await self._writer.drain()
            due += 0.05  # by the clock: each sleep of a busy machine is longer than it should be
            await asyncio.sleep(due - time.monotonic())


def _changes(events: Sequence[object]) -> list[LinkChanged]:
    return [event for event in events if isinstance(event, LinkChanged)]


async def test_a_reconnect_storm(server: RosbridgeServer) -> None:
    """A server that accepts and drops at once: each of the two connections tries once a second at most."""
    async with before(server.url) as proxy, linked(config_of(proxy.url)) as (_, store):
        proxy.attend = drop
        watch = Stopwatch(store)
        noticed = await watch.until(lost())
        await watch.until(lambda _: len(proxy.tries) >= 8)
        proxy.attend = proxy.relay
        watch.start()
        healed = await watch.until(fresh(1))
    tries = [change.at for change in _changes(store.events) if change.phase is Phase.CONNECTING]
    assert all(later - earlier >= transport.FIRST_DELAY for earlier, later in pairwise(tries))
    gaps = {round(later - earlier, 3) for earlier, later in pairwise(tries)}
    assert len(gaps) > 1, "without chance all consoles would come at once"
    report(
        "reconnect storm", "accepts and drops at once", "connection dropped at once, retry", noticed, healed
    )


async def test_a_message_over_the_limit_costs_only_itself(server: RosbridgeServer) -> None:
    small = Link(server.url, max_message_mb=0.05)
    async with linked(replace(config_of(server.url, 2), rosbridge=small)) as (link, store):
        await store.until(fresh())
        watch = Stopwatch(store)
        for _ in range(3):
            server.bridge.publish_raw(
                "/robot_1/cargo", '{"op":"publish","topic":"/robot_1/cargo"%s}' % (" " * 60_000)
            )
        noticed = await watch.until(lambda state: state.robots["robot_1"].faults == 3)
        link.show_map("robot_0", "floor_0")
        server.bridge.publish_raw(
            "/robot_0/pose", b"\xa2\x62op\x67publish\x65topic\x6d/robot_0/pose" + bytes(70_000)
        )
        await store.until(lambda state: state.robots["robot_0"].faults >= 2)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        assert len([change for change in _changes(store.events) if change.phase is Phase.UP]) == 1
    said = {event.text for event in store.events if isinstance(event, MessageRejected)}
    remedy = "exceeds the limit of 0.05 MB: raise rosbridge.max_message_mb"
    assert said == {
        f"/robot_1/cargo: a message of 0.1 MB {remedy}",
        f"/robot_0/pose: a message of 0.1 MB {remedy}",
        f"/robot_0/floor_0/map: a message of 0.4 MB {remedy}",
    }
    report(
        "message over the limit", "60 kB at a limit of 50 kB", f"a message of 0.1 MB {remedy}", noticed, None
    )


async def test_a_command_path_of_its_own_fault(server: RosbridgeServer) -> None:
    """Telemetry flows while calls are not answered: said at once, commands are held back, a pause is not."""
    async with through(server) as (_, link, store, watch):
        server.bridge.services.silent_services.update(pulse.EVERY_QUESTION)
        watch.start()
        noticed = await watch.until(
            lambda state: state.links["rosbridge"].command_path is CommandPath.DEAD, within=HANGS
        )
        assert "no reply from the bridge" in (await finished(link, store, ResumeRobot("robot_0"))).detail
        server.bridge.services.silent_services.clear()
        watch.start()
        healed = await watch.until(fresh(), within=HANGS)
    report(
        "calls are not answered",
        "no call is answered",
        "commands dead: no reply from the bridge to calls",
        noticed,
        healed,
    )


def test_nothing_is_sent_without_a_connection() -> None:
    connection = transport.Connection(Link("ws://127.0.0.1:9"), _Deaf())
    with pytest.raises(LinkError):
        connection.send(b"late")


class _Deaf:
    def on_connecting(self) -> None: ...
    def on_open(self) -> None: ...
    def on_lost(self, reason: str, next_try_in: float) -> None: ...
    def on_frame(self, payload: bytes, is_binary: bool) -> None: ...
    def on_sent(self, payload: bytes) -> None: ...
    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None: ...
