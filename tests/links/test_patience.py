"""Waiting in which only time counts that this process ran."""

import asyncio
import time

from fleet_tui.links.patience import STALLED, STEP, timed


async def test_time_in_which_the_process_stood_still_is_no_time_that_an_answer_took() -> None:
    async def answered_after_a_standstill() -> str:
        await asyncio.sleep(0)
        time.sleep(2 * (STEP + STALLED))  # noqa: ASYNC251  # the loop stands still: that is tested
        return "answer"

    took, answer = await timed(answered_after_a_standstill())
    assert answer == "answer" and took <= STEP + STALLED


async def test_an_answer_that_fails_fails() -> None:
    async def refused() -> None:
        raise LookupError

    try:
        await timed(refused())
    except LookupError:
        return
    raise AssertionError
