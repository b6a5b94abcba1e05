"""The examination of a routine before it starts."""

from pathlib import Path

import pytest

from fleet_tui.features.routines.files import read_routine
from fleet_tui.features.routines.folder import RoutinePlace
from fleet_tui.features.routines.start import Examined, examine, problems_of, timeline_of
from tests.support.routines import two_robots


def examined(folder: Path, text: str) -> Examined:
    (folder / "day.routine").write_text(text)
    return examine(RoutinePlace(folder, folder), two_robots(), "day")


def test_a_good_one_has_a_timeline_and_a_question(tmp_path: Path) -> None:
    found = examined(tmp_path, "for robot_0\nwait 90 s\nwait 30 s\nend\n")
    assert found.problems == () and found.timeline[0] == "robot_0:" and len(found.timeline) == 3
    assert found.question(False) == "Start day with robot_0?\nrobot_0: 2 instructions, about 2:00 min"
    assert found.question(True).startswith("Continue day with robot_0? It is held until it is resumed")


def test_an_unknown_duration_makes_it_a_lower_limit(tmp_path: Path) -> None:
    found = examined(tmp_path, "for robot_0\nwait 90 s\nrun true\nend\n")
    assert found.question(False).endswith("robot_0: 2 instructions, at least 1:30 min")


@pytest.mark.parametrize(
    ("text", "lines"), [("for robot_0\ngo Bse\nrun absent\nend\n", [2, 3]), ("for robot_9\ngo\nend\n", [2])]
)
def test_a_mistake_in_the_text_comes_before_the_fleet(tmp_path: Path, text: str, lines: list[int]) -> None:
    found = examined(tmp_path, text)
    assert [one.startswith(f"day, line {line}: ") for one, line in zip(found.problems, lines, strict=True)]
    file = read_routine(tmp_path, "day")
    assert [problem.line for problem in problems_of(two_robots(), file)] == lines


def test_one_that_cannot_be_read(tmp_path: Path) -> None:
    found = examine(RoutinePlace(tmp_path, tmp_path), two_robots(), "absent")
    assert found.file is None and found.problems[0].startswith("unknown routine 'absent'")


def test_all_robots_begin_at_once(tmp_path: Path) -> None:
    (tmp_path / "day.routine").write_text("for robot_0 robot_1\nwait 5 s\nend\n")
    entries = timeline_of(two_robots(), read_routine(tmp_path, "day"))
    assert [(entry.robot, entry.at) for entry in entries] == [("robot_0", 0.0), ("robot_1", 0.0)]
