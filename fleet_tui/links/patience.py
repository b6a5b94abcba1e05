"""Waiting in which only time counts that this process ran: stopped or starved it has not waited."""

import asyncio
import time
from collections.abc import Callable, Coroutine
from typing import Any, TypeVar

Result = TypeVar("Result")

STEP = 0.5
"""Seconds of a step of waiting: a later end counts no more."""
STALLED = 0.1
"""Seconds by which the end of a step may be late: after more the loop did not run, and what arrived meanwhile
has to be read before anything counts as missing."""
MOST_STALLED = 5
"""Late steps in a row after which waiting ends all the same: this console is starved for long."""


async def awake(seconds: float) -> None:
    """Sleep for so many seconds of running, and not to the end of a time in which the loop did not run."""
    left, stalled = seconds, 0
    while left > 0.0 or 0 < stalled < MOST_STALLED:
        step = min(STEP, left) if left > 0.0 else STALLED
        began = time.monotonic()
        await asyncio.sleep(step)
        took = time.monotonic() - began
        stalled = stalled + 1 if took - step > STALLED else 0
        left -= step if stalled else took


async def timed(work: Coroutine[Any, Any, Result]) -> tuple[float, Result]:
    """Await some work. Returns the seconds of running that it took, and its result."""
    task, took = asyncio.ensure_future(work), 0.0
    try:
        while not task.done():
            began = time.monotonic()
            await asyncio.wait({task}, timeout=STEP)
            took += min(time.monotonic() - began, STEP + STALLED)
    finally:
        task.cancel()
    return took, task.result()


def call_awake(seconds: float, do: Callable[[], object]) -> "asyncio.Task[None]":
    """Call a function after so many seconds of running, unless the task is cancelled before."""

    async def wait() -> None:
        await awake(seconds)
        do()

    return asyncio.ensure_future(wait())
