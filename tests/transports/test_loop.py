"""The network loop: one for all, in a thread of its own."""

import asyncio
import threading

from fleet_tui.transports.loop import network_loop


def test_there_is_one_and_it_runs_beside_whoever_asks() -> None:
    async def where() -> str:
        return threading.current_thread().name

    assert network_loop() is network_loop()
    assert asyncio.run_coroutine_threadsafe(where(), network_loop()).result(10) == "fleet-tui-network"
