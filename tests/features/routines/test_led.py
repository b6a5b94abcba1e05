"""Routines that a console leads: permission, owner, saved progress."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.features.routines.files import RoutineFile, read_routine
from fleet_tui.features.routines.folder import RoutinePlace
from fleet_tui.features.routines.lane import Gate, LanePaused, LanePhase, LaneResumed, LaneSkipped
from fleet_tui.features.routines.led import LedRoutines
from fleet_tui.features.routines.owner import RobotLocks
from fleet_tui.features.routines.progress import load_progress, progress_path
from fleet_tui.model.problem import Permissions
from fleet_tui.text.errors import RoutineError
from tests.support.desk import Desk
from tests.support.fleets import T0, link_lost
from tests.support.routines import two_robots


def at_once(work: Callable[[], Any], then: Callable[[Any], None]) -> None:
    then(work())


class LedDesk(Desk):
    """A desk that leads routines, and saves them at once."""

    def __init__(self, folder: Path, permissions: Permissions | None = None) -> None:
        super().__init__(two_robots(), permissions or Permissions())
        self.place = RoutinePlace(folder, folder / "state")
        self.led = LedRoutines(self.place, self.console())


@pytest.fixture
def file(tmp_path: Path) -> RoutineFile:
    (tmp_path / "day.routine").write_text("for robot_0\ncarry Base Consumidores\nwait 5 min\nend\n")
    return read_routine(tmp_path, "day")


def test_it_sends_orders_and_saves_each_step(tmp_path: Path, file: RoutineFile) -> None:
    desk = LedDesk(tmp_path)
    desk.led.start(file, False)
    assert not desk.led.tick() and len(desk.backend.submitted) == 1
    saved = load_progress(progress_path(desk.place.state, file.path))
    assert saved is not None and saved.lanes[0].phase is LanePhase.ORDERED
    assert desk.led.losses.startswith("Leave day? Running orders continue")


def test_a_console_without_permission_starts_nothing_and_lets_nothing_follow(
    tmp_path: Path, file: RoutineFile
) -> None:
    with pytest.raises(RoutineError, match="not armed"):
        LedDesk(tmp_path, Permissions(armed=False)).led.start(file, False)
    desk = LedDesk(tmp_path)
    desk.led.start(file, False)
    run = desk.led.runs["day"]
    desk.dispatch.arm()
    desk.led.tick()
    assert run.lanes["robot_0"].gate is Gate.HELD and desk.backend.submitted == []
    desk.led.request(run, LaneResumed(), "robot_0")
    assert "not resumed: not sent: this console is not armed" in desk.notices.text
    assert run.lanes["robot_0"].gate is Gate.HELD


def test_robots_that_another_one_leads_are_left_to_it(tmp_path: Path, file: RoutineFile) -> None:
    desk = LedDesk(tmp_path)
    RobotLocks(desk.place.state, {"robot_0": "ws://site:9090"}, "ana (process 3)").claim()
    with pytest.raises(RoutineError, match="robot_0 is run by ana"):
        desk.led.start(file, False)
    assert desk.led.runs == {}


def test_it_is_left_held_and_taken_up_by_the_next_console(tmp_path: Path, file: RoutineFile) -> None:
    desk = LedDesk(tmp_path)
    with pytest.raises(RoutineError, match="nothing to resume"):
        desk.led.start(file, True)
    desk.led.start(file, False)
    desk.led.tick()
    desk.led.close()
    assert desk.led.runs == {} and desk.led.losses == ""
    after = LedDesk(tmp_path)
    after.led.start(file, True)
    after.led.tick()
    assert after.led.runs["day"].lanes["robot_0"].gate is Gate.HELD and after.backend.submitted == []


def test_only_what_is_paused_or_held_goes_on_by_a_request(tmp_path: Path, file: RoutineFile) -> None:
    desk = LedDesk(tmp_path)
    desk.led.start(file, False)
    run = desk.led.runs["day"]
    desk.led.request(run, LaneSkipped(), "")
    assert run.lanes["robot_0"].path[-1].index == 0
    desk.led.request(run, LanePaused(), "")
    assert run.lanes["robot_0"].gate is Gate.PAUSED
    desk.store.apply(link_lost(T0))
    desk.led.request(run, LaneResumed(), "")
    assert run.lanes["robot_0"].gate is Gate.PAUSED and "unreachable" in desk.notices.text


def test_a_folder_that_cannot_be_written_is_told(tmp_path: Path, file: RoutineFile) -> None:
    desk = LedDesk(tmp_path)
    desk.led.start(file, False)
    path = progress_path(desk.place.state, file.path)
    path.unlink()
    path.mkdir()
    desk.led.tick()
    assert "not written" in desk.notices.text and "can't be resumed" in desk.notices.text
