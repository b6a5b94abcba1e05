"""The places of a chip: at its robot, the nearest first."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.ui.view.map.placing.chips import ChipSize, shifts_of


@given(st.integers(1, 6))
def test_a_chip_is_over_its_robot_rather_than_beside_it_and_never_more_than_a_row_off(cells: int) -> None:
    places = shifts_of(ChipSize(cells, cells), far=False)
    costs = list(places.values())
    assert costs == sorted(costs)
    over = [(right, down) for right, down in places if down == 0 and -cells < right <= 0]
    assert list(places)[:cells] == over
    assert {down for _, down in places} == {-1, 0, 1}
    assert {down for _, down in shifts_of(ChipSize(cells, cells), far=True)} == {-2, 2}


@given(st.integers(1, 4), st.integers(1, 20), st.booleans())
def test_a_text_beside_a_number_leaves_that_over_its_robot(head: int, text: int, is_left: bool) -> None:
    for right, down in shifts_of(ChipSize(head + text, head, is_left), far=False):
        first = right + (text if is_left else 0)
        assert down == 0 and first <= 0 < first + head
