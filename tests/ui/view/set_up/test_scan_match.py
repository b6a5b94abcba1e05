"""The match of the newest scan, at the pose where it was taken or at a candidate."""

import numpy as np
from msgspec.structs import replace

from fleet_tui.model.events import GridReceived
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import FREE, OCCUPIED
from fleet_tui.model.occupancy import build_grid
from fleet_tui.model.set_up.streams import Beams, Streamed
from fleet_tui.state.streams import Streams
from fleet_tui.ui.view.set_up.scan_match import is_old, newest_beams, scan_match, scan_pose
from tests.support.fleets import F0, R0, T0, fleet, pose, reduced, tick

CELLS = np.full((20, 20), FREE, np.uint8)
CELLS[:, 15] = OCCUPIED
GRID = build_grid(MapFrame(0.1, 20, 20), CELLS)
STATE = reduced(fleet(), GridReceived(R0, F0, GRID), pose(T0, 0.55, 1.0), tick(T0))
ROBOT = STATE.robots[R0]
BEAMS = Beams(np.array([[1.0, 0.0]] * 30, np.float32), 30, "laser", None, True)


def watched(at: float = T0) -> Streams:
    streams = Streams()
    streams.watch(R0, "scan")
    streams.note(ROBOT)
    streams.put(R0, "scan", Streamed(BEAMS, at, at))
    return streams


def test_a_scan_fits_where_it_was_taken() -> None:
    found = scan_match(STATE, ROBOT, F0, watched())
    assert found is not None and (found.share, found.beams) == (1.0, 30)
    elsewhere = scan_match(STATE, ROBOT, F0, watched(), Pose(0.05, 1.0))
    assert elsewhere is not None and elsewhere.share == 0.0
    assert scan_pose(ROBOT, watched()) == Pose(0.55, 1.0)


def test_what_is_unknown_has_no_match() -> None:
    assert scan_match(STATE, ROBOT, F0, Streams()) is None and scan_pose(ROBOT, Streams()) is None
    assert scan_match(STATE, ROBOT, "attic", watched()) is None
    assert scan_match(STATE, ROBOT, F0, watched(T0 - 1.0)) is None, "its pose at that time is unknown"
    assert newest_beams(replace(STATE, now=T0 + 9.0), ROBOT, watched()) is None
    late = replace(STATE, now=T0 + 1.5)
    assert is_old(late, ROBOT, watched()) and not is_old(late, ROBOT, watched(T0 + 1.0))
    assert newest_beams(late, ROBOT, watched()) is not None
