"""The frames that a client is sent and their times, with a clock set by the test."""

import pytest

from fleet_tui.simulator.frames import Frame
from fleet_tui.simulator.sessions.client import UNBUFFERED, ClientSubscription, Outbox, SubscribeRequest


def subscription(throttle: float = 0.0, queue_length: int = 1) -> ClientSubscription:
    found = ClientSubscription({"a": SubscribeRequest(throttle, queue_length)})
    found.settle()
    return found


def taken(outbox: Outbox, now: float) -> list[Frame]:
    found = []
    while (frame := outbox.take(now)) is not None:
        found.append(frame)
    return found


@pytest.mark.parametrize(
    ("queue_length", "kept"), [(1, ["9"]), (3, ["7", "8", "9"]), (0, [str(i) for i in range(10)])]
)
def test_a_queue_keeps_the_newest(queue_length: int, kept: list[str]) -> None:
    outbox, slow = Outbox(), subscription(queue_length=queue_length)
    for i in range(10):
        outbox.offer(slow, str(i), now=0.1 * i)
    assert taken(outbox, now=1.0) == kept
    assert taken(outbox, now=9.0) == []


def test_even_without_a_queue_it_is_bounded() -> None:
    outbox, slow = Outbox(), subscription(queue_length=0)
    for i in range(UNBUFFERED + 5):
        outbox.offer(slow, str(i), now=0.0)
    assert taken(outbox, now=0.0)[0] == "5"


def test_throttled_with_a_queue_the_newest_follows_when_it_is_due() -> None:
    outbox, slow = Outbox(), subscription(throttle=1.0)
    outbox.offer(slow, "first", now=10.0)
    assert taken(outbox, now=10.0) == ["first"]
    outbox.offer(slow, "second", now=10.3)
    outbox.offer(slow, "third", now=10.6)
    assert taken(outbox, now=10.9) == []
    assert outbox.next_due == pytest.approx(11.0, abs=0.01)
    assert taken(outbox, now=11.0) == ["third"]


def test_throttled_without_a_queue_what_comes_too_early_is_lost() -> None:
    outbox, slow = Outbox(), subscription(throttle=1.0, queue_length=0)
    for now in (10.0, 10.3, 11.1):
        outbox.offer(slow, str(now), now)
    assert taken(outbox, now=20.0) == ["10.0", "11.1"]


def test_a_throttle_as_long_as_the_period_loses_nothing() -> None:
    outbox, pose = Outbox(), subscription(throttle=0.1)
    late = (0.000, 0.003, 0.001, 0.004, 0.000, 0.002)
    sent = []
    for i in range(600):
        now = 50.0 + 0.1 * i + late[i % len(late)]
        outbox.offer(pose, str(i), now)
        sent += taken(outbox, now)
    assert sent == [str(i) for i in range(600)]


def test_answers_keep_their_place_and_are_never_replaced_or_held_back() -> None:
    outbox, topic, throttled = Outbox(), subscription(), subscription(throttle=1.0)
    outbox.offer(throttled, "early", now=0.0)
    assert taken(outbox, now=0.0) == ["early"]
    outbox.offer(throttled, "later", now=0.1)
    outbox.offer(topic, "pose", now=0.1)
    outbox.reply("one", now=0.1)
    outbox.reply("two", now=0.1)
    assert taken(outbox, now=0.2) == ["pose", "one", "two"]
    assert taken(outbox, now=1.0) == ["later"]


def test_topics_are_sent_in_the_order_they_came() -> None:
    outbox, topics = Outbox(), [subscription() for _ in range(4)]
    for i in (2, 0, 3, 1):
        outbox.offer(topics[i], str(i), now=5.0)
    assert taken(outbox, now=5.0) == ["2", "0", "3", "1"]


def test_several_wishes_of_one_client_take_the_strictest() -> None:
    both = ClientSubscription({"a": SubscribeRequest(0.5, 3), "b": SubscribeRequest(0.1, 1, "cbor")})
    both.settle()
    assert (both.throttle, both.queue_length, both.compression) == (0.1, 1, "cbor")
