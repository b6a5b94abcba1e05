"""The clearance ahead is worked out anew ten times a second at most, and at once in another direction."""

import pytest
from msgspec.structs import replace

from fleet_tui.commands.driving import clearance as rule
from fleet_tui.features.drive.controls import EVERY, ClearanceAhead
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.set_up.driving import STILL, Speeds
from tests.support.fleets import F0, R0, fleet, link_up, pose, reduced, tick
from tests.support.map_pane import SCENE

AHEAD = Speeds(0.1)


def hall(x: float) -> FleetState:
    """robot_0 at x in a hall of 20 by 10 metres, looking east."""
    state = reduced(fleet(1), link_up(1.0), pose(1.0, x, 5.0), tick(1.1))
    floor = replace(state.floors[F0], grid=SCENE.grid, tied=True)
    return replace(state, floors={**state.floors, F0: floor})


def test_it_tells_the_metres_to_the_wall() -> None:
    state = hall(19.0)
    found = ClearanceAhead().of(state, state.robots[R0], AHEAD, 0.0)
    assert found == pytest.approx(0.95 - rule.USUAL_SIZE[0] / 2, abs=0.06)


def test_without_a_map_or_motion_there_is_none() -> None:
    state = hall(19.0)
    assert ClearanceAhead().of(state, state.robots[R0], STILL, 0.0) is None
    bare = reduced(fleet(1), link_up(1.0), pose(1.0, 19.0, 5.0), tick(1.1))
    assert ClearanceAhead().of(bare, bare.robots[R0], AHEAD, 0.0) is None


def test_it_looks_again_only_after_a_while_or_in_another_direction() -> None:
    ahead, near, nearer = ClearanceAhead(), hall(18.5), hall(19.0)
    first = ahead.of(near, near.robots[R0], AHEAD, 10.0)
    assert ahead.of(nearer, nearer.robots[R0], AHEAD, 10.0 + EVERY / 2) == first
    back = ahead.of(nearer, nearer.robots[R0], Speeds(-0.1), 10.0 + EVERY / 2)
    assert back == rule.FAR
    later = ahead.of(nearer, nearer.robots[R0], AHEAD, 10.0 + 2 * EVERY)
    assert first is not None and later is not None and later < first
