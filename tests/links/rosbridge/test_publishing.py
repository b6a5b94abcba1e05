"""Publications whose first message may be lost: repeated, in the order in which they were given."""

import asyncio
import json
from typing import Any, cast

import pytest

from fleet_tui.links.rosbridge import publishing
from fleet_tui.links.rosbridge.publishing import Publishing
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.robots.adapter import Publication


class Sent:
    """A connection that keeps what is sent on it."""

    def __init__(self) -> None:
        self.frames: list[dict[str, Any]] = []
        self.came = asyncio.Event()

    def send(self, frame: bytes) -> None:
        self.frames.append(json.loads(frame))
        self.came.set()

    def published(self) -> list[object]:
        return [one["msg"]["data"] for one in self.frames if one["op"] == "publish"]


def lock(on: object, topic: str = "/robot_0/lock") -> Publication:
    return Publication(topic, "std_msgs/Bool", {"data": on})


@pytest.fixture
def sent() -> Sent:
    return Sent()


@pytest.fixture
def publisher(sent: Sent) -> Publishing:
    return Publishing(cast("Connection", sent), [("/robot_0/lock", "std_msgs/Bool")])


async def until_repeated(sent: Sent, count: int) -> None:
    async with asyncio.timeout(2.0):
        while len(sent.published()) < count:
            sent.came.clear()
            await sent.came.wait()


async def test_what_was_given_last_is_repeated_last(publisher: Publishing, sent: Sent) -> None:
    publisher.start()
    given = list(range(20))
    for one in given:
        publisher.send(lock(one))
    await until_repeated(sent, 40)
    assert sent.published() == [*given, *given]


async def test_what_follows_something_that_is_repeated_is_repeated_after_it(
    publisher: Publishing, sent: Sent
) -> None:
    publisher.start()
    await asyncio.sleep(2 * publishing.KNOWN_AFTER)  # the topic of the lock is known
    publisher.send(lock("goal", "/robot_0/goal"))
    publisher.send(lock("cancel"))
    await until_repeated(sent, 4)
    assert sent.published() == ["goal", "cancel", "goal", "cancel"]


async def test_nothing_is_repeated_on_another_connection(publisher: Publishing, sent: Sent) -> None:
    publisher.start()
    publisher.send(lock("goal"))
    publisher.stop()
    await asyncio.sleep(2 * publishing.KNOWN_AFTER)  # a repeat would have come by then
    publisher.start()
    assert sent.published() == ["goal"]


async def test_a_pause_does_not_wait_until_a_large_fleet_is_advertised(sent: Sent) -> None:
    topics = [(f"/robot_{n}/cancel", "std_msgs/Bool") for n in range(100)]
    publisher = Publishing(cast("Connection", sent), topics)
    publisher.start()
    publisher.send(lock(True, "/robot_99/cancel"))
    assert len(sent.frames) <= publishing.AT_ONCE + 2 and sent.published() == [True]
    async with asyncio.timeout(2.0):
        while len({one["topic"] for one in sent.frames}) < len(topics):
            sent.came.clear()
            await sent.came.wait()
    publisher.stop()
    assert [one["topic"] for one in sent.frames if one["op"] == "advertise"].count("/robot_99/cancel") == 1


async def test_a_request_is_sent_once_although_its_topic_is_new_and_never_latched(
    publisher: Publishing, sent: Sent
) -> None:
    publisher.send(lock("request", "/requests")._replace(is_request=True))
    publisher.send(lock("goal"))
    await until_repeated(sent, 3)
    assert sent.published() == ["request", "goal", "goal"]
    assert not any("latch" in frame or "qos" in frame for frame in sent.frames)
