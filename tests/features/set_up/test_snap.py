"""The best fit nearby: the cursor goes there, unless the operator went elsewhere meanwhile."""

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from typing import Any

import numpy as np
import pytest

from fleet_tui.features.set_up.snap import SNAP, PoseSnap
from fleet_tui.model.events import GridReceived
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import FREE, OCCUPIED
from fleet_tui.model.kind import SCAN
from fleet_tui.model.occupancy import build_grid
from fleet_tui.model.set_up.streams import Beams, Streamed
from fleet_tui.text.language import Message
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.map.modes.place import PlaceMode
from tests.support.desk import Desk, ready
from tests.support.fleets import F0, R0, reduced
from tests.support.map_pane import Pane

CELLS = np.full((200, 400), FREE, np.uint8)
CELLS[100, 40:120] = CELLS[60:101, 120] = OCCUPIED
FRAME = MapFrame(0.05, 400, 200)
GRID = build_grid(FRAME, CELLS)
TRUE, NEAR, FAR = Pose(5.0, 6.0), Pose(4.0, 6.5, 1.0), Pose(14.0, 1.0)
WALLS = np.array(
    [FRAME.to_world(column + 0.5, row + 0.5) for row, column in np.argwhere(CELLS == OCCUPIED)[::2]]
)
POINTS = (WALLS - (TRUE.x, TRUE.y)).astype(np.float32)


class Site:
    """A mode in which a pose is chosen, and searches that end when they are told to."""

    def __init__(self, pane: Pane, has_map: bool = True) -> None:
        self.desk = desk = Desk(reduced(ready(), *([GridReceived(R0, F0, GRID)] if has_map else [])))
        self.picture, self.controls = pane.map.picture, pane.controls
        self.searches = list[tuple[Callable[[], Any], Callable[[Any], None]]]()
        desk.backend.streams.watch(R0, SCAN)
        desk.in_background = lambda *search: self.searches.append(search)
        self.it = PoseSnap(desk.console(), self.controls, self.picture)
        pane.map.show(floor_scene(desk.store.state, desk.navigation.selection))

    def scans(self, beams: int = 10_000, is_sought: bool = False) -> None:
        now = self.desk.store.state.now
        points = POINTS[:beams]
        self.desk.backend.streams.put(
            R0, SCAN, Streamed(Beams(points, len(points), "laser", None, not is_sought, is_sought), now, now)
        )

    def chooses(self, pose: Pose, moves_scan: bool = True) -> PlaceMode:
        mode = PlaceMode(Message("POSE"), R0, F0, pose, moves_scan)
        self.controls.enter(mode)
        return mode

    def ends(self) -> None:
        work, then = self.searches.pop(0)
        then(work())

    @property
    def said(self) -> str:
        return self.desk.notices.text


@asynccontextmanager
async def site(has_map: bool = True) -> AsyncIterator[Site]:
    async with Pane().run_test(size=(100, 30)) as pilot:
        assert isinstance(pilot.app, Pane)
        yield Site(pilot.app, has_map)


async def test_the_cursor_goes_to_the_best_fit_and_nothing_is_sent() -> None:
    async with site() as it:
        it.scans()
        mode = it.chooses(NEAR)
        it.it.snap()
        assert it.said == "searching for the best fit nearby" and mode.pose == NEAR
        it.ends()
        assert mode.cursor == pytest.approx((TRUE.x, TRUE.y), abs=0.15)
        assert mode.yaw == pytest.approx(TRUE.yaw, abs=0.05)
        assert it.said == "100 % fit, 1.1 m and 57 degrees from the cursor"
        assert it.picture.options.cursor == mode.cursor
        assert not it.desk.backend.submitted and not it.desk.answers


async def test_a_fit_out_of_view_is_brought_into_it() -> None:
    async with site() as it:
        it.scans()
        mode = it.chooses(NEAR)
        scene = it.picture.scene
        assert scene is not None
        for _ in range(8):
            it.controls.zoom_in()
        it.controls.centre((NEAR.x - 1.0, NEAR.y + 1.0))
        it.it.snap()
        it.ends()
        camera = it.picture.viewport.camera(scene)
        assert camera.shows(*camera.to_cell(*scene.frame.to_pixel(*mode.cursor)))


async def test_without_a_better_one_the_cursor_stays() -> None:
    async with site() as it:
        it.scans()
        mode = it.chooses(FAR)
        it.it.snap()
        it.ends()
        assert mode.pose == FAR and it.said == "no better fit within 5 m of the cursor"


async def test_one_search_at_a_time_from_a_pose() -> None:
    async with site() as it:
        it.scans()
        it.chooses(NEAR)
        it.it.snap()
        it.it.snap()
        assert len(it.searches) == 1
        it.ends()
        it.it.snap()
        assert len(it.searches) == 1


async def test_a_cursor_that_was_moved_meanwhile_is_left_where_it_is() -> None:
    async with site() as it:
        it.scans()
        mode = it.chooses(NEAR)
        it.it.snap()
        mode.turn(5)
        turned = mode.pose
        it.ends()
        assert mode.pose == turned and it.said == "the cursor was moved during the search: press again"


async def test_a_mode_that_was_left_meanwhile_stays_left() -> None:
    async with site() as it:
        it.scans()
        mode = it.chooses(NEAR)
        it.it.snap()
        it.controls.leave_mode()
        it.ends()
        assert it.picture.mode is not mode and it.said == "searching for the best fit nearby"
        again = it.chooses(NEAR)
        it.it.snap()
        it.controls.enter(again)
        it.ends()
        assert again.pose != NEAR


async def test_a_fit_that_is_doubtful_says_so() -> None:
    async with site() as it:
        it.scans()
        it.chooses(Pose(11.0, 7.0))
        it.it.snap()
        it.ends()
        assert it.said.endswith(" degrees from the cursor: doubtful, search again or elsewhere")


async def test_a_goal_has_no_scan_to_fit() -> None:
    async with site() as it:
        it.scans()
        assert it.it.idle_keys == set()
        it.chooses(NEAR, moves_scan=False)
        it.it.snap()
        assert it.it.idle_keys == {SNAP} and not it.searches
        assert it.said == "only a pose of a robot with a laser scan can be fitted to the map"
        it.chooses(NEAR)
        assert it.it.idle_keys == set()


@pytest.mark.parametrize("beams", [None, 5])
async def test_without_a_scan_it_says_so(beams: int | None) -> None:
    async with site() as it:
        it.chooses(NEAR)
        if beams is not None:
            it.scans(beams)
        it.it.snap()
        assert not it.searches and it.said == "no scan to compare: press again when it has come"


async def test_a_laser_whose_place_is_being_read_is_waited_for() -> None:
    async with site() as it:
        it.chooses(NEAR)
        it.scans(is_sought=True)
        it.it.snap()
        assert not it.searches and it.said == "no scan to compare: press again when it has come"


async def test_without_a_map_it_says_so() -> None:
    async with site(has_map=False) as it:
        it.scans()
        it.chooses(NEAR)
        it.it.snap()
        assert not it.searches and it.said == "no map of floor_0 to compare the scan with"
