"""Lines go where rows need them; every pane keeps a place, and none is wasted."""

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from fleet_tui.ui.view.layout import (
    BUTTONS,
    LEAST_LIST,
    LEAST_MAP,
    LEAST_TABLES,
    Wanted,
    below_buttons,
    below_floor,
    below_map,
    below_narrow_floor,
    below_page,
    beside_map,
    dialog_box,
    is_beside_events,
    is_better_beside,
    width_of_map,
    without_map,
)

wishes = st.builds(Wanted, st.integers(2, 502), st.integers(2, 60), st.integers(2, 60))


@given(st.integers(13, 200), wishes)
def test_every_line_beside_the_map_is_given_away_and_every_pane_has_some(lines: int, wanted: Wanted) -> None:
    assert sum(beside_map(lines, wanted, is_queue_below=True)) == lines
    heights = beside_map(lines, wanted)
    assert sum(heights) == lines
    assert min(heights[:3]) >= LEAST_LIST - 1


@given(st.integers(13, 200), wishes)
def test_every_line_of_a_narrow_screen_is_given_away(lines: int, wanted: Wanted) -> None:
    for covered in (0, 5, 11):
        heights = below_map(lines, wanted, covered)
        assert sum(heights) == lines
        assert heights[0] <= max(1, lines - covered)
    heights = below_map(lines, wanted)
    assert min(heights) >= LEAST_LIST
    assert lines < 20 or heights[0] >= LEAST_MAP


def test_a_floor_is_beside_the_tables_where_that_shows_it_larger() -> None:
    wanted = Wanted(14, 2, 2)
    assert is_better_beside(80, 21, wanted, 0.4)
    assert not is_better_beside(80, 21, wanted, 0.1), "a corridor"
    assert not is_better_beside(70, 21, wanted, 0.4), "no space for the fleet"


@given(st.integers(120, 300), st.integers(13, 100), st.floats(0.01, 10.0))
def test_a_map_takes_more_than_its_share_only_for_a_larger_floor_and_leaves_the_tables_theirs(
    width: int, lines: int, shape: float
) -> None:
    cells, share = width_of_map(width, lines, shape), round(width * 0.6)
    assert share <= cells <= max(share, width - LEAST_TABLES)
    assert cells == share or (cells - 2) * shape <= lines


def test_a_usual_floor_fills_a_large_screen() -> None:
    assert width_of_map(120, 37, 0.33) == 72
    assert width_of_map(200, 57, 0.33) == 123
    assert width_of_map(200, 57, 1.0) == 120
    assert width_of_map(200, 57, 0.33, 92) == 108, "an enlarged table has all its columns"
    assert width_of_map(120, 37, 0.33, 92) == 60


def test_thirty_robots_have_twenty_four_rows_at_120_by_40() -> None:
    assert beside_map(37, Wanted(32, 3, 3))[0] >= 24 + 2
    assert beside_map(37, Wanted(32, 12, 9))[0] >= 16


def test_robots_have_the_blank_lines_if_they_need_them() -> None:
    assert beside_map(21, Wanted(32, 2, 2)) == (17, 2, 2, 0)
    assert beside_map(21, Wanted(14, 2, 2)) == (15, 3, 3, 0)


@pytest.mark.parametrize("robots", range(2, 40))
@pytest.mark.parametrize("lines", [21, 27, 37, 57])
@pytest.mark.parametrize("is_below", [True, False])
def test_no_more_than_a_few_lines_are_blank_while_the_robots_page_is_hidden(
    lines: int, robots: int, is_below: bool
) -> None:
    wanted = Wanted(robots + 2, 2, 2)
    fleet, alarms, queue, page = beside_map(lines, wanted, is_below)
    blank = fleet + alarms + queue - sum(wanted[: 2 + (not is_below)])
    assert page or blank <= 3


def test_a_small_fleet_leaves_lines_to_the_robots_page() -> None:
    assert beside_map(37, Wanted(5, 2, 2)) == (6, 3, 3, 25)


def test_small_maps_have_what_the_robots_page_can_spare() -> None:
    assert below_page(57, 44, 80) == 28
    assert below_page(57, 36, 80) == 24 and below_page(57, 35, 80) == 24, "no blank below the page"
    assert below_page(57, 24, 80) == 12
    assert below_page(57, 20, 80) == 9, "30 robots beside a whole page"
    assert below_page(57, 16, 80) == 9, "fewer values"
    assert below_page(57, 15, 80) == 0, "the page is not cut"
    assert below_page(37, 25, 48) == 0, "a column too narrow for a floor"


def test_small_maps_are_where_they_are_larger_and_stay_there() -> None:
    assert is_beside_events(16, 123, 57, 32, 77), "30 robots leave their page few lines"
    assert not is_beside_events(16, 123, 57, 5, 77), "3 robots"
    assert not is_beside_events(12, 72, 37, 5, 48), "a map too narrow for both"
    assert not is_beside_events(0, 123, 57, 32, 77)


def test_last_events_fill_what_a_narrow_floor_leaves_from_three_lines_on() -> None:
    assert below_floor(21, 16, is_narrow=True) == 4
    assert below_floor(21, 18, is_narrow=True) == 0
    assert below_floor(21, 16) == 0 and below_floor(57, 41) == 16


def test_a_dialog_is_over_the_last_events_else_at_the_end_of_the_tables_and_never_over_the_map() -> None:
    assert dialog_box((72, 12), 72, 120, 37) == (0, 72, 12)
    assert dialog_box((61, 16), 123, 200, 57) == (0, 61, 16), "small maps beside the events stay in view"
    assert dialog_box((37, 6), 37, 80, 21) == (38, 42, 14)
    assert dialog_box((61, 6), 123, 200, 57, usual=28) == (124, 76, 28)
    assert dialog_box((37, 6), 37, 80, 21, usual=10) == (38, 42, 14)
    assert dialog_box((0, 0), 72, 120, 13) == (73, 47, 9), "the first robots stay in view"


def test_the_queue_is_below_a_narrow_floor_and_the_last_events_have_what_it_leaves() -> None:
    assert below_narrow_floor(6, 2) == (2, 4) and below_narrow_floor(6, 4) == (4, 2)
    assert below_narrow_floor(6, 5) == (6, 0) and below_narrow_floor(6, 60) == (6, 0)
    assert below_narrow_floor(3, 2) == (3, 0) and below_narrow_floor(0, 2) == (0, 0)
    assert beside_map(21, Wanted(32, 2, 2), is_queue_below=True) == (19, 2, 0, 0)
    assert beside_map(21, Wanted(5, 2, 9), is_queue_below=True) == (6, 3, 0, 12)


def test_more_alarms_have_more_lines() -> None:
    assert beside_map(37, Wanted(14, 9, 2))[1] == 10
    assert below_map(21, Wanted(14, 9, 2))[2] == 5


@example(21, Wanted(14, 9, 2))
@given(st.integers(13, 200), wishes)
def test_the_simple_interface_leaves_every_line_it_does_not_need(lines: int, wanted: Wanted) -> None:
    heights = below_buttons(lines, wanted)
    assert sum(heights) == lines
    assert min(heights) >= LEAST_LIST
    assert lines < 20 or heights[0] == BUTTONS


@given(st.integers(6, 40), wishes)
def test_a_screen_without_a_map_gives_its_lines_to_the_robots(lines: int, wanted: Wanted) -> None:
    fleet, alarms = without_map(lines, wanted)
    assert fleet + alarms == lines
    assert alarms >= 2
    assert fleet == min(wanted.fleet, lines - alarms)
