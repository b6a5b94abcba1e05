"""The network loop: one for all, in a thread of its own."""

import asyncio
import threading
from collections.abc import Iterator
from types import SimpleNamespace

import pytest

from fleet_tui.links.transports import loop
from fleet_tui.links.transports.loop import TURN, call_now, end_turn, give_turn, network_loop, wait_for_turn


def test_there_is_one_and_it_runs_beside_whoever_asks() -> None:
    async def where() -> str:
        return threading.current_thread().name

    assert network_loop() is network_loop()
    assert asyncio.run_coroutine_threadsafe(where(), network_loop()).result(10) == "fleet-tui-network"


def test_a_call_is_done_on_the_loop_before_it_returns() -> None:
    where = list[str]()
    call_now(lambda: where.append(threading.current_thread().name), 10.0)
    assert where == ["fleet-tui-network"]


def test_a_busy_loop_is_waited_for_only_so_long() -> None:
    goes_on, done = threading.Event(), threading.Event()
    network_loop().call_soon_threadsafe(goes_on.wait, 10.0)
    call_now(done.set, 0.01)
    assert not done.is_set()
    goes_on.set()
    assert done.wait(10.0)


class Clock(SimpleNamespace):
    """Time that passes only in sleep."""

    now = 100.0

    def monotonic(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds

    def waited(self) -> float:
        """Return the seconds for which data waits now."""
        before = self.now
        wait_for_turn()
        return self.now - before


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Iterator[Clock]:
    made = Clock()
    monkeypatch.setattr(loop, "time", made)
    end_turn()
    yield made
    end_turn()


def test_data_waits_for_a_picture_until_that_ends_but_not_for_long(clock: Clock) -> None:
    assert clock.waited() == 0.0
    give_turn()
    assert TURN <= clock.waited() < 2 * TURN
    clock.sleep(1.0)
    give_turn()
    end_turn()
    assert clock.waited() == 0.0


def test_a_command_ends_the_turn_it_would_wait_for(clock: Clock) -> None:
    give_turn()
    call_now(lambda: None, 10.0)
    assert clock.waited() == 0.0


def test_a_key_that_is_held_leaves_time_for_data(clock: Clock) -> None:
    waited = 0.0
    for _ in range(100):
        give_turn()
        waited += clock.waited()
        clock.sleep(TURN / 10)
    assert waited < 0.6 * (clock.now - 100.0)
