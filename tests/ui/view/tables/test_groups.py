"""A large fleet in groups: what each holds, and what a folded one keeps in view."""

from msgspec.structs import replace

from fleet_tui.model.events import PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.fleet import fleet_table
from fleet_tui.ui.view.tables.groups import GroupHead, RowGroups, head_row
from fleet_tui.ui.view.tables.listing import Listing
from tests.support.fleets import F0, R0, T0, battery, fleet, link_up, pose, reduced, text_of, tick

F1 = F0.replace("0", "1")
FIRST, SECOND = GroupHead("floor", F0), GroupHead("floor", F1)


def placed() -> FleetState:
    """Five robots: 0, 2 and 4 on the first floor, 1 and 3, whose battery is low, on the second."""
    poses = [pose(T0, robot=f"robot_{n}", frame=F1 if n % 2 else F0) for n in range(5)]
    return reduced(fleet(5, 2), link_up(T0), *poses, battery(T0, 5.0, "robot_3"), tick(T0))


def arranged(*folded: GroupHead) -> RowArrangement:
    arrangement = RowArrangement()
    assert arrangement.groups.next(placed())
    for head in folded:
        arrangement.groups.fold(head)
    return arrangement


def keys(arrangement: RowArrangement, selected: str = R0) -> list[object]:
    return list(fleet_table(placed(), selected, 80, arrangement).keys)


def test_each_group_has_a_head_and_trouble_first() -> None:
    assert keys(arranged()) == [FIRST, R0, "robot_2", "robot_4", SECOND, "robot_3", "robot_1"]
    table = fleet_table(placed(), R0, 80, arranged())
    assert text_of(table.rows[0].runs) == "- floor_0 3 robots"
    assert text_of(table.rows[4].runs) == "- floor_1 2 robots 1 with alarm"


def test_a_folded_group_keeps_its_counts_and_the_selected_robot() -> None:
    table = fleet_table(placed(), R0, 80, arranged(FIRST, SECOND))
    assert list(table.keys) == [FIRST, R0, SECOND]
    assert text_of(table.rows[2].runs) == "+ floor_1 2 robots 1 with alarm"
    assert keys(arranged(FIRST), "robot_1") == [FIRST, SECOND, "robot_3", "robot_1"]
    assert table.lines < fleet_table(placed(), R0, 80, arranged()).lines


def test_a_folded_head_tells_who_is_paused_among_its_robots() -> None:
    state = reduced(placed(), PausedReported("robot_2", T0, True))
    assert " 1 paused" in text_of(head_row(state, FIRST, True, ()).runs)
    assert "paused" not in text_of(head_row(state, FIRST, False, ()).runs), "there the rows tell it"


def test_heads_are_counted_as_rows_not_as_robots() -> None:
    arrangement, listing = RowArrangement(), Listing()
    state = placed()
    arrangement.groups.next(state)
    listing.cursor = next(iter(state.robots))
    listing.show(fleet_table(state, listing.cursor, 60, arrangement))
    title = text_of(listing.lines(60, 4, False)[0])
    total = len(state.robots) + 2
    assert f"rows 1-3 of {total}" in title


def test_a_filter_finds_robots_in_folded_groups_too() -> None:
    arrangement = arranged(FIRST, SECOND)
    arrangement.typed = "robot_4"
    assert keys(arrangement) == [FIRST, "robot_4"]


def test_robots_are_grouped_by_what_tells_them_apart() -> None:
    groups, alike = RowGroups(), fleet(3, 1)
    assert not groups.next(alike) and groups.by == ""
    other = replace(alike.robots["robot_1"], link="hall_b")
    links = {**alike.links, "hall_b": alike.links["rosbridge"]}
    two = replace(alike, robots={**alike.robots, "robot_1": other}, links=links)
    assert groups.next(two) and groups.by == "link"
    assert groups.next(two) and groups.by == ""


def test_offline_robots_are_counted_in_the_head_and_a_new_floor_has_its_own_group() -> None:
    later = reduced(placed(), *(pose(T0 + 9, robot=f"robot_{n}", frame=F0) for n in range(4)), tick(T0 + 9))
    arrangement = arranged()
    table = fleet_table(later, R0, 80, arrangement)
    assert "5 robots" in text_of(table.rows[0].runs) and "1 offline" in text_of(table.rows[0].runs)
    lost = reduced(later, pose(T0 + 9, robot="robot_2", frame="elsewhere"), tick(T0 + 9))
    names = [key.name for key in fleet_table(lost, R0, 80, arrangement).keys if isinstance(key, GroupHead)]
    assert names[0] == F0 and len(names) == 2
