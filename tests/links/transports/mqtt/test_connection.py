"""Tests of links/transports/mqtt/connection, against a real mosquitto."""

from pathlib import Path

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.text.errors import LinkError
from tests.support.broker import RealBroker, broker_in
from tests.support.broker_events import connecting
from tests.support.mqtt_peer import Peer
from tests.support.polling import until


async def test_a_broker_that_is_killed_is_found_again_and_nothing_is_sent_late(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        async with connecting(Link(broker.url)) as events:
            broker.kill()
            await until(lambda: events.lost)
            with pytest.raises(LinkError, match="no link"):
                await events.call(lambda: events.connection.publish("order", b"late"))
            await until(lambda: len(events.lost) >= 2)
            assert events.lost[0][0] == "connection lost" and events.lost[1][0] == "connection refused"
            assert all(wait <= 5.0 for _, wait in events.lost)
            broker.start()
            peer = Peer(broker.port, "#")
            await until(lambda: events.opened == 2)
            await events.call(lambda: events.connection.publish("now", b"new"))
            await until(lambda: peer.told)
            assert [one.topic for one in peer.told] == ["now"]
            peer.close()


async def test_a_second_console_throws_out_no_first_one(tmp_path: Path) -> None:
    broker = RealBroker(tmp_path)
    try:
        async with connecting(Link(broker.url)) as first, connecting(Link(broker.url)) as second:
            await until(lambda: first.answers and second.answers)
            assert not first.lost and not second.lost
    finally:
        broker.kill()
