"""Tests of links/transports/mqtt/session, against a real broker."""

from pathlib import Path

from fleet_tui.config.schema import Link
from tests.support.broker import BrokerAccess, broker_in
from tests.support.broker_events import connecting
from tests.support.mqtt_peer import Peer
from tests.support.polling import until


async def test_what_peers_publish_arrives_and_what_is_retained_says_so(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        peer = Peer(broker.port, "out/#")
        peer.publish("in/old", b"kept", retain=True, qos=1)
        async with connecting(Link(broker.url)) as events:
            await events.subscribe("in/+", "other")
            await until(lambda: events.messages)
            peer.publish("in/new", b"fresh")
            await until(lambda: len(events.messages) == 2)
            assert events.messages == [("in/old", b"kept", True), ("in/new", b"fresh", False)]
            await events.call(lambda: events.connection.publish("out/a", b"ours"))
            await until(lambda: peer.told)
            assert events.sent == [("out/a", b"ours")] == [peer.told[0][:2]]
            await until(lambda: events.answers)
            assert 0 < events.answers[0] < 1
        peer.close()


async def test_a_frozen_broker_is_noticed(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        async with connecting(Link(broker.url)) as events:
            await until(lambda: events.answers)
            broker.freeze()
            await until(lambda: events.connection.silence > 1)
            await until(lambda: events.lost)
            assert events.lost[0][0] == "broker not responding"
            broker.thaw()
            await until(lambda: events.opened == 2)


async def test_a_wrong_password_names_the_keys_and_a_right_one_may_come_later(tmp_path: Path) -> None:
    user, password = tmp_path / "user", tmp_path / "password"
    for file, text in ((user, "ana"), (password, "wrong")):
        file.touch(mode=0o600)
        file.write_text(text)
    with broker_in(tmp_path, BrokerAccess(users=(("ana", "right"),))) as broker:
        async with connecting(Link(broker.url), wait=False) as events:
            await until(lambda: events.lost)
            assert events.lost[0][0] == "access denied: set user_file and password_file"
        known = Link(broker.url, user_file=str(user), password_file=str(password))
        async with connecting(known, wait=False) as events:
            await until(lambda: events.lost)
            assert events.lost[0][0] == "access denied: correct user_file and password_file"
            password.write_text("right")
            await until(lambda: events.opened)


async def test_a_subscription_that_the_broker_refuses_is_told(tmp_path: Path) -> None:
    with broker_in(tmp_path, BrokerAccess(refused="secret/#")) as broker:
        async with connecting(Link(broker.url)) as events:
            await events.subscribe("free/a", "secret/b")
            assert events.granted == {"free/a": True, "secret/b": False}
            await until(lambda: events.answers)


async def test_a_message_over_the_limit_is_dropped_with_its_size(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        async with connecting(Link(broker.url, max_message_mb=0.001)) as events:
            await events.subscribe("#")
            await events.call(lambda: events.connection.publish("map", b"x" * 2000))
            await events.call(lambda: events.connection.publish("state", b"x"))
            await until(lambda: events.messages)
            assert events.too_large == [("map", 2000)] and events.messages == [("state", b"x", False)]


async def test_what_is_unsubscribed_does_not_come_any_more(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        peer = Peer(broker.port, "out/#")
        async with connecting(Link(broker.url)) as events:
            await events.subscribe("in/a", "in/b")
            await events.call(lambda: events.connection.unsubscribe(["in/a"]))
            # What is sent later is handled later: by now the broker has let go.
            await events.call(lambda: events.connection.publish("out/done", b""))
            await until(lambda: peer.told)
            peer.publish("in/a", b"1")
            peer.publish("in/b", b"2")
            await until(lambda: events.messages)
            assert events.messages == [("in/b", b"2", False)]
        peer.close()
