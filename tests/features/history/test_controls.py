"""Page, time and what Enter opens, without a screen."""

import time
from pathlib import Path

import pytest

from fleet_tui.features.history.controls import NO_HISTORY, SPANS, HistoryControls
from fleet_tui.features.history.replaying import PastReplay
from fleet_tui.text.language import EMPTY
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.widgets.rows_pane import RowsPane
from tests.support.desk import Desk, ready
from tests.support.past import kept_history, put
from tests.support.shift import shift


class View:
    """An overlay that only remembers."""

    def __init__(self) -> None:
        self.rows, self.parts, self.looks, self.went = RowsPane(id="rows"), 40, 0, list[str]()

    def look(self) -> None:
        self.looks += 1

    def action_filter(self) -> None:
        self.went.append("filter")

    def put_filter(self, text: str) -> None:
        self.went.append(text)

    def action_back(self) -> None:
        self.went.append("back")


Made = tuple[HistoryControls, View]


@pytest.fixture
def files() -> ConsoleFiles:
    return ConsoleFiles()


@pytest.fixture
def made(tmp_path: Path, files: ConsoleFiles) -> Made:
    console, view = Desk(ready()).console(files), View()
    replaying = PastReplay(console, tmp_path, lambda: EMPTY, lambda _command: EMPTY)
    return HistoryControls(view, console, replaying), view


def test_without_a_history_it_says_so(made: Made) -> None:
    controls, view = made
    controls.page(1)
    assert controls.shown.problem == NO_HISTORY and view.looks


def test_a_young_history_is_shown_at_its_own_length(made: Made, files: ConsoleFiles, tmp_path: Path) -> None:
    controls, _ = made
    put(tmp_path, shift(time.time() - 3000))
    with kept_history(tmp_path) as writer:
        files.history = writer
        controls.page(1)
        assert controls.span == "1 h"  # it began 50 minutes ago
        assert controls.shown.time.until - controls.shown.time.since == SPANS["1 h"]
        for _ in range(9):
            controls.stretch(1)
        assert controls.span == "30 d"
        controls.step_page(-1)
        assert controls.name == "Places" and controls.shown.places
        controls.step_page(1)
        assert controls.name == "Events" and controls.shown.events


def test_a_shift_to_later_ends_now_again(made: Made) -> None:
    controls, _ = made
    controls.shift(-1)
    assert 0.0 < controls.until < time.time()
    controls.shift(1)
    controls.shift(1)
    assert controls.until == 0.0


def test_what_enter_opens(made: Made) -> None:
    controls, view = made
    controls.page(3)
    controls.choose("robot_1")
    assert controls.chart == "robot_1"
    controls.leave()
    assert controls.chart == "" and view.went == []
    controls.page(2)
    controls.choose("robot_1")
    assert view.went == ["robot_1"] and controls.name == "Events"
    controls.replay()
    assert controls.notice.startswith("no recording covers this moment"), "the end of the time shown"
    controls.leave()
    assert view.went[-1] == "back"
