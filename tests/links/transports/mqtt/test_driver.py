"""Tests of links/transports/mqtt/session, against a real broker."""

import asyncio
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.mqtt import session
from tests.support.broker import BrokerAccess, BrokerTls, broker_in, free_port
from tests.support.broker_events import connecting
from tests.support.certificates import sign
from tests.support.mqtt_peer import Peer
from tests.support.polling import until


async def test_tls_with_a_certificate_of_the_client(tmp_path: Path) -> None:
    server, client = sign(tmp_path, "localhost"), sign(tmp_path, "console")
    tls = BrokerTls(server.cert_file, server.key_file, client.cert_file)
    with broker_in(tmp_path, BrokerAccess(tls=tls)) as broker:
        url = f"mqtts://127.0.0.1:{broker.port}"
        own = Link(url, client_cert=str(client.cert_file), client_key=str(client.key_file))
        async with connecting(replace(own, ca_file=str(server.cert_file))) as events:
            await events.subscribe("a")
            await events.call(lambda: events.connection.publish("a", b"x" * 100_000))
            await until(lambda: events.messages)
            assert len(events.messages[0][1]) == 100_000
        for link, reason in (
            (own, "certificate not trusted: set ca_file to its issuer"),
            (Link(url, ca_file=str(server.cert_file)), "connection dropped at once: client_cert required?"),
            (Link(broker.url), "connection dropped at once: not an MQTT broker, or mqtts://?"),
        ):
            async with connecting(link, wait=False) as events:
                await until(lambda: events.lost)
                assert reason in events.lost[0][0]


async def test_a_server_that_is_no_broker_is_named(tmp_path: Path) -> None:
    async def speak(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.read(1)
        writer.write(b"HTTP/1.1 400 Bad Request\r\n\r\n" * 20)
        writer.close()

    server = await asyncio.start_server(speak, "127.0.0.1", 0)
    port = server.sockets[0].getsockname()[1]
    async with connecting(Link(f"mqtt://127.0.0.1:{port}"), wait=False) as events:
        await until(lambda: events.lost)
        assert "not an MQTT broker" in events.lost[0][0]
    server.close()
    async with connecting(Link(f"mqtt://127.0.0.1:{free_port()}"), wait=False) as events:
        await until(lambda: events.lost)
        assert events.lost[0][0] == "connection refused"


async def test_messages_are_gathered_but_an_answer_to_us_is_read_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(session, "GATHER", 60.0)
    monkeypatch.setattr(session, "BEAT_EVERY", 60.0)
    with broker_in(tmp_path) as broker:
        peer = Peer(broker.port, "in/#")
        async with connecting(Link(broker.url)) as events:
            await until(lambda: events.answers)
            await events.subscribe("in/+")
            for n in range(3):
                peer.publish(f"in/{n}", b"")
                await until(lambda n=n: peer.told_on(f"in/{n}"))  # type: ignore[misc]  # a lambda's default
            assert not events.messages
            await events.call(lambda: events.connection.publish("out", b""))
            await until(lambda: len(events.messages) == 3)
        peer.close()
