"""No wall is lost, in any mode, at any zoom or offset; and what the ground looks like."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, build_grid
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.ground.raster import COARSE, ground, sample
from fleet_tui.ui.view.roles import WALLS, StyleRole


def grid_of(classes: np.ndarray) -> OccupancyGrid:
    height, width = classes.shape
    return build_grid(MapFrame(0.05, width, height), classes.astype(np.uint8))


def exact(classes: np.ndarray, scale: float, left: int, top: int, shape: tuple[int, int]) -> np.ndarray:
    """The definition, in plain Python: the maximum of the pixels each dot covers."""
    found = np.zeros(shape, np.uint8)
    depth = max(math.floor(math.log2(scale)) - 1, 0)
    step = scale / 2**depth
    for y in range(shape[0]):
        for x in range(shape[1]):
            spans = []
            for dot, size in ((top + y, classes.shape[0]), (left + x, classes.shape[1])):
                first = math.floor(dot * step)
                last = max(math.floor((dot + 1) * step) - 1, first)
                spans.append((max(first << depth, 0), max(min((last + 1) << depth, size), 0)))
            block = classes[spans[0][0] : spans[0][1], spans[1][0] : spans[1][1]]
            if block.size:
                found[y, x] = block.max()
    return found


@given(
    side=st.integers(3, 40),
    scale=st.floats(0.13, 20.0),
    left=st.integers(-30, 60),
    top=st.integers(-30, 60),
    seed=st.integers(0, 99),
)
def test_a_dot_is_the_maximum_of_exactly_the_pixels_it_covers(
    side: int, scale: float, left: int, top: int, seed: int
) -> None:
    classes = np.random.default_rng(seed).choice([0, 0, 1, 1, 1, 2], (side, side + 3)).astype(np.uint8)
    shape = (16, 12)
    dots = sample(grid_of(classes), (scale, scale), left, top, shape)
    depth = max(math.floor(math.log2(scale)) - 1, 0)
    if depth < len(grid_of(classes).levels):
        assert np.array_equal(dots, exact(classes, scale, left, top, shape))


@given(
    side=st.integers(30, 300),
    place=st.floats(0.0, 0.999),
    zoom=st.floats(-1.0, 5.0),
    pan=st.integers(-5, 5),
    upright=st.booleans(),
)
def test_no_thin_wall_is_lost(side: int, place: float, zoom: float, pan: int, upright: bool) -> None:
    """Nor is there a gap in it: only its ends are up to half a block shorter. 3,000 cases: 1,000 maps, each
    in three modes."""
    at = int(place * side)
    classes = np.full((side, side), FREE, np.uint8)
    classes[:, at] = OCCUPIED
    if not upright:
        classes = classes.T
    centre = (at + 0.5, side / 2)
    column, row = centre if upright else centre[::-1]
    fit = Camera.fit((side, side), 24, 12)
    camera = fit.zoomed(2**zoom, (column, row)).centred(column, row).panned(pan, pan)
    for drawing in Drawing:
        roles = ground(grid_of(classes), camera, drawing).roles
        if not upright:
            roles = roles.T
        walls = np.isin(roles, WALLS)
        inside = (walls | (roles == StyleRole.FLOOR)).any(axis=1)
        assert inside.any()
        drawn = np.flatnonzero(walls.any(axis=1))
        assert np.array_equal(drawn, np.arange(drawn[0], drawn[-1] + 1))
        ends = np.flatnonzero(inside)
        assert drawn[0] - ends[0] <= 1 and ends[-1] - drawn[-1] <= 1


def test_a_coarse_view_keeps_the_edges_of_a_solid_block_and_thins_its_inside() -> None:
    classes = np.full((1600, 1600), FREE, np.uint8)
    classes[400:1200, 400:1200] = OCCUPIED
    camera = Camera.fit((1600, 1600), 40, 20)
    assert camera.scale > COARSE
    fine = ground(grid_of(classes), camera.zoomed(4), Drawing.BRAILLE).text()
    assert set(fine) <= set(" \n▘▝▀▖▌▞▛▗▚▐▜▄▙▟█")
    for drawing in (Drawing.BRAILLE, Drawing.HALF_BLOCK):
        blocks = ground(grid_of(classes), camera, drawing).text()
        assert blocks.count("▓") > 20
        assert sum(blocks.count(edge) for edge in "█▌▐▀▄") > 10


def test_where_all_is_wall_when_seen_from_afar_the_dense_parts_look_denser() -> None:
    classes = np.full((1600, 1600), FREE, np.uint8)
    classes[:, 1::7] = OCCUPIED
    classes[:, 800:] = OCCUPIED
    classes[:, 801::7] = FREE
    camera = Camera.fit((1600, 1600), 40, 20)
    middle = [
        ground(grid_of(classes), camera, drawing).text().split("\n")[10]
        for drawing in (Drawing.BRAILLE, Drawing.HALF_BLOCK)
    ]
    for row in middle:
        assert row[5:18].count("▒") > 6
        assert set(row[22:35]) == {"▓"}


@given(
    seed=st.integers(0, 999),
    share=st.floats(0.0, 0.05),
    thick=st.integers(1, 30),
    scale=st.floats(0.2, 40.0),
    ways=st.integers(0, 3),
)
def test_each_wall_is_drawn_in_its_quadrant_or_one_that_touches_it(
    seed: int, share: float, thick: int, scale: float, ways: int
) -> None:
    """And no quadrant without a wall is drawn as one."""
    rng = np.random.default_rng(seed)
    some = np.where(rng.random((900 // thick + 1, 900 // thick + 1)) < share, OCCUPIED, FREE)
    grid = grid_of(np.kron(some, np.ones((thick, thick), np.uint8))[:900, :900])
    camera = Camera(450.0, 450.0, scale, 12, 6, (900, 900))
    left, top = camera.origin
    parts = sample(grid, (scale, scale), left * 2, top * 4, (24, 24), 2) == OCCUPIED
    walls = np.logical_or.reduce([parts[y::2, x::2] for y in (0, 1) for x in (0, 1)])
    lines = (rng.random((ways, 2)) * 900, rng.random((ways, 2)) * 900)
    cells = ground(grid, camera, Drawing.BRAILLE, ways=lines)
    drawn = np.zeros_like(walls)
    for place, having in enumerate(("▘▀▌▛▚▜▙█▒▓", "▝▀▐▞▛▜▟█▒▓", "▖▌▄▞▛▙▟█▒▓", "▗▐▄▚▜▙▟█▒▓")):
        drawn[place // 2 :: 2, place % 2 :: 2] = np.isin(cells.codes, [ord(letter) for letter in having])
    assert not (drawn & ~walls).any()
    padded = np.pad(drawn, 1)
    near = np.logical_or.reduce([padded[y : y + 12, x : x + 24] for y in range(3) for x in range(3)])
    assert not (walls & ~near)[1:-1, 1:-1].any()


@pytest.mark.parametrize("drawing", list(Drawing))
@given(place=st.floats(80.0, 120.0), upright=st.booleans())
def test_a_passage_between_walls_stays_open(drawing: Drawing, place: float, upright: bool) -> None:
    """At any offset, from a block's width and a half on."""
    block = {Drawing.BRAILLE: (20, 10), Drawing.HALF_BLOCK: (20, 20), Drawing.ASCII: (40, 20)}[drawing]
    classes = np.full((200, 200), OCCUPIED)
    start = int(place)
    classes[:, start : start + block[upright] * 3 // 2] = FREE
    grid = grid_of(classes if upright else classes.T)
    cells = ground(grid, Camera(100.0, 100.0, 10.0, 12, 6, (200, 200)), drawing)
    rows = cells.codes[1:5, 2:10] if upright else cells.codes[1:5, 2:10].T
    assert (rows != ord("#" if drawing is Drawing.ASCII else "█")).any(axis=1).all()


def test_a_way_of_robots_stays_open_past_a_wall_in_the_same_cell() -> None:
    classes = np.full((200, 200), FREE)
    classes[:, 60:100] = OCCUPIED
    classes[:, 112:116] = OCCUPIED
    camera = Camera(100.0, 100.0, 10.0, 12, 6, (200, 200))

    def open_rows(*ways: float) -> int:
        ends = [np.array([[column, row] for column in ways]).reshape(-1, 2) for row in (0.0, 200.0)]
        rows = ground(grid_of(classes), camera, Drawing.ASCII, ways=(ends[0], ends[1])).text().split("\n")
        return sum(row[6] == "." for row in rows)

    assert open_rows() == 0
    assert open_rows(105.0) == 5
    assert open_rows(114.0) == 0  # within the wall nothing is opened
    classes[60:100] = OCCUPIED  # a wall across the way is drawn
    assert open_rows(105.0) < 5


@pytest.mark.parametrize(
    ("drawing", "row"), [(Drawing.ASCII, " .#"), (Drawing.HALF_BLOCK, "  █"), (Drawing.BRAILLE, "  █")]
)
def test_unknown_free_and_wall_have_glyphs_of_their_own(drawing: Drawing, row: str) -> None:
    classes = np.repeat(np.repeat([[UNKNOWN, FREE, OCCUPIED]], 4, axis=0), 2, axis=1)
    cells = ground(grid_of(classes), Camera(3.0, 2.0, 1.0, 3, 1, (6, 4)), drawing)
    assert cells.text() == row
    wall = StyleRole.WALL if drawing is Drawing.ASCII else StyleRole.WALL_SOLID  # its blocks leave no gaps
    assert cells.roles[0].tolist() == [StyleRole.UNKNOWN, StyleRole.FLOOR, wall]


def test_ground_beyond_an_outer_wall_is_not_drawn_as_floor() -> None:
    classes = np.full((400, 400), FREE)
    for wide in range(160, 180):
        beyond = np.where(np.arange(400) < wide, classes, UNKNOWN)
        beyond[:, wide - 6 : wide] = OCCUPIED
        cells = ground(grid_of(beyond), Camera(200.0, 200.0, 10.0, 12, 6, (400, 400)), Drawing.BRAILLE)
        last = np.flatnonzero(cells.codes[2] != ord(" "))[-1]
        assert (cells.roles[2, last + 1 :] == StyleRole.UNKNOWN).all()
        assert chr(cells.codes[2, last]) != "▌" or cells.roles[2, last] == StyleRole.WALL_BEYOND


def test_unknown_ground_is_marked_sparsely_where_colours_do_not_show_it() -> None:
    grid = grid_of(np.full((64, 64), UNKNOWN))
    camera = Camera(32.0, 32.0, 1.0, 32, 16, (64, 64))
    assert not ground(grid, camera, Drawing.BRAILLE).text().split()
    marks = ground(grid, camera, Drawing.BRAILLE, hatched=True)
    assert marks.text().count("·") == 32 * 16 // 8
    moved = ground(grid, camera.panned(3, 1), Drawing.BRAILLE, hatched=True)
    assert np.array_equal(marks.codes[1:, 3:], moved.codes[:-1, :-3])  # the marks move with the map


@pytest.mark.parametrize("drawing", list(Drawing))
@pytest.mark.parametrize("side", [200, 2000])
def test_panning_by_a_cell_moves_every_cell_and_changes_none(drawing: Drawing, side: int) -> None:
    classes = np.random.default_rng(3).choice([0, 1, 1, 2], (side, side))
    camera = Camera.fit((side, side), 40, 20).zoomed(1.7).centred(side / 2, side / 2)
    before, after = (ground(grid_of(classes), c, drawing) for c in (camera, camera.panned(3, -2)))
    assert np.array_equal(before.codes[:-2, 3:], after.codes[2:, :-3])
    assert np.array_equal(before.roles[:-2, 3:], after.roles[2:, :-3])


def test_without_a_map_the_extent_is_empty_floor() -> None:
    cells = ground(None, Camera.fit((100, 100), 30, 10), Drawing.BRAILLE)
    assert (cells.roles == StyleRole.FLOOR).sum() > 100
    assert (cells.roles == StyleRole.WALL).sum() == 0
    assert cells.roles[5, 0] == StyleRole.UNKNOWN
