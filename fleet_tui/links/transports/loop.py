"""The network loop: one asyncio loop in a thread of its own, shared by all connections."""

import asyncio
import threading
import time
from collections.abc import Callable

TURN = 0.02
NAP = 0.002
"""Seconds for which incoming data waits for a picture at most, and between its looks for the end of that."""

_lock = threading.Lock()
_loop: asyncio.AbstractEventLoop | None = None
_waits_until = 0.0


def network_loop() -> asyncio.AbstractEventLoop:
    """Return the loop, started if need be. Callable from any thread."""
    global _loop
    with _lock:
        if _loop is None:
            _loop = asyncio.new_event_loop()
            threading.Thread(target=_run, args=(_loop,), name="fleet-tui-network", daemon=True).start()
    return _loop


def call_now(do: Callable[[], object], within: float) -> None:
    """Call on the loop now, not after the caller's next drawing: wait for it, but only so many seconds."""
    end_turn()
    done = threading.Event()

    def call() -> None:
        try:
            do()
        finally:
            done.set()

    network_loop().call_soon_threadsafe(call)
    done.wait(within)


def give_turn() -> None:
    """Let the caller's thread paint before more data is read: each of both threads would get half of the
    time, and a letter shows that. A key that is held leaves half of the time to the data."""
    global _waits_until
    if time.monotonic() >= _waits_until + TURN:
        _waits_until = time.monotonic() + TURN


def end_turn() -> None:
    """Read data again."""
    global _waits_until
    _waits_until = 0.0


def wait_for_turn() -> None:
    """Wait while another thread has its turn. On the loop, before a message is read."""
    while time.monotonic() < _waits_until:
        time.sleep(NAP)


def _run(loop: asyncio.AbstractEventLoop) -> None:
    asyncio.set_event_loop(loop)
    loop.run_forever()
