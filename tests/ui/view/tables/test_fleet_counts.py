"""The title of the fleet pane counts what its robots do."""

from fleet_tui.model.events import ObstacleReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.activity import activities
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.fleet import BESIDE, fleet_counts, fleet_table
from fleet_tui.ui.view.tables.table import Run
from tests.support.fleets import T0, battery, fleet, link_up, pose, queue, reduced, text_of, tick

WIDE = 100


def working(contact: float = 12.0) -> FleetState:
    """One robot drives, one stands without an order, one before an obstacle, one says no more
    than that it is there, one was never seen."""
    standing = [pose(at, robot=name) for name in ("robot_1", "robot_2") for at in (T0, T0 + 5)]
    before = reduced(fleet(5), link_up(T0), pose(T0), *standing, queue(T0 + 5, robot="robot_1"))
    obstacle = ObstacleReported("robot_2", T0 + 5, contact)
    return reduced(before, pose(T0 + 5, 5.0), obstacle, battery(T0 + 5, robot="robot_3"), tick(T0 + 5))


def calm() -> FleetState:
    return reduced(fleet(3), link_up(T0), *(pose(T0, robot=f"robot_{n}") for n in range(3)), tick(T0))


def counts(state: FleetState, width: int) -> list[Run]:
    return fleet_counts(state, activities(state, state.robots.values()), width)


def test_what_the_robots_do_is_counted_and_what_is_odd_is_first_and_coloured() -> None:
    told = counts(working(), WIDE)
    assert text_of(told) == " 4 of 5 online: 1 obstacle, 1 driving, 1 idle, 1 unknown"
    assert ("1 obstacle", StyleRole.WARN) in told and ("1 driving", StyleRole.DIM) in told
    passing = counts(working(2.0), WIDE)
    assert "obstacle" not in text_of(passing)


def test_the_counts_add_up_by_the_words_of_the_rows_or_only_what_is_odd_is_told() -> None:
    whole = " 4 of 5 online: 1 obstacle, 1 driving, 1 idle, 1 unknown"
    assert text_of(counts(working(), BESIDE + len(whole))) == whole
    assert text_of(counts(working(), BESIDE + len(whole) - 1)) == " 4 of 5 online: 1 obstacle"
    assert text_of(counts(calm(), BESIDE + len(" 3: 3 unknown"))) == " 3: 3 unknown", "all are online"
    assert text_of(counts(calm(), BESIDE + len(" 3: 3 unknown") - 1)) == " 3 of 3 online"
    rows = [text_of(row.runs) for row in fleet_table(working(), "robot_0", WIDE).rows]
    assert all(any(word in row for row in rows) for word in ("driving", "obstacle 12 s", "idle"))


def test_a_large_fleet_leaves_space_for_the_rows_in_view() -> None:
    state = reduced(fleet(30), link_up(T0), battery(T0), tick(T0))
    whole = " 1 of 30 online: 1 unknown"
    assert text_of(counts(state, BESIDE + len(whole) + len("  11-30 of 30"))) == whole
    assert text_of(counts(state, BESIDE + len(whole) + len("  11-30 of 30") - 1)) == " 1 of 30 online"


def test_in_a_title_without_space_for_both_trouble_is_told_and_not_who_is_online() -> None:
    assert text_of(counts(working(), BESIDE + len(" 4 of 5 online"))) == " 1 offline"
    assert text_of(counts(working(), BESIDE + 22)) == " 1 offline, 1 obstacle"
    assert text_of(counts(working(), 10)) == " 4 of 5 online"
