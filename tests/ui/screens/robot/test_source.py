"""The contents of a robot's page: curve and past alarms once they are read, of the selected robot alone."""

from pathlib import Path

from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.log import Audit
from fleet_tui.ui.screens.robot.page import PageSource
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.desk import CollectingBackend
from tests.support.fleets import R0, T0, battery, fleet, link_up, pose, reduced, text_of, tick
from tests.support.records import watched


class Page:
    """A source on a state and a robot that a test changes."""

    def __init__(self, audit: Audit | None = None) -> None:
        self.state, self.robot = level(T0), R0
        self.source = PageSource(
            lambda: (self.state, self.robot),
            lambda: audit,
            lambda _wall: "12:00:00",
            lambda: Drawing.ASCII,
            CollectingBackend(),
        )

    @property
    def text(self) -> str:
        return "\n".join(text_of(line) for line in self.source.lines(120, 30))

    def see(self, state: FleetState) -> None:
        self.state = state
        self.source.collect(state)


def level(at: float, percent: float = 80.0) -> FleetState:
    return reduced(fleet(2), link_up(T0), pose(at), battery(at, percent), tick(at))


def test_the_curve_comes_once_its_drawing_is_loaded_and_levels_were_seen() -> None:
    page = Page()
    assert "..." in page.text
    page.source.read(R0)
    assert "none seen yet" in page.text
    page.see(level(T0))
    assert "100 %+" in page.text and page.text.count("*") == 1


def test_the_curve_grows_with_the_levels_and_the_guess_is_in_its_title() -> None:
    page = Page()
    page.source.read(R0)
    for minute in range(21):
        for second in range(0, 60, 5):
            page.see(level(T0 + 60 * minute + second, 80.0 - minute - second / 60))
    assert "a guess: low at 12:00, about 59 min left" in page.text
    assert page.text.count("*") > 20


def test_past_alarms_are_those_of_the_robot_that_was_read(tmp_path: Path) -> None:
    store, audit = watched(tmp_path)
    store.watchers.append(audit.watch)
    for fact in (battery(T0, 5.0), tick(T0), battery(T0 + 1, 80.0), tick(T0 + 1), tick(T0 + 9)):
        store.apply(fact)
    assert audit.close(store.state) == 0
    page = Page(audit)
    page.source.read(R0)
    assert "over " in page.text and "battery 5 %" in page.text
    page.robot = "robot_1"
    assert "battery 5 %" not in page.text


def test_without_a_log_or_with_one_that_cannot_be_read_it_says_so(tmp_path: Path) -> None:
    page = Page()
    page.source.read(R0)
    assert "past ones: no audit log here" in page.text
    _, audit = watched(tmp_path)
    audit.close(fleet())
    audit.file.path.unlink(missing_ok=True)
    audit.file.path.mkdir()
    page = Page(audit)
    page.source.read(R0)
    assert "past ones: log not readable: Is a directory" in page.text
