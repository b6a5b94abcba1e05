"""The progress of the current order in a few words, empty without fresh data."""

import msgspec

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation import Progress
from fleet_tui.model.robot import Reading
from fleet_tui.view.tables.progress import progress_text
from tests.support.fleets import R0, T0, fleet, link_up, of_kinds, pose, queue, reduced, tick


def text(progress: Progress, at: float = T0) -> str:
    driving = queue(T0, (1, 1, 2, "W"), current=1)
    state: FleetState = reduced(
        of_kinds(fleet(), Kind("k", ("pose",))), link_up(T0), pose(at), driving, tick(at)
    )
    robot = msgspec.structs.replace(state.robots[R0], progress=Reading(progress, T0))
    return progress_text(state, robot, robot.orders.orders[0])


def test_what_is_told_stands_there_in_its_order() -> None:
    assert text(Progress("1", metres=12.5, seconds=31.0, recoveries=2)) == "12.5 m left, 31 s, 2 recoveries"
    assert text(Progress("1", metres=250.4, recoveries=1)) == "250 m left, 1 recovery"


def test_of_several_stops_it_says_which() -> None:
    assert text(Progress("1", stop=0)) == "stop 1 of 2"
    assert text(Progress("1", stop=7)) == "stop 2 of 2"


def test_what_is_old_is_not_said() -> None:
    assert text(Progress("1", metres=1.0), at=T0 + 60.0) == ""
