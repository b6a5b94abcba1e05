"""Cells and pixels there and back, limits, and what stays where it is."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.camera import FILLED, MIN_SCALE, SMALL, Camera, scale_bar, seen_area

sizes = st.tuples(st.integers(1, 5000), st.integers(1, 5000))
cameras = st.builds(
    lambda extent, width, height, zoom, x, y: (
        Camera.fit(extent, width, height).zoomed(zoom).centred(x * extent[0], y * extent[1])
    ),
    sizes,
    st.integers(1, 300),
    st.integers(1, 100),
    st.floats(0.01, 1000.0),
    st.floats(0, 1),
    st.floats(0, 1),
)


@given(cameras, st.integers(-50, 350), st.integers(-50, 150))
def test_the_middle_of_a_cell_is_in_that_cell(camera: Camera, x: int, y: int) -> None:
    assert camera.to_cell(*camera.to_pixel(x, y)) == (x, y)


@given(sizes, st.integers(3, 300), st.integers(2, 100))
def test_fit_shows_the_whole_map(extent: tuple[int, int], width: int, height: int) -> None:
    camera = Camera.fit(extent, width, height)
    assert camera.shows(*camera.to_cell(0, 0))
    assert camera.shows(*camera.to_cell(extent[0] - 1e-6, extent[1] - 1e-6))


@given(
    st.tuples(st.floats(-300.0, 2000.0), st.floats(-300.0, 2000.0)),
    st.tuples(st.floats(20.0, 3000.0), st.floats(20.0, 3000.0)),
    st.integers(5, 60),
    st.integers(4, SMALL // 60 - 1),
)
def test_a_small_view_shows_the_whole_area_and_keeps_most_of_its_shape(
    corner: tuple[float, float], size: tuple[float, float], width: int, height: int
) -> None:
    (left, top), (across, down) = corner, size
    camera = Camera.fit((5000, 5000), width, height, (left, top, left + across, top + down))
    assert camera.shows(*camera.to_cell(left + 1e-5, top + 1e-5))
    assert camera.shows(*camera.to_cell(left + across - 1e-5, top + down - 1e-5))
    assert 1 / FILLED - 1e-6 <= camera.tall <= FILLED + 1e-6


def test_a_small_view_is_filled() -> None:
    """Of a floor whose shape is nearly that of the view."""
    camera = Camera.fit((600, 480), 40, 15)
    # Half a dot at the end is for walls that are drawn later.
    spans = camera.width * camera.cell[0], camera.height * camera.cell[1]
    assert spans == pytest.approx((600 * (1 + 1 / 160), 480 * (1 + 1 / 120)))
    assert Camera.fit((600, 480), 80, 30).tall == 1.0, "a large one shows its shape"


@given(cameras, st.lists(st.tuples(st.integers(-999, 999), st.integers(-999, 999)), max_size=5))
def test_the_map_cannot_be_lost(camera: Camera, pans: list[tuple[int, int]]) -> None:
    for pan in pans:
        camera = camera.panned(*pan)
    assert 0 <= camera.column <= camera.extent[0]
    assert 0 <= camera.row <= camera.extent[1]


@given(cameras, st.lists(st.floats(0.01, 100), min_size=1, max_size=5))
def test_zoom_has_limits(camera: Camera, factors: list[float]) -> None:
    for factor in factors:
        camera = camera.zoomed(factor)
    fit = Camera.fit(camera.extent, camera.width, camera.height).scale
    assert MIN_SCALE <= camera.scale <= 2 * fit


def test_zooming_in_and_out_again_changes_nothing() -> None:
    camera = Camera.fit((1000, 800), 100, 40)
    back = camera.zoomed(2.0, (300, 200)).zoomed(0.5, (300, 200))
    assert (back.column, back.row, back.scale) == pytest.approx((camera.column, camera.row, camera.scale))


@given(cameras, st.floats(0.5, 2.0), st.floats(0.2, 0.8), st.floats(0.2, 0.8))
def test_the_point_zoomed_about_stays_within_a_cell(
    camera: Camera, factor: float, across: float, down: float
) -> None:
    point = camera.to_pixel(int(across * camera.width), int(down * camera.height))
    nearer = camera.zoomed(factor, point)
    if 0 < nearer.column < nearer.extent[0] and 0 < nearer.row < nearer.extent[1]:
        before, after = camera.to_cell(*point), nearer.to_cell(*point)
        assert abs(before[0] - after[0]) <= 1
        assert abs(before[1] - after[1]) <= 1


def test_resizing_keeps_the_centre() -> None:
    camera = Camera.fit((1000, 800), 100, 40).zoomed(4, (100, 100)).resized(61, 17)
    assert camera.to_cell(camera.column, camera.row) in {(30, 8), (31, 8), (30, 9), (31, 9)}


def test_following_stands_still_in_the_dead_zone_and_centres_outside() -> None:
    camera, area = Camera.fit((1000, 1000), 100, 50).zoomed(8), (0.0, 0.0, 1000.0, 1000.0)
    assert camera.followed(*camera.to_pixel(60, 20), area) == camera
    point = camera.to_pixel(90, 25)
    assert camera.followed(*point, area).to_cell(*point) in {(50, 25), (49, 25), (50, 24), (49, 24)}


def test_following_along_the_floors_edge_rarely_moves_the_view() -> None:
    camera, area = Camera.fit((1000, 1000), 100, 50).zoomed(8), (0.0, 0.0, 1000.0, 1000.0)
    places = [camera := camera.followed(2.0, row, area) for row in range(0, 1000, 10)]
    assert len({(place.column, place.row) for place in places}) < 30


@given(cameras, st.floats(-100, 1100), st.floats(-100, 1100))
def test_a_view_that_is_centred_shows_nothing_beyond_the_area_that_fits(
    camera: Camera, column: float, row: float
) -> None:
    columns, rows = camera.extent
    moved = camera.centred_within(column, row, (0.0, 0.0, columns, rows))
    for at, view, end in (
        (moved.column, camera.width * camera.cell[0], columns),
        (moved.row, camera.height * camera.cell[1], rows),
    ):
        if view < end:
            assert view / 2 - 1e-6 <= at <= end - view / 2 + 1e-6
        else:
            assert at == pytest.approx(end / 2)


def test_another_frame_keeps_the_place_in_metres() -> None:
    old = MapFrame(0.05, 1000, 800, Pose(-3.0, 4.0, 0.3))
    new = MapFrame(0.1, 700, 600, Pose(-8.0, 1.0, 0.0))
    camera = Camera.fit((1000, 800), 100, 40).zoomed(3).centred(300, 400)
    moved = camera.reframed(old, new)
    assert new.to_world(moved.column, moved.row) == pytest.approx(old.to_world(300, 400))
    assert moved.scale * new.resolution == pytest.approx(camera.scale * old.resolution)


@given(cameras, st.floats(0.001, 2.0), st.integers(2, 60))
def test_the_scale_bar_is_round_and_fits(camera: Camera, resolution: float, width: int) -> None:
    text, cells = scale_bar(camera, MapFrame(resolution, *camera.extent), width)
    number, unit = text.split()
    metres = float(number) * {"m": 1, "km": 1000}[unit]
    leading = metres / 10 ** math.floor(math.log10(metres) + 1e-9)
    assert round(leading, 6) in (1, 2, 5, 10)
    assert 1 <= cells <= width


@given(cameras, st.floats(0.01, 1.0), st.floats(-3.0, 3.0))
def test_every_cell_of_the_view_is_in_the_seen_area(camera: Camera, resolution: float, yaw: float) -> None:
    frame = MapFrame(resolution, *camera.extent, Pose(3.0, -4.0, yaw))
    area = seen_area(camera, frame)
    for x, y in (
        (0, 0),
        (camera.width - 1, 0),
        (0, camera.height - 1),
        (camera.width - 1, camera.height - 1),
    ):
        assert area.shows(*frame.to_world(*camera.to_pixel(x, y))) or min(camera.width, camera.height) < 4
    one, other = camera.to_pixel(0, 0), camera.to_pixel(1, 0)
    assert area.cell == pytest.approx(math.dist(frame.to_world(*one), frame.to_world(*other)))


def test_a_view_that_becomes_large_shows_the_shape_as_it_is() -> None:
    small = Camera.fit((600, 480), 40, 18).zoomed(2.0)
    assert small.tall > 1.0
    assert small.resized(39, 18).tall == small.tall and small.resized(100, 45).tall == 1.0
