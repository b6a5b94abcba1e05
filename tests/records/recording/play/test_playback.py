"""The recorded clock beside ours: pace, silences, steps and jumps, without a thread."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from fleet_tui.model.events import TimePassed
from fleet_tui.model.replay import MarkKind
from fleet_tui.records.recording.play import cursor, playback
from fleet_tui.records.recording.play.playback import SPEEDS, Playback
from fleet_tui.text.language import Message
from tests.support.fleets import T0, WALL
from tests.support.tapes import MadeUp
from tests.support.watched_store import config_of


class Clock:
    """Our clock, which a test moves."""

    now = 50.0

    def monotonic(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(cursor, "LOOK_EVERY", 1)
    monkeypatch.setattr(playback, "time", SimpleNamespace(monotonic=clock.monotonic))
    return clock


@pytest.fixture
def played(tmp_path: Path, clock: Clock) -> Playback:
    """A tick a second from 0 to 9, a silence of 90 s, and ten more ticks."""
    made = MadeUp(config_of("ws://site:9090"))
    for second in (*range(10), *range(100, 110)):
        made.tell(second, TimePassed(T0 + second, WALL + second))
    return Playback(made.written(tmp_path / "x.jsonl.gz"), 2.0)


def always() -> bool:
    return True


def second(played: Playback) -> float:
    return played.head.at - T0


def test_it_keeps_its_pace_from_where_it_went_on(played: Playback, clock: Clock) -> None:
    clock.now += 1.0
    played.play(always)
    assert second(played) == 2.0
    played.toggle()
    clock.now += 99.0
    played.play(always)
    assert second(played) == 2.0 and played.paused
    played.toggle()
    played.change_speed(-1)
    clock.now += 3.0
    played.play(always)
    assert second(played) == 5.0


def test_a_silence_is_skipped_and_marked_once(played: Playback, clock: Clock) -> None:
    played.seek(T0 + 9, always)
    for _ in range(2):
        clock.now += 0.1
        played.play(always)
        assert second(played) == 100.0
    (gap,) = [mark for mark in played.marks if mark.kind is MarkKind.GAP]
    assert (gap.at, gap.text) == (T0 + 100, "no records for the 1:31 before this")


def test_it_stops_at_the_end(played: Playback, clock: Clock) -> None:
    played.seek(T0 + 109, always)
    played.play(always)
    played.show()
    assert played.paused and played.shown[1].is_over


def test_work_that_takes_too_long_makes_it_slower(played: Playback, clock: Clock) -> None:
    def late() -> bool:
        clock.now += playback.LATE
        return True

    clock.now += 2.0
    played.play(late)
    played.show()
    reached = played.shown[1].reached
    assert second(played) < 4.0 and reached is not None and reached < 2.0 / playback.LATE


def test_speeds_are_those_of_the_table(played: Playback) -> None:
    def speed(step: int) -> float:
        played.change_speed(step)
        played.show()
        return played.shown[1].speed

    assert [speed(step) for step in (1, 1, -1, 0)] == [4.0, 8.0, 4.0, 1.0]
    assert [speed(1) for _ in SPEEDS][-1] == SPEEDS[-1]
    assert [speed(-1) for _ in SPEEDS][-1] == SPEEDS[0]


def test_a_step_stops_and_only_one_back_is_a_jump(played: Playback) -> None:
    def jumps() -> int:
        played.show()
        return played.shown[1].jumps

    played.step(played.head.step_tick, 1)
    assert played.paused and jumps() == 0
    played.step(played.head.step_tick, -1)
    assert jumps() == 1
    played.seek(T0 + 5, always)
    assert jumps() == 2 and second(played) == 5.0


def test_a_long_jump_shows_its_progress_and_not_what_lies_between(played: Playback, clock: Clock) -> None:
    shown = []

    def looks() -> bool:
        clock.now += playback.LONG
        shown.append(played.shown)
        return True

    before = played.shown[0]
    played.seek(T0 + 109, looks)
    busy = [position.busy for state, position in shown if position.busy is not None]
    assert busy and busy == sorted(busy) and all(state is before for state, _ in shown)
    played.show()
    assert played.shown[1].busy is None


def test_a_failure_stops_it_and_is_said_until_the_next_jump(played: Playback) -> None:
    played.fail(Message("part gone"))
    played.show()
    assert played.paused and played.shown[1].note == "part gone"
    played.seek(T0, always)
    played.show()
    assert played.shown[1].note == ""
