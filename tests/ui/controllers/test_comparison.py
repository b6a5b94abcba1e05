"""The scan's word on a pose that was set: how well it fits, before and after."""

import numpy as np
import pytest

from fleet_tui.model.commands import Stage
from fleet_tui.model.events import Event, GridReceived
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import FREE, OCCUPIED
from fleet_tui.model.kind import SCAN
from fleet_tui.model.occupancy import build_grid
from fleet_tui.model.set_up.commands import SetPose
from fleet_tui.model.set_up.streams import Beams, Streamed
from fleet_tui.ui.controllers.comparison import GIVEN_UP, ScanComparison
from tests.support.desk import Desk, ready
from tests.support.fleets import F0, R0, T0, commanded, pose, reduced, tick

CELLS = np.full((20, 20), FREE, np.uint8)
CELLS[:, 15] = OCCUPIED
GRID = build_grid(MapFrame(0.1, 20, 20), CELLS)
BEAMS = Beams(np.array([[1.0, 0.0]] * 30, np.float32), 30, "laser", None, True)
FITS, ELSEWHERE = 0.55, 0.05  # metres from the left: the wall is a metre before the first


class Site:
    """A robot a metre before a wall, or elsewhere, whose laser sees the wall a metre ahead."""

    def __init__(self) -> None:
        self.desk = Desk(reduced(ready(), GridReceived(R0, F0, GRID)))
        self.streams = self.desk.backend.streams
        self.streams.watch(R0, SCAN)
        self.it = ScanComparison(self.desk.store, self.desk.backend, self.desk.notices)

    def happens(self, *facts: Event) -> None:
        self.desk.store.put(reduced(self.desk.store.state, *facts))

    def stands(self, x: float, at: float) -> None:
        """It is at x, and a scan is taken there."""
        self.happens(pose(at, x, 1.0), tick(at))
        self.streams.note(self.desk.store.state.robots[R0])
        self.streams.put(R0, SCAN, Streamed(BEAMS, at, at))

    def is_set(self, *stages: Stage) -> None:
        """Its pose is set; the outcome comes two seconds later."""
        self.it.begin(R0, F0)
        begun = self.desk.store.state.now
        self.happens(*commanded(1, SetPose(R0, F0, Pose(FITS, 1.0)), *stages, at=begun + 2.0))
        self.it.look()


@pytest.mark.parametrize(
    ("first", "then", "words"),
    [
        (ELSEWHERE, FITS, f"{R0}: 100 % of the scan fits the map, 0 % before"),
        (FITS, ELSEWHERE, f"{R0}: worse, look at the scan (u): 0 % of the scan fits the map, 100 % before"),
    ],
)
def test_both_are_said(first: float, then: float, words: str) -> None:
    site = Site()
    site.stands(first, T0 + 1)
    site.is_set(Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED)
    assert site.it.robot == R0 and "scan" not in site.desk.notices.text
    site.stands(then, T0 + 4)
    site.it.look()
    assert (site.desk.notices.text, site.it.robot) == (words, "")


def test_a_poor_fit_is_doubtful_though_it_is_better() -> None:
    site = Site()
    site.stands(ELSEWHERE, T0 + 1)
    site.is_set(Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED)
    site.stands(ELSEWHERE, T0 + 4)
    site.it.look()
    assert site.desk.notices.text.startswith(f"{R0}: doubtful, look at the scan (u): ")


def test_before_the_outcome_nothing_is_said() -> None:
    site = Site()
    site.is_set(Stage.SENT)
    site.stands(FITS, T0 + 4)
    site.it.look()
    assert site.it.robot == R0 and "scan" not in site.desk.notices.text


def test_without_a_scan_it_ends() -> None:
    site = Site()
    site.stands(FITS, T0 + 1)
    site.is_set(Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED)
    site.happens(tick(T0 + 4 + GIVEN_UP))
    site.it.look()
    assert site.it.robot == "" and "scan" not in site.desk.notices.text
