"""Tags and labels find what room there is, and two of them never read as one."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.view.labels import Room

WIDTH, HEIGHT = 24, 9
places = st.tuples(st.integers(0, WIDTH - 1), st.integers(0, HEIGHT - 1))


@given(st.sets(places, max_size=WIDTH * HEIGHT), places)
def test_a_tag_goes_to_free_cells_wherever_some_are_near(
    taken: set[tuple[int, int]], at: tuple[int, int]
) -> None:
    room = Room(WIDTH, HEIGHT)
    for x, y in taken | {at}:
        room.take(x, y, 1)
    near = [
        (x, y) for x in range(at[0] - 4, at[0] + 4) for y in range(at[1] - 3, at[1] + 4) if room.free(x, y, 2)
    ]
    spot = room.tag_spot(*at, 1, 2)
    if spot is None:
        beside = [(x, y) for x, y in near if x in (at[0] - 2, at[0] - 1, at[0], at[0] + 1)]
        assert beside == []
    else:
        assert not {(spot[0], spot[1]), (spot[0] + 1, spot[1])} & (taken | {at})
        assert not room.free(*spot, 2)


def test_tags_of_robots_in_one_cell_do_not_touch_each_other() -> None:
    room = Room(WIDTH, HEIGHT)
    room.take(12, 4, 1)
    spots = [room.tag_spot(12, 4, 1, 2) for _ in range(12)]
    cells: set[tuple[int, int]] = set()
    for spot in spots:
        assert spot is not None
        x, y = spot
        assert not {(x + beside, y) for beside in (-1, 0, 1, 2)} & cells
        cells |= {(x, y), (x + 1, y)}
