"""A command that serves until it is told to end: Ctrl-C and SIGTERM are told apart."""

import asyncio
import os
import signal

import pytest

from fleet_tui.stopping import stop, stopped_by_signal
from tests.support.polling import HANGS


@pytest.mark.parametrize(("number", "interrupted"), [(signal.SIGINT, True), (signal.SIGTERM, False)])
async def test_a_signal_stops_it(number: signal.Signals, interrupted: bool) -> None:
    stopped = stopped_by_signal()
    os.kill(os.getpid(), number)
    async with asyncio.timeout(HANGS):
        assert await stopped is interrupted
    loop = asyncio.get_running_loop()
    loop.remove_signal_handler(signal.SIGINT)
    loop.remove_signal_handler(signal.SIGTERM)


async def test_whoever_stops_it_first_is_believed() -> None:
    stopped: asyncio.Future[bool] = asyncio.get_running_loop().create_future()
    stop(stopped, True)
    stop(stopped, False)
    assert stopped.result()
