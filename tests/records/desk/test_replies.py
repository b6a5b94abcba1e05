"""Answers of other consoles wait a moment for their alarms."""

import pytest

from fleet_tui.model.desk.events import AlarmAcknowledged, AlarmShelved, AlarmUnshelved
from fleet_tui.model.events import Event
from fleet_tui.records.desk import desk as module
from fleet_tui.records.desk.desk import Replies
from fleet_tui.records.desk.facts import SharedAcknowledgement, SharedShelving
from fleet_tui.records.desk.presence import Presence
from fleet_tui.state.store import Store
from tests.support.fleets import LINK, T0, fleet, link_lost, link_up, tick

ALARM = (LINK, "link")


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    now = [T0]
    monkeypatch.setattr("fleet_tui.records.desk.desk.time.monotonic", lambda: now[0])
    return now


def made() -> tuple[Store, Replies, list[Event]]:
    """Return a store, the answers that wait for its alarms, and what they post."""
    store, sent = Store(fleet()), list[Event]()
    replies = Replies(store)
    replies.send = sent.append
    return store, replies, sent


def lose_link(store: Store) -> None:
    for event in (link_up(T0), link_lost(T0 + 1), tick(T0 + 10)):
        store.apply(event)


def test_an_answer_that_comes_first_waits_for_its_alarm(clock: list[float]) -> None:
    store, replies, sent = made()
    replies.take(SharedAcknowledgement("a:1", "ana", 0.0, *ALARM), "ana")
    replies.post()
    assert sent == []
    lose_link(store)
    replies.post()
    assert sent == [AlarmAcknowledged(*ALARM, "ana")]
    replies.post()
    assert len(sent) == 1


def test_an_alarm_that_comes_much_later_is_another_one(clock: list[float]) -> None:
    store, replies, sent = made()
    replies.take(SharedAcknowledgement("a:1", "ana", 0.0, *ALARM), "ana")
    clock[0] += module.WAITS + 1
    replies.post()
    lose_link(store)
    replies.post()
    assert sent == []


def test_shelving_ends_as_long_after_as_at_the_other_console(clock: list[float]) -> None:
    store, replies, sent = made()
    lose_link(store)
    replies.take(SharedShelving("a:1", "ana", 0.0, *ALARM, 600.0), "ana")
    replies.post()
    assert sent == [AlarmShelved(*ALARM, T0 + 610, "ana")]


def test_only_a_new_console_adopts_and_only_once(clock: list[float]) -> None:
    store, replies, sent = made()
    lose_link(store)
    other = Presence("x", "ana", "here", "boot", acknowledged=(ALARM,))
    replies.adopt([("ana", other)])
    replies.adopt([("ana", other)])
    assert sent == [AlarmAcknowledged(*ALARM, "ana")]
    store, replies, sent = made()
    lose_link(store)
    store.apply(AlarmShelved(*ALARM, T0 + 99))
    replies.adopt([])
    store.apply(AlarmUnshelved(*ALARM))
    replies.adopt([("ana", other)])  # whose file is from before
    assert sent == []
    store, replies, sent = made()
    lose_link(store)
    clock[0] += module.ADOPTS + 1
    replies.adopt([("ana", other)])
    assert sent == []


def test_answers_to_alarms_that_never_come_are_not_kept(clock: list[float]) -> None:
    _, replies, _ = made()
    for minute in range(3):
        clock[0] = T0 + 60 * minute
        for n in range(50):
            replies.take(SharedAcknowledgement("a:1", "eve", 0.0, f"robot_{n}", f"{minute}"), "eve")
        replies.post()
        replies.adopt([])
    clock[0] += module.WAITS + 1
    replies.post()
    assert not replies._waiting and not replies._answered
