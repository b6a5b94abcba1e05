"""Looks at the routines of a folder."""

from pathlib import Path

from fleet_tui.features.routines.files import read_routine
from fleet_tui.features.routines.folder import RoutinePlace, look_at_all, plans_of
from fleet_tui.features.routines.lane import Lane
from fleet_tui.features.routines.owner import RobotLocks
from fleet_tui.features.routines.progress import RoutineProgress, progress_path, save_progress
from tests.support.routines import MORNING, two_robots

URLS = {"robot_0": "ws://site:9090", "robot_1": "ws://site:9090"}


def test_each_file_with_its_last_run_and_its_owner(tmp_path: Path) -> None:
    place = RoutinePlace(tmp_path / "routines", tmp_path / "state")
    place.folder.mkdir()
    assert look_at_all(place, two_robots()) == []
    (place.folder / "day.routine").write_text(MORNING)
    (place.folder / "bad.routine").write_text("go\ngo\n")
    (place.folder / "no text.routine").write_text("")
    file = read_routine(place.folder, "day")
    bad, day, no_name = look_at_all(place, two_robots())
    assert bad.problem == "line 1: go outside a lane: put it between for ROBOT and end, and 1 more problem"
    assert (day.times, list(day.plans), day.lanes) == (("weekday 06:30",), ["robot_0", "robot_1"], ())
    assert "use up to 64 letters" in no_name.problem
    lanes = (Lane("robot_0"), Lane("robot_1"))
    path = progress_path(place.state, file.path)
    save_progress(path, RoutineProgress(file.digest, lanes, 1.0, 2.0))
    left = look_at_all(place, two_robots())[1]
    assert left.is_left and (left.lanes, left.at) == (lanes, 2.0)
    locks = RobotLocks(place.state, URLS, "ana (process 3)")
    locks.claim()
    assert look_at_all(place, two_robots())[1].owner == "ana (process 3)"
    locks.release()
    (place.folder / "day.routine").write_text(MORNING + "\n")
    assert look_at_all(place, two_robots())[1].lanes == (), "its lines are others now"


def test_only_robots_that_exist_have_a_plan(tmp_path: Path) -> None:
    (tmp_path / "day.routine").write_text("for robot_0 robot_9\ngo Base\nend\n")
    assert list(plans_of(two_robots(), read_routine(tmp_path, "day"))) == ["robot_0"]
