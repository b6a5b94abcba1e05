"""The one writer: a tick ten times a second, whatever fails in it, and events in their order."""

import gc
import time
from collections.abc import AsyncIterator

import pytest

from fleet_tui.links import writer
from fleet_tui.links.writer import Writer
from fleet_tui.model.events import TimePassed
from tests.support.ear import Ear
from tests.support.fleets import T0, battery, fleet
from tests.support.watched_store import WatchedStore


@pytest.fixture
async def store() -> WatchedStore:
    return WatchedStore(fleet())


@pytest.fixture
async def running(store: WatchedStore) -> AsyncIterator[Writer]:
    """A writer that a test starts."""
    running = Writer(store, Ear())
    yield running
    running.stop()


async def test_garbage_is_looked_for_while_it_runs(running: Writer, store: WatchedStore) -> None:
    """Python by itself waits for a million new objects: for a console at work that is 10 minutes and more."""
    looks = gc.get_stats()[2]["collections"]
    running.start()
    await store.until(lambda _: gc.get_stats()[2]["collections"] > looks + 1)


@pytest.mark.own_faults
async def test_a_tick_that_fails_is_not_the_last(
    running: Writer, store: WatchedStore, caplog: pytest.LogCaptureFixture
) -> None:
    looks: list[float] = []

    def look(now: float) -> None:
        looks.append(now)
        if len(looks) == 1:
            raise RuntimeError("once")

    running.before_tick.append(look)
    running.backlogs.append(lambda _now: 7.0)
    running.start()
    await store.until(lambda _: len(store.told(TimePassed)) > 1)
    assert "once" in caplog.text
    ticks = [event for event in store.events if isinstance(event, TimePassed)]
    assert [tick.at for tick in ticks[:2]] == looks[1:3]
    assert {tick.behind for tick in ticks} == {7.0}, "as old as the oldest message that waits"


async def test_events_of_any_thread_are_applied_in_their_order_and_tapped(
    running: Writer, store: WatchedStore
) -> None:
    events = [battery(T0 + n, float(n)) for n in range(5)]
    for event in events:
        running.post(event)
    await store.until(lambda _: len(store.events) == 5)
    assert isinstance(running.tap, Ear)
    assert store.events == events == running.tap.facts


async def test_what_arrived_while_it_did_not_run_is_read_before_anything_counts_as_missing(
    running: Writer, store: WatchedStore, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(writer, "STALL", 0.2)
    running.start()
    await store.until(lambda _: store.told(TimePassed))
    running.loop.call_soon_threadsafe(time.sleep, 0.35)  # the stop itself
    await store.until(lambda state: state.behind >= 0.2)
    ticks = len(store.told(TimePassed))
    await store.until(lambda _: len(store.told(TimePassed)) > ticks + 1)
    assert store.state.behind >= 0.2
    await store.until(lambda state: state.behind < 0.2)


async def test_a_stop_within_a_tick_is_known_too(running: Writer, store: WatchedStore) -> None:
    stops = [0.35]
    running.before_tick.append(lambda _now: time.sleep(stops.pop() if stops else 0.0))
    running.start()
    await store.until(lambda state: state.behind >= 0.2)
