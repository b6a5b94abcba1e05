"""Activities of the last minutes."""

from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.ui.view.activity_bars import CELLS, FIRST, LAST, RecentActivity, activity_table
from tests.support.fleets import R0, T0, fleet, link_lost, link_up, pose, queue, reduced, text_of, tick

IDLE = Activity.IDLE


def seen(at: float) -> FleetState:
    return reduced(fleet(2), link_up(T0 - 9), pose(T0), pose(at), queue(at), tick(at))


def watched(*seconds: float) -> RecentActivity:
    recent = RecentActivity()
    for at in seconds:
        recent.note(seen(T0 + at))
    return recent


def test_a_part_for_every_so_many_seconds_the_newest_last() -> None:
    recent = watched(0.0, 1.0, FIRST - 0.1, FIRST, 4 * FIRST)
    assert recent.of(R0, 5) == [Activity.DRIVING, Activity.DRIVING, None, None, IDLE]
    assert recent.of(R0, 1) == [IDLE]


def test_time_that_was_not_watched_and_robots_that_were_never_seen_are_blank() -> None:
    recent = watched(0.0, 4 * FIRST)
    assert recent.of(R0, 5) == [Activity.DRIVING, None, None, None, IDLE]
    assert recent.of("robot_1", 5) == [None] * 5


def test_cells_of_the_start_are_short_and_later_ones_as_long_as_the_memory_needs() -> None:
    recent = RecentActivity()
    state = seen(T0 + 9.0)
    for n in range(CELLS * 9):
        recent.note(replace(state, now=state.now + n * FIRST))
        assert n * FIRST < LAST or recent.of(R0, 3) != [None] * 3
    assert recent.every == LAST and None not in recent.of(R0, CELLS // 2)


def test_nothing_is_known_before_an_earlier_time_nor_behind_a_lost_link() -> None:
    recent = watched(0.0, FIRST, 5.0)
    assert recent.of(R0, 3) == [None, None, IDLE]
    recent.note(reduced(seen(T0 + 5.0), link_lost(T0 + 6.0), tick(T0 + 5.0 + FIRST)))
    assert recent.of(R0, 2) == [IDLE, None]


def test_a_pane_has_as_many_robots_as_lines_and_says_since_when() -> None:
    table = activity_table(watched(FIRST, 2 * FIRST), [R0, "robot_1"], 3, 20, is_ascii=False)
    assert [text_of(row.runs) for row in table.rows] == ["robot_0     ▆▆▆▆▁▁▁▁"]
    assert text_of(table.title) == "Activity  ▆ driving  ▁ idle"
    assert text_of(table.head) == "        4 s ago  now"


def test_bars_fill_their_cells_while_there_are_few_parts() -> None:
    found = {}
    for count in (1, 2, 3, 7, 12, 13):
        recent = watched(*(n * FIRST for n in range(count)))
        each = recent.width_of_part(12)
        found[count] = each, sum(part is not None for part in recent.of(R0, 12, each))
    assert found == {1: (8, 8), 2: (4, 8), 3: (4, 12), 7: (1, 7), 12: (1, 12), 13: (1, 12)}


def test_lines_to_spare_say_how_long_each_robot_did_what() -> None:
    recent = watched(*(n * FIRST for n in range(8)))
    rows = [text_of(row.runs) for row in activity_table(recent, [R0, "robot_1"], 6, 60, False).rows]
    assert [row[:8].strip() for row in rows] == [R0, "", "robot_1", ""]
    assert rows[1].strip() == "driving 2 s, idle 8 s" and not rows[3].strip()
    assert len(activity_table(recent, [R0, "robot_1"], 5, 60, False).rows) == 2
