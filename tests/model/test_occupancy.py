"""Cells of a ROS map become classes, and no wall is lost on the way up the pyramid."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.grid import MAX_PIXELS
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, build_grid, grid_from_ros
from fleet_tui.text.errors import MapError

SIZES = st.tuples(st.integers(1, 40), st.integers(1, 40))


def as_bytes(cells: list[int]) -> bytes:
    return bytes(cell & 0xFF for cell in cells)


@given(SIZES, st.integers(0, 2**16))
def test_every_entry_is_the_maximum_of_the_cells_it_covers(size: tuple[int, int], seed: int) -> None:
    height, width = size
    cells = np.random.default_rng(seed).integers(0, 3, size, dtype=np.uint8)
    grid = build_grid(MapFrame(0.05, width, height), cells)
    for level, entries in enumerate(grid.levels):
        side = 2**level
        assert entries.shape == (-(-height // side), -(-width // side))
        for (row, column), entry in np.ndenumerate(entries):
            covered = cells[row * side : (row + 1) * side, column * side : (column + 1) * side]
            assert entry == covered.max()
    assert grid.levels[-1].shape == (1, 1)


@given(SIZES, st.data())
def test_a_wall_of_one_cell_stands_in_every_level(size: tuple[int, int], data: st.DataObject) -> None:
    height, width = size
    row, column = data.draw(st.integers(0, height - 1)), data.draw(st.integers(0, width - 1))
    cells = np.full(size, FREE, np.uint8)
    cells[row, column] = OCCUPIED
    for level, entries in enumerate(build_grid(MapFrame(0.05, width, height), cells).levels):
        assert entries[row >> level, column >> level] == OCCUPIED
        assert np.count_nonzero(entries == OCCUPIED) == 1


@pytest.mark.parametrize(
    ("cell", "found"),
    [
        *((cell, UNKNOWN) for cell in (-128, -2, -1, 26, 50, 64, 101, 127)),
        *((cell, FREE) for cell in (0, 1, 25)),
        *((cell, OCCUPIED) for cell in (65, 99, 100)),
    ],
)
def test_occupancy_to_class(cell: int, found: int) -> None:
    assert grid_from_ros(MapFrame(1.0, 1, 1), as_bytes([cell])).levels[0].tolist() == [[found]]


def test_the_first_cell_of_the_message_is_the_lower_left_one() -> None:
    grid = grid_from_ros(MapFrame(1.0, 3, 2), as_bytes([100, 0, -1, 0, 0, 0]))
    assert grid.levels[0].tolist() == [[FREE, FREE, FREE], [OCCUPIED, FREE, UNKNOWN]]


@pytest.mark.parametrize("cells", [0, 5, 7])
def test_a_map_that_lies_about_its_size_is_refused(cells: int) -> None:
    with pytest.raises(MapError, match=r"3 x 2 px has \d cells"):
        grid_from_ros(MapFrame(1.0, 3, 2), bytes(cells))


@pytest.mark.parametrize(
    ("frame", "says"),
    [
        (MapFrame(0.0, 1, 1), "resolution"),
        (MapFrame(-1.0, 1, 1), "resolution"),
        (MapFrame(float("nan"), 1, 1), "resolution"),
        (MapFrame(1.0, 0, 1), "size"),
        (MapFrame(1.0, 1, -1), "size"),
        (MapFrame(1.0, -1, -1), "size"),
        (MapFrame(1.0, MAX_PIXELS, 2), "exceeds"),
        (MapFrame(1.0, 10**30, 10**30), "exceeds"),
    ],
)
def test_impossible_maps_are_refused_before_any_memory_is_taken(frame: MapFrame, says: str) -> None:
    with pytest.raises(MapError, match=says):
        grid_from_ros(frame, b"\0")
