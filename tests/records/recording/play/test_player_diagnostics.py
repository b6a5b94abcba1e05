"""Diagnostics of a recording: the frames that are played are counted as if they came now."""

from pathlib import Path

import pytest

from fleet_tui.model.events import TimePassed
from fleet_tui.records.recording.records import ReceivedFrame
from tests.support.fleets import LINK, R0, T0, WALL, link_up
from tests.support.replay_console import replayed
from tests.support.replay_times import at
from tests.support.tapes import MadeUp
from tests.support.watched_store import config_of

POSE = f"/{R0}/pose"
FRAME = (
    '{"op":"publish","topic":"/robot_0/pose","msg":{"header":{"frame_id":"floor_0"},"pose":'
    '{"position":{"x":%d,"y":0},"orientation":{"x":0,"y":0,"z":0,"w":1}}}}'
)


@pytest.fixture
def drive(tmp_path: Path) -> Path:
    """A pose a second, as frames, with a keyframe every 20 s."""
    made = MadeUp(config_of("ws://site:9090"), keyframe_every=20.0)
    made.tell(0.0, link_up(T0))
    for second in range(100):
        now, wall = T0 + second, WALL + second
        made.records.append(
            ReceivedFrame(now, wall, LINK, "topics", "", (FRAME % second).encode(), False, now)
        )
        made.tell(second, TimePassed(now, wall))
    return made.written(tmp_path / "drive.jsonl.gz").path


async def test_what_was_played_since_the_last_jump_is_counted(drive: Path) -> None:
    async with replayed(drive, "+35s") as it:
        await it.press("d", "2")
        await it.shows(f"● live            0.0 s ago {POSE}", "diagnostics-rows")
        assert "1.0 Hz" in it.pane("diagnostics-rows") and at(35) in it.text
        await it.press("enter")
        await it.shows('"x": 35')
        await it.press("escape", "escape", "<", "d")
        await it.shows(at(25))
        await it.press("3")
        # What lay ahead of the jump back is not shown as if it had been.
        await it.shows('"x": 25')
        await it.press("1")
        await it.shows("1.0 /s, ")


async def test_what_was_frozen_before_a_jump_back_is_not_shown_as_if_it_had_come(drive: Path) -> None:
    async with replayed(drive, "+35s") as it:
        await it.press("d", "3", "space")
        await it.shows("frozen 0 s ago")
        await it.press("escape", "<", "d")
        await it.shows(at(25))
        await it.shows('"x": 25')
        assert "frozen" not in it.text
