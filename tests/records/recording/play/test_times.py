"""Recordings that say times no clock has: they are shown all the same."""

import math
from pathlib import Path

import pytest

from fleet_tui.model.events import TimePassed
from tests.support.fleets import T0, link_up
from tests.support.replay_console import replayed
from tests.support.tapes import MadeUp
from tests.support.watched_store import config_of


@pytest.mark.parametrize("wall", [1e308, -1e308, math.inf, math.nan])
async def test_a_time_that_cannot_be_does_not_end_the_console(tmp_path: Path, wall: float) -> None:
    made = MadeUp(config_of("ws://site:9090"))
    made.tell(0.0, link_up(T0), TimePassed(T0, 1.0))
    for second in range(1, 9):
        made.tell(second, TimePassed(T0 + second, wall if second > 2 else 1.0 + second))
    async with replayed(made.written(tmp_path / "x.jsonl.gz").path) as it:
        await it.press("end")
        await it.shows("end of recording")
        await it.shows("never seen")
