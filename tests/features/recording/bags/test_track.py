"""The clock of a converted bag: it ticks through silences and leaps over those too long."""

from itertools import pairwise
from pathlib import Path

import pytest

from fleet_tui.features.recording.bags import track
from tests.support.bag_replay import made_of, night, played, pose, ticks
from tests.support.bags import WALL, bag_config, written
from tests.support.fleets import R0
from tests.support.recordings import plain


def test_alarms_ripen_as_they_would_have(tmp_path: Path) -> None:
    """Robot 0 is silent for 20 s, robot 1 all the time: five seconds, as the config has it."""
    said = [pose(n / 10) for n in range(50)] + [pose(25 + n / 10) for n in range(50)]
    config = bag_config("mcap", robots=2)
    _, recording = made_of(written(tmp_path, "mcap", said), config, tmp_path / "r.jsonl.gz")
    raised = [(mark.at, mark.record.robot) for mark in recording.marks if mark.record.change == "raised"]
    assert [robot for _, robot in raised] == ["robot_1", "robot_0"]
    assert [at for at, _ in raised] == pytest.approx([1 + 5.0, 1 + 4.9 + 5.0], abs=0.21)
    back = [mark.at for mark in recording.marks if mark.record.robot == R0 and mark.record.change == "over"]
    assert all(at > 26 for at in back)


def test_a_picture_may_begin_at_every_minute(tmp_path: Path) -> None:
    said = [*night(), *(pose(12 + n, 0.1 * n) for n in range(200))]
    _, recording = made_of(written(tmp_path, "mcap", said), bag_config("mcap"), tmp_path / "r.jsonl.gz")
    assert [moment.at for moment in recording.keyframes] == [1.0, 61.0, 121.0, 181.0]
    assert len({(place.member, place.nth) for place in recording.places}) == 4
    ends = [plain(played(recording, moment.at)) for moment in recording.keyframes]
    assert all(end == ends[0] for end in ends)


@pytest.mark.nightly
def test_an_hour_without_a_message_is_lived_through(tmp_path: Path) -> None:
    bag = written(tmp_path, "ros1", [pose(0), pose(3600)])
    _, recording = made_of(bag, bag_config("ros1"), tmp_path / "r.jsonl.gz")
    assert len(ticks(recording)) == 36001 and len(recording.keyframes) == 61
    assert recording.end.at == 3601.0


def test_a_year_without_a_message_is_leapt_over(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert track.LONGEST_SILENCE == 7200.0
    monkeypatch.setattr(track, "LONGEST_SILENCE", 720.0)  # as many ticks take seconds
    year = 365 * 86400
    bag = written(tmp_path, "ros1", [pose(0), pose(year), pose(year + 1)])
    _, recording = made_of(bag, bag_config("ros1"), tmp_path / "r.jsonl.gz")
    times = ticks(recording)
    assert len(times) == pytest.approx(7_200 + 12, abs=3)
    assert max(after - before for before, after in pairwise(times)) > year - 730
    assert recording.end.wall == WALL + year + 1
    assert played(recording).now == pytest.approx(year + 2, abs=0.11)
