"""Tags and labels use only free cells, and two of them never read as one."""

from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.placing.chips import ChipSize
from fleet_tui.ui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.roles import LABELS, StyleRole

WIDTH, HEIGHT = 24, 9
places = st.tuples(st.integers(0, WIDTH - 1), st.integers(0, HEIGHT - 1))


taken_places = st.sets(places, max_size=WIDTH * HEIGHT // 3)


def taken_cells(occupancy: CellOccupancy) -> set[tuple[int, int]]:
    return {(x, y) for y in range(HEIGHT) for x in range(WIDTH) if not occupancy.free(x, y, 1)}


@given(taken_places, places, st.integers(1, 5), st.none() | st.tuples(st.integers(-5, 2), st.integers(-1, 1)))
def test_a_chip_is_at_its_robot_in_the_view_and_touches_no_other(
    others: set[tuple[int, int]], at: tuple[int, int], cells: int, before: tuple[int, int] | None
) -> None:
    occupancy, (x, y) = CellOccupancy(WIDTH, HEIGHT), at
    for place in others:
        occupancy.take(*place, 1)
    blocked = taken_cells(occupancy)
    shift = occupancy.chip_shift(x, y, ChipSize(cells, cells), before)
    fits = [
        right
        for right in range(1 - cells, 1)
        if 0 <= x + right <= WIDTH - cells and not {(x + right + n, y) for n in range(-1, cells + 1)} & others
    ]
    assert shift is not None or not fits
    if shift is None:
        assert taken_cells(occupancy) == blocked
        return
    start, row = x + shift[0], y + shift[1]
    assert taken_cells(occupancy) == blocked | {(start + n, row) for n in range(cells)}
    assert not {(start + n, row) for n in range(-1, cells + 1)} & others
    assert start - 2 <= x <= start + cells + 1 and abs(row - y) <= 1
    if fits and before is None:
        assert shift == (max(fits), 0), "its first cell is the robot's, if it has space there"


@given(places, st.integers(1, 4), st.integers(-3, 0))
def test_a_chip_stays_as_it_is_at_its_robot_while_that_drives(
    at: tuple[int, int], cells: int, right: int
) -> None:
    is_free = 0 <= at[0] + right <= WIDTH - cells and right > -cells
    shift = CellOccupancy(WIDTH, HEIGHT).chip_shift(*at, ChipSize(cells, cells), (right, 0))
    assert not is_free or shift == (right, 0)


def test_a_chip_keeps_off_walls_names_and_most_of_all_the_orders_ends() -> None:
    roles = ground()
    roles[:, 11:13] = StyleRole.WALL
    assert CellOccupancy(WIDTH, HEIGHT, roles).chip_shift(10, 4, ChipSize(3, 3), None) == (-2, 0)
    roles[:, 9] = StyleRole.WALL
    assert CellOccupancy(WIDTH, HEIGHT, roles).chip_shift(10, 4, ChipSize(3, 3), (-1, 0)) == (-1, 0), (
        "it stays"
    )
    roles = ground()
    roles[4, 12:16] = StyleRole.LABEL
    assert CellOccupancy(WIDTH, HEIGHT, roles).chip_shift(10, 4, ChipSize(3, 3), None) == (-2, 0), (
        "nor beside one"
    )
    occupancy = CellOccupancy(WIDTH, HEIGHT, ground())
    occupancy.keep_clear(10, 4)
    assert occupancy.chip_shift(10, 4, ChipSize(3, 3), None) == (1, 0)


def test_a_chip_grows_toward_the_inside_of_a_building_and_leaves_its_row_that_way() -> None:
    roles = ground()
    roles[:, :5], roles[:, 5] = StyleRole.UNKNOWN, StyleRole.WALL
    roles[:2], roles[2] = StyleRole.UNKNOWN, StyleRole.WALL
    for before in (None, (-1, 0), (-2, 0)):
        assert CellOccupancy(WIDTH, HEIGHT, roles).chip_shift(6, 4, ChipSize(3, 3), before) == (0, 0)
    roles[4] = StyleRole.WALL
    occupancy = CellOccupancy(WIDTH, HEIGHT, roles)
    occupancy.take(0, 3, WIDTH)
    shift = occupancy.chip_shift(12, 3, ChipSize(3, 3), None)
    assert shift is not None and shift[1] == 1, "over the rack, not over the outer wall"
    roles[2] = StyleRole.LABEL_THROUGH
    occupancy = CellOccupancy(WIDTH, HEIGHT, roles)
    occupancy.take(0, 3, WIDTH)
    shift = occupancy.chip_shift(12, 3, ChipSize(3, 3), None)
    assert shift is not None and shift[1] == 1, "nor over a name on it"


def test_a_long_chip_covers_no_name() -> None:
    roles = ground()
    roles[2:7, 10:14] = StyleRole.LABEL
    assert CellOccupancy(WIDTH, HEIGHT, roles).chip_shift(11, 4, ChipSize(10, 3), None) is None
    assert CellOccupancy(WIDTH, HEIGHT, roles).chip_shift(11, 4, ChipSize(3, 3), None) is not None


def test_a_label_at_the_rim_ends_above_its_vertex_not_beside_the_neighbours() -> None:
    occupancy, ground = CellOccupancy(WIDTH, HEIGHT), np.full((HEIGHT, WIDTH), StyleRole.FLOOR, np.uint8)
    for x in (WIDTH - 6, WIDTH - 2):
        occupancy.take(x, 4, 1)
    assert occupancy.label_spot(WIDTH - 2, 4, "Consumidores", ground) == (WIDTH - 13, 3)


def ground(*walls: slice) -> np.ndarray:
    """Free floor with rows of wall."""
    roles = np.full((HEIGHT, WIDTH), StyleRole.FLOOR, np.uint8)
    for rows in walls:
        roles[rows] = StyleRole.WALL
    return roles


@given(st.sets(places, max_size=WIDTH * HEIGHT), places, st.booleans())
def test_only_a_wanted_label_covers_a_wall_inside_and_finds_a_place_always(
    walls: set[tuple[int, int]], at: tuple[int, int], covers_walls: bool
) -> None:
    roles = ground()
    for x, y in walls:
        roles[y, x] = StyleRole.WALL
    spot = CellOccupancy(WIDTH, HEIGHT).label_spot(*at, "Base", roles, covers_walls=covers_walls)
    assert spot or not covers_walls
    if spot and not covers_walls:
        assert (roles[spot[1], spot[0] : spot[0] + 4] == StyleRole.FLOOR).all()


def test_a_label_is_over_the_outer_wall_inside_its_corners_rather_than_over_an_edge_or_beyond() -> None:
    roles = ground(slice(2, 3), slice(4, 5))
    roles[3], roles[:2], roles[:, :3] = StyleRole.EDGE, StyleRole.UNKNOWN, StyleRole.UNKNOWN
    roles[2:, 3] = StyleRole.WALL
    for at, first in ((10, 8), (4, 4)):
        assert CellOccupancy(WIDTH, HEIGHT).label_spot(at, 3, "Base", roles) == (first, 2)


def test_a_label_without_space_at_its_vertex_is_behind_the_wall_around_the_floor() -> None:
    roles = ground(slice(2, 5))
    roles[3, 10] = StyleRole.EDGE
    roles[:2] = StyleRole.UNKNOWN
    occupancy = CellOccupancy(WIDTH, HEIGHT)
    occupancy.take(0, 2, WIDTH)
    assert occupancy.label_spot(10, 3, "Base", roles) == (10, 1)


def test_a_label_is_rather_over_an_edge_beside_its_vertex_than_where_it_would_name_a_room() -> None:
    roles = ground()
    roles[3] = StyleRole.EDGE
    assert CellOccupancy(WIDTH, HEIGHT).label_spot(10, 3, "Base", roles) == (8, 2), "there is space above"
    roles[2:5:2, 2::5] = StyleRole.WALL
    assert CellOccupancy(WIDTH, HEIGHT).label_spot(10, 3, "Base", roles) == (12, 3)


def test_a_label_in_another_aisle_would_be_read_as_of_another_vertex() -> None:
    roles = ground(slice(3, 6))
    assert CellOccupancy(WIDTH, HEIGHT).label_spot(10, 4, "Base", roles) is None
    roles[3, 10] = StyleRole.FLOOR
    assert CellOccupancy(WIDTH, HEIGHT).label_spot(10, 4, "Base", roles) == (10, 2), "nothing between"


FRAME = MapFrame(0.05, 400, 200)
CAMERA = Camera.fit((400, 200), 120, 40)
EMPTY = Scene("f", FRAME)
ROLES = st.sampled_from(Role)
near_middle = st.tuples(st.floats(9.7, 10.3), st.floats(4.8, 5.2), ROLES)


def names(scene: Scene, camera: Camera) -> set[int]:
    """The ids of the vertices whose labels stand; a label is its vertex' id."""
    cells = backdrop(scene, camera, MapOptions())
    texts = np.where(np.isin(cells.roles, LABELS), cells.codes, ord(" "))
    return {int(word) - 10**9 for row in texts for word in "".join(map(chr, row)).split() if word.isdigit()}


def crowd(at: list[tuple[float, float, Role]]) -> Scene:
    vertices = tuple(SceneVertex(str(n), x, y, role, str(10**9 + n)) for n, (x, y, role) in enumerate(at))
    return replace(EMPTY, vertices=vertices)


def silent(scene: Scene, which: set[int]) -> Scene:
    """Some vertices without their labels; they stay marks that labels keep clear of."""
    vertices = (replace(v, label="", role=Role.DOCKING) if int(v.id) in which else v for v in scene.vertices)
    return replace(scene, vertices=tuple(vertices))


def importance(scene: Scene, n: int) -> tuple[bool, int]:
    return scene.vertices[n].role is Role.PLAIN, n


@settings(deadline=None)
@given(st.lists(near_middle, min_size=6, max_size=12), st.floats(0.5, 4.0), st.floats(1.1, 3.0))
def test_a_label_that_stands_stands_nearer_too_unless_one_before_it_took_its_place(
    at: list[tuple[float, float, Role]], zoom: float, nearer: float
) -> None:
    scene, camera = crowd(at), CAMERA.zoomed(zoom, (200, 100))
    near_camera = camera.zoomed(nearer, (200, 100))
    order = sorted(range(len(at)), key=lambda n: importance(scene, n))
    for lost in names(scene, camera) - names(scene, near_camera):
        if lost in names(silent(scene, {*order} - {lost}), near_camera):  # the vertices leave it room
            assert lost in names(silent(scene, {*order[: order.index(lost)]}), near_camera)


@settings(deadline=None)
@given(st.lists(near_middle, min_size=6, max_size=12), st.floats(0.5, 8.0), st.integers(1, 11))
def test_the_less_important_labels_take_no_place_from_the_others(
    at: list[tuple[float, float, Role]], zoom: float, kept: int
) -> None:
    scene, camera = crowd(at), CAMERA.zoomed(zoom, (200, 100))
    order = sorted(range(len(at)), key=lambda n: importance(scene, n))
    assert names(silent(scene, {*order[kept:]}), camera) == names(scene, camera) & set(order[:kept])


def test_a_robot_at_a_station_leaves_the_stations_name_readable() -> None:
    station = SceneVertex("1", 10.0, 5.0, Role.DOCKING, "Dock")
    robots = (SceneRobot("r", 1, Pose(10.0, 5.0), selected=True), SceneRobot("s", 2, Pose(10.4, 5.6)))
    scene = replace(EMPTY, vertices=(station,), robots=robots)
    for zoom in (0.5, 1.0, 2.0, 4.0):
        camera = CAMERA.zoomed(zoom, (200, 100))
        text = picture(backdrop(scene, camera, MapOptions()), scene, camera, MapOptions()).text()
        assert "Dock" in text
        assert "1" in text
        alone = replace(scene, robots=robots[:1])
        assert "→1 Dock" in picture(backdrop(alone, camera, MapOptions()), alone, camera, MapOptions()).text()


@settings(deadline=None)
@given(st.lists(near_middle, min_size=6, max_size=12), st.floats(0.5, 8.0), st.integers(0, 5))
def test_the_ends_of_an_order_have_a_label_and_move_no_other_that_leaves_them_room(
    at: list[tuple[float, float, Role]], zoom: float, end: int
) -> None:
    scene, camera = crowd(at), CAMERA.zoomed(zoom, (200, 100))
    ordered = replace(scene, target_vertices=(str(end),))
    before = names(scene, camera)
    if end in names(silent(scene, {*range(len(at))} - {end}), camera):  # the vertices leave it room
        assert end in names(ordered, camera)
    if end in before:
        assert names(ordered, camera) == before


def test_a_chip_grows_to_the_side_that_hides_less_and_keeps_a_cell_to_its_neighbours() -> None:
    def widened(*walls: int, taken: int = -1, x: int = 10) -> int | None:
        roles = np.zeros((HEIGHT, WIDTH), np.uint8)
        roles[4, list(walls)] = StyleRole.WALL
        occupancy = CellOccupancy(WIDTH, HEIGHT, roles)
        occupancy.take(x, 4, 2)
        occupancy.take(taken, 4, 1)
        return occupancy.widen(x, 4, 2, 1)

    assert widened() == 10
    assert widened(12) == 9 and widened(9) == 10
    assert widened(taken=13) == 9 and widened(taken=8) == 10
    assert widened(x=0) == 0 and widened(x=WIDTH - 2) == WIDTH - 3
    assert widened(x=WIDTH - 2, taken=WIDTH - 4) is None
