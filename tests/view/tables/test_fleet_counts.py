"""The title of the fleet pane counts what its robots do."""

from fleet_tui.model.events import ObstacleReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.fleet_counts import BESIDE, fleet_counts
from tests.support.fleets import T0, battery, fleet, link_up, pose, queue, reduced, text_of, tick

WIDE = 100


def working() -> FleetState:
    """One robot drives, one stands without an order, one before an obstacle, one says no more
    than that it is there, one was never seen."""
    standing = [pose(at, robot=name) for name in ("robot_1", "robot_2") for at in (T0, T0 + 5)]
    before = reduced(fleet(5), link_up(T0), pose(T0), *standing, queue(T0 + 5, robot="robot_1"))
    obstacle = ObstacleReported("robot_2", T0 + 5, 9.0)
    return reduced(before, pose(T0 + 5, 5.0), obstacle, battery(T0 + 5, robot="robot_3"), tick(T0 + 5))


def calm() -> FleetState:
    return reduced(fleet(3), link_up(T0), *(pose(T0, robot=f"robot_{n}") for n in range(3)), tick(T0))


def test_what_the_robots_do_is_counted_and_what_is_odd_is_first_and_coloured() -> None:
    counts = fleet_counts(working(), WIDE)
    assert text_of(counts) == " 4 of 5 online: 1 blocked, 1 driving, 1 idle"
    assert ("1 blocked", StyleRole.WARN) in counts and ("1 driving", StyleRole.DIM) in counts


def test_in_a_narrow_title_whole_counts_are_left_out_from_the_end() -> None:
    whole = " 4 of 5 online: 1 blocked, 1 driving"
    assert text_of(fleet_counts(working(), BESIDE + 3 + len(whole))) == whole
    assert text_of(fleet_counts(working(), BESIDE + 3 + len(whole) - 1)) == " 4 of 5 online: 1 blocked"
    assert text_of(fleet_counts(calm(), BESIDE + 3 + len(" 3 of 3 online"))) == " 3 of 3 online"


def test_in_a_title_without_space_for_both_trouble_is_told_and_not_who_is_online() -> None:
    assert text_of(fleet_counts(working(), BESIDE + 3 + len(" 4 of 5 online"))) == " 1 offline"
    assert text_of(fleet_counts(working(), BESIDE + 3 + 21)) == " 1 offline, 1 blocked"
    assert text_of(fleet_counts(working(), 20)) == " 4 of 5 online"
