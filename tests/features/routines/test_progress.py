"""Progress that outlives the process."""

from pathlib import Path

import pytest
from hypothesis import given

from fleet_tui.features.routines.blocks import LanePlan
from fleet_tui.features.routines.files import RoutineFile, read_routine
from fleet_tui.features.routines.lane import Gate, Lane, LaneEvent, LanePhase
from fleet_tui.features.routines.progress import (
    RoutineProgress,
    load_progress,
    progress_path,
    resumable,
    resumed,
    save_progress,
)
from fleet_tui.text.errors import RoutineError
from tests.support.routines import MORNING, LedLane, lane_events, plans


@pytest.fixture
def file(tmp_path: Path) -> RoutineFile:
    (tmp_path / "morning.routine").write_text(MORNING)
    return read_routine(tmp_path, "morning")


def test_what_was_saved_is_resumed(tmp_path: Path, file: RoutineFile) -> None:
    path = progress_path(tmp_path / "state", file.path)
    progress = RoutineProgress(file.digest, (Lane("robot_0"),), 1.0, 2.0, "ana")
    save_progress(path, progress)
    assert resumable(path, file) == progress and path.stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize(
    ("digest", "phase", "words"),
    [("other", LanePhase.READY, "was changed since it was held"), ("", LanePhase.DONE, "nothing to resume")],
)
def test_what_cannot_be_resumed(
    tmp_path: Path, file: RoutineFile, digest: str, phase: LanePhase, words: str
) -> None:
    path = tmp_path / "progress.json"
    with pytest.raises(RoutineError, match="nothing to resume"):
        resumable(path, file)
    lanes = (Lane("robot_0", phase=phase),)
    save_progress(path, RoutineProgress(digest or file.digest, lanes, 0.0, 0.0))
    with pytest.raises(RoutineError, match=words):
        resumable(path, file)


def test_a_damaged_file_counts_as_none(tmp_path: Path) -> None:
    path = tmp_path / "progress.json"
    for content in (b"{}", b"\xff", b'{"digest": 1}', b"[" * 100_000):
        path.write_bytes(content)
        assert load_progress(path) is None


def test_two_routines_of_one_name_have_a_file_each(tmp_path: Path) -> None:
    paths = {progress_path(tmp_path, Path(folder) / "morning.routine") for folder in ("/a", "/b")}
    assert len(paths) == 2


@given(plans, lane_events)
def test_a_lane_of_an_earlier_process_is_held_or_over(plan: LanePlan, events: list[LaneEvent]) -> None:
    lane = resumed(LedLane(plan).after(*events))
    assert lane.is_over or (lane.gate is Gate.HELD and lane.detail)
    assert lane.phase not in (LanePhase.WAITING, LanePhase.PROGRAM)


def test_an_order_is_followed_by_its_id() -> None:
    assert resumed(Lane("r", phase=LanePhase.ORDERED, order_id="7")).phase is LanePhase.ORDERED
    assert resumed(Lane("r", phase=LanePhase.ORDERED)).phase is LanePhase.READY
