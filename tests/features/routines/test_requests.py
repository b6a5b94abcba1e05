"""The menu of a routine: what can be done in its state, and nothing without a question."""

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.features.routines.folder import RoutinePlace
from fleet_tui.features.routines.led import LedRoutines
from fleet_tui.features.routines.owner import RobotLocks
from fleet_tui.features.routines.requests import RoutineRequests
from fleet_tui.ui.controllers.typed import Entry
from tests.support.desk import Desk
from tests.support.routines import two_robots

TEXT = "for robot_0\ncarry Base Consumidores\nend\nfor robot_1\nwait 5 min\nend\n"


class RequestDesk(Desk):
    """A desk whose menus and questions are kept, and whose background work is done at once."""

    def __init__(self, folder: Path) -> None:
        super().__init__(two_robots())
        self.place = RoutinePlace(folder, folder / "state")
        self.opened = list[tuple[str, Sequence[Entry]]]()
        self.texts = list[str]()
        self.questions = list[tuple[str, Callable[[], None]]]()
        console = replace(
            self.console(),
            ask=lambda question, then: self.questions.append((question(), then)),
            open_menu=lambda title, entries, marked=0, *, searched=False: self.opened.append(
                (title, entries)
            ),
        )
        self.requests = RoutineRequests(self.place, console, LedRoutines(self.place, console))
        self.requests.look()

    def menu(self, robot: str = "") -> dict[str, Callable[[], object]]:
        self.requests.menu("day", robot, lambda title, _lines: self.texts.append(title))
        return dict(self.opened[-1][1])

    def start(self) -> None:
        self.menu()["Start"]()
        self.questions[-1][1]()
        self.requests.tick()


@pytest.fixture
def desk(tmp_path: Path) -> RequestDesk:
    (tmp_path / "day.routine").write_text(TEXT)
    return RequestDesk(tmp_path)


def test_a_start_is_asked_and_then_led(desk: RequestDesk) -> None:
    desk.menu()["Start"]()
    assert desk.questions[0][0].startswith("Start day with robot_0, robot_1?")
    assert desk.backend.submitted == []
    desk.questions[0][1]()
    desk.requests.tick()
    assert len(desk.backend.submitted) == 1 and desk.requests.rows[0].owner == "this console"


def test_what_runs_here_can_be_paused_resumed_and_stopped_for_one_robot_or_all(desk: RequestDesk) -> None:
    desk.start()
    menu = desk.menu("robot_1")
    assert desk.opened[-1][0] == "day robot_1: waiting\nline 5: wait 5 min"
    assert [*menu] == [
        "Pause: running orders continue, nothing new starts",
        "Stop: running orders continue",
        "Check: problems or timeline",
    ]
    menu["Pause: running orders continue, nothing new starts"]()
    assert [*desk.menu("robot_1")][:2] == ["Resume", "Step: one instruction"]
    assert "Resume" in desk.menu() and "Resume" not in desk.menu("robot_0")
    desk.menu()["Stop: running orders continue"]()
    assert [*desk.menu()] == ["Start", "Check: problems or timeline"]
    assert desk.opened[-1][0] == "day: stopped"


def test_one_that_another_process_leads_can_only_be_checked(desk: RequestDesk) -> None:
    desk.start()
    other = RequestDesk(desk.place.folder)
    assert [*other.menu()] == ["Check: problems or timeline"] and "run by" in other.opened[-1][0]


def test_robots_that_are_led_elsewhere_and_problems_are_told(desk: RequestDesk) -> None:
    RobotLocks(desk.place.state, {"robot_1": "ws://site:9090"}, "ana (process 3)").claim()
    desk.start()
    assert "day: not started: robot_1 is run by ana (process 3)" in desk.notices.text
    desk.place.folder.joinpath("day.routine").write_text("for robot_0\ngo\nend\n")
    desk.menu()["Start"]()
    desk.menu()["Check: problems or timeline"]()
    assert desk.texts == ["day: not started", "day: problems"] and len(desk.questions) == 1


def test_a_routine_that_is_gone_has_no_menu(desk: RequestDesk) -> None:
    desk.requests.menu("other", "", lambda _title, _lines: None)
    assert desk.opened == []
