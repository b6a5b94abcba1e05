"""Stopping a command that serves until a signal."""

import asyncio
import signal


def stop(stopped: asyncio.Future[bool], interrupted: bool) -> None:
    """Set the future, unless it is set already. On its loop."""
    if not stopped.done():
        stopped.set_result(interrupted)


def stopped_by_signal() -> asyncio.Future[bool]:
    """Return a future of the running loop: True at Ctrl-C, False at SIGTERM and with its terminal."""
    loop = asyncio.get_running_loop()
    stopped: asyncio.Future[bool] = loop.create_future()
    loop.add_signal_handler(signal.SIGINT, stop, stopped, True)
    loop.add_signal_handler(signal.SIGTERM, stop, stopped, False)
    if signal.getsignal(signal.SIGHUP) is not signal.SIG_IGN:  # nohup
        loop.add_signal_handler(signal.SIGHUP, stop, stopped, False)
    return stopped
