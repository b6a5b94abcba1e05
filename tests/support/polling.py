"""Waiting for what another process does, which wakes nobody here."""

import asyncio
import time
from collections.abc import Callable

HANGS = 200.0
"""Seconds after which what a test waits for will never come: no measure of how fast anything is."""


async def until(holds: Callable[[], object], within: float = HANGS) -> None:
    """Wait until it holds; the test fails if it never does."""
    async with asyncio.timeout(within):
        while not holds():  # noqa: ASYNC110  # of another process there is no event
            await asyncio.sleep(0.01)


def eventually(holds: Callable[[], object], within: float = HANGS) -> None:
    """Wait for what another thread does; the test fails if it never holds."""
    ends = time.monotonic() + within
    while not holds():
        assert time.monotonic() < ends, "it never held"
        time.sleep(0.005)
