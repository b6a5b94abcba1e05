"""A command that serves until it is told to end: Ctrl-C and SIGTERM are told apart."""

import asyncio
import os
import signal

import pytest

from fleet_tui.signals import stop, stopped_by_signal
from tests.support.polling import HANGS

SIGNALS = [(signal.SIGINT, True), (signal.SIGTERM, False), (signal.SIGHUP, False)]


@pytest.mark.parametrize(("number", "interrupted"), SIGNALS)
async def test_a_signal_stops_it(number: signal.Signals, interrupted: bool) -> None:
    stopped = stopped_by_signal()
    os.kill(os.getpid(), number)
    async with asyncio.timeout(HANGS):
        assert await stopped is interrupted
    for handled, _ in SIGNALS:
        asyncio.get_running_loop().remove_signal_handler(handled)


async def test_one_that_nohup_started_outlives_its_terminal() -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        stopped = stopped_by_signal()
        os.kill(os.getpid(), signal.SIGHUP)
        await asyncio.sleep(0)
        assert not stopped.done()
        assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGHUP, before)
        for handled in (signal.SIGINT, signal.SIGTERM):
            asyncio.get_running_loop().remove_signal_handler(handled)


async def test_whoever_stops_it_first_is_believed() -> None:
    stopped: asyncio.Future[bool] = asyncio.get_running_loop().create_future()
    stop(stopped, True)
    stop(stopped, False)
    assert stopped.result()
