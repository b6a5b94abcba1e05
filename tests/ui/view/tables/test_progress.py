"""The progress of the current order in a few words, empty without fresh data."""

import msgspec

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation import Progress
from fleet_tui.model.robot import Reading
from fleet_tui.ui.view.tables.fleet import WITH_LEFT, fleet_table
from fleet_tui.ui.view.tables.missions import progress_text
from tests.support.fleets import R0, T0, fleet, link_up, of_kinds, pose, queue, reduced, text_of, tick
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import node, state


def driving(progress: Progress, at: float = T0) -> FleetState:
    order = queue(T0, (1, 1, 2, "W"), current=1)
    state = reduced(of_kinds(fleet(), Kind("k", ("pose",))), link_up(T0), pose(at), order, tick(at))
    robot = msgspec.structs.replace(state.robots[R0], progress=Reading(progress, T0))
    return msgspec.structs.replace(state, robots={R0: robot})


def text(progress: Progress, at: float = T0) -> str:
    state = driving(progress, at)
    robot = state.robots[R0]
    return progress_text(state, robot, robot.orders.orders[0])


def test_in_the_fleet_it_is_whole_or_shorter_never_cut() -> None:
    state = driving(Progress("1", metres=9.5, seconds=31.0, stop=0, recoveries=2))
    rows = {width: text_of(fleet_table(state, R0, width).rows[0].runs) for width in range(36, 140)}
    assert all("9.5 m" in rows[width] and "stop 1 of 2, 2 recoveries" in rows[width] for width in (130, 139))
    for width, row in rows.items():
        assert len(row.rstrip()) <= width, row
        assert "m left" in row or "9.5" not in row or width >= WITH_LEFT, row


def test_what_is_told_stands_there_in_its_order() -> None:
    assert text(Progress("1", metres=9.5, seconds=31.0, recoveries=2)) == "9.5 m left, 31 s, 2 recoveries"
    assert text(Progress("1", metres=12.4, recoveries=1)) == "12 m left, 1 recovery"
    assert text(Progress("1", metres=250.4, recoveries=1)) == "250 m left, 1 recovery"


def test_seconds_alone_are_told_from_those_of_standing() -> None:
    assert text(Progress("1", seconds=31.0)) == "31 s left"


def test_of_several_stops_it_says_which() -> None:
    assert text(Progress("1", stop=0)) == "stop 1 of 2"
    assert text(Progress("1", stop=7)) == "stop 2 of 2"


def test_what_is_old_is_not_said() -> None:
    assert text(Progress("1", metres=1.0), at=T0 + 60.0) == ""


def test_a_vehicle_of_a_master_control_has_nodes_left() -> None:
    site = VehicleSite()
    site.read("state", state(orderId="o", nodeStates=[node("a", 2), node("b", 4, released=False)]))
    order = site.agv.orders.current
    assert order is not None and progress_text(site.state, site.agv, order) == "2 nodes left"
    site.wait(40)
    assert progress_text(site.state, site.agv, order) == ""
