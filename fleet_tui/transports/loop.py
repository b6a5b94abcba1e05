"""The network loop: one asyncio loop in a thread of its own, shared by all connections."""

import asyncio
import threading
from collections.abc import Callable

_lock = threading.Lock()
_loop: asyncio.AbstractEventLoop | None = None


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
    done = threading.Event()

    def call() -> None:
        try:
            do()
        finally:
            done.set()

    network_loop().call_soon_threadsafe(call)
    done.wait(within)


def _run(loop: asyncio.AbstractEventLoop) -> None:
    asyncio.set_event_loop(loop)
    loop.run_forever()
