"""The network loop: one for all, in a thread of its own."""

import asyncio
import threading

from fleet_tui.transports.loop import call_now, network_loop


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
