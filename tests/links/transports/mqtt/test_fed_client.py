"""Tests of links/transports/mqtt/fed_client, against a server that sends exactly these bytes."""

import asyncio
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager

import pytest

from fleet_tui.config.schema import Link
from tests.support.broker_events import BrokerEvents, connecting
from tests.support.polling import until

CONNACK, PUBACK = b"\x20\x02\x00\x00", b"\x40\x02\x00\x07"
NUMBER = b"\x00\x07"
"""The id of a message with QoS 1."""


def packet(first: int, body: bytes) -> bytes:
    length, left = bytearray(), len(body)
    while True:
        left, low = divmod(left, 128)
        length.append(low | (128 if left else 0))
        if not left:
            return bytes([first, *length]) + body


def message(topic: bytes, payload: bytes, first: int = 0x30, number: bytes = b"") -> bytes:
    return packet(first, len(topic).to_bytes(2, "big") + topic + number + payload)


@asynccontextmanager
async def told(pieces: Sequence[bytes]) -> AsyncIterator[tuple[BrokerEvents, bytearray]]:
    """The events of a connection to a server that sends these pieces one by one after its greeting, and what
    it has received."""
    received = bytearray()

    async def speak(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        received.extend(await reader.read(1000))
        for piece in (CONNACK, *pieces):
            writer.write(piece)
            await writer.drain()
            await asyncio.sleep(0)
        while data := await reader.read(1000):
            received.extend(data)
        writer.close()

    server = await asyncio.start_server(speak, "127.0.0.1", 0)
    async with server:
        port = server.sockets[0].getsockname()[1]
        async with connecting(Link(f"mqtt://127.0.0.1:{port}"), wait=False) as events:
            yield events, received


async def test_messages_arrive_in_their_order_however_they_are_cut() -> None:
    large = b"x" * 300_000
    whole = b"".join(
        [
            message(b"a", b"1"),
            message(b"b", b"", 0x31),
            message(b"c", b"3", 0x32, NUMBER),
            message(b"d/\xc3\xa9", b"4", 0x33, NUMBER),
            message(b"e", large),
            message(b"f", b"6", 0x38),
        ]
    )
    wanted = [
        *(("a", b"1", False), ("b", b"", True), ("c", b"3", False)),
        *(("d/é", b"4", True), ("e", large, False), ("f", b"6", False)),
    ]
    single = [whole[n : n + 1] for n in range(60)] + [whole[60:]]
    for pieces in ([whole], single, [whole[:1000], whole[1000:-4], whole[-4:]]):
        async with told(pieces) as (events, received):
            await until(lambda events=events: len(events.messages) == len(wanted))  # type: ignore[misc]  # a lambda's default
            assert events.messages == wanted and not events.lost
            await until(lambda received=received: received.count(PUBACK) == 2)  # type: ignore[misc]  # as above


async def test_a_topic_that_is_no_text_is_passed_over() -> None:
    async with told([message(b"\xff", b"1"), message(b"\xff", b"2", 0x32, NUMBER), message(b"a", b"3")]) as (
        events,
        _,
    ):
        await until(lambda: events.messages)
        assert events.messages == [("a", b"3", False)] and not events.lost


@pytest.mark.parametrize(
    "bad",
    [
        b"\x30\xff\xff\xff\xff\x7f" + b"x" * 10,  # a length of five bytes
        packet(0x30, b"\x00\x09a"),  # a topic longer than its packet
        packet(0x30, b""),
        packet(0xF0, b"x"),  # a type that does not exist
    ],
)
async def test_what_is_not_mqtt_ends_the_connection(bad: bytes) -> None:
    async with told([message(b"a", b"1"), bad, message(b"b", b"2")]) as (events, _):
        await until(lambda: events.lost)
        assert events.lost[0][0] == "connection lost"
        assert events.messages[:1] == [("a", b"1", False)] and ("b", b"2", False) not in events.messages
