"""The streams of the selected robot: watched while they are shown, and no longer."""

import numpy as np
from msgspec.structs import replace

from fleet_tui.model.kind import PATH, SCAN
from fleet_tui.model.set_up.streams import Beams, PlannedPath, Streamed
from fleet_tui.ui.controllers.streams import ShownStreams
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.scene import Scene
from tests.support.desk import Desk, ready
from tests.support.fleets import T0, of_kinds, pose, reduced, tick

KIND = replace(ready().robots["robot_0"].kind, streams=(SCAN, PATH))
POINTS = np.array([[1.0, 0.0], [0.0, 1.0]], np.float32)


def shown(kind: object = KIND, explains: bool = False) -> tuple[Desk, ShownStreams, Scene]:
    assert isinstance(kind, type(KIND))
    desk = Desk(reduced(of_kinds(ready(), kind), pose(T0 + 1), tick(T0 + 1)))
    streams = ShownStreams(desk.store, desk.backend, desk.navigation, desk.notices, MapPicture())
    streams.explains = lambda: explains
    return desk, streams, floor_scene(desk.store.state, desk.navigation.selection)


def test_a_scan_is_watched_drawn_and_left() -> None:
    desk, streams, scene = shown()
    assert streams.on(scene) is scene and streams.match() is None
    streams.laser()
    assert streams.on(scene).beams is None
    live = desk.backend.streams
    assert live.wants("robot_0", SCAN) and not live.wants("robot_0", PATH)
    live.note(desk.store.state.robots["robot_0"])
    sought = Beams(POINTS, 3, "laser", None, False, is_sought=True)
    live.put("robot_0", SCAN, Streamed(sought, T0 + 1, T0 + 1))
    assert streams.on(scene).beams is POINTS and "of 3 beams" not in desk.notices.text
    live.put("robot_0", SCAN, Streamed(Beams(POINTS, 3, "laser", None, False), T0 + 1, T0 + 1))
    found = streams.on(scene)
    assert found.beams is POINTS and found.beams_at is not None and not found.beams_are_old
    assert "2 of 3 beams, laser offset unknown" in desk.notices.text
    streams.laser()
    assert streams.on(scene).beams is None and not live.wants("robot_0", SCAN)


def test_a_scan_without_a_pose_of_its_time_is_old_and_an_old_scan_is_gone() -> None:
    desk, streams, scene = shown()
    streams.laser()
    streams.on(scene)
    beams = Beams(POINTS, 2, "laser", None, True)
    desk.backend.streams.put("robot_0", SCAN, Streamed(beams, T0 + 1, T0 - 5))
    assert streams.on(scene).beams_are_old
    desk.backend.streams.put("robot_0", SCAN, Streamed(beams, T0 - 5, T0 - 5))
    assert streams.on(scene).beams is None


def test_while_reasons_are_shown_the_scan_is_watched_and_not_drawn() -> None:
    desk, streams, scene = shown(explains=True)
    streams.on(scene)
    live = desk.backend.streams
    assert live.wants("robot_0", SCAN)
    live.put("robot_0", SCAN, Streamed(Beams(POINTS, 2, "laser", None, True), T0 + 1, T0 + 1))
    assert streams.on(scene).beams is None and not desk.notices.text
    streams.laser()
    assert streams.on(scene).beams is POINTS


def test_a_path_is_gone_after_ten_seconds() -> None:
    desk, streams, scene = shown()
    streams.path()
    streams.on(scene)
    for at, seen in ((T0, True), (T0 - 20, False)):
        desk.backend.streams.put("robot_0", PATH, Streamed(PlannedPath(POINTS, "map", None), at, at))
        assert (streams.on(scene).path is not None) == seen


def test_a_kind_without_a_scan_says_so() -> None:
    desk, streams, scene = shown(ready().robots["robot_0"].kind)
    streams.laser()
    streams.on(scene)
    assert "laser scan" in desk.notices.text
    assert not desk.backend.streams.wants("robot_0", SCAN)
