"""Tags and labels use only free cells, and two of them never read as one."""

from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.picture import backdrop, picture
from fleet_tui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.view.roles import StyleRole

WIDTH, HEIGHT = 24, 9
places = st.tuples(st.integers(0, WIDTH - 1), st.integers(0, HEIGHT - 1))


taken_places = st.sets(places, max_size=WIDTH * HEIGHT // 3)


def taken_cells(occupancy: CellOccupancy) -> set[tuple[int, int]]:
    return {(x, y) for y in range(HEIGHT) for x in range(WIDTH) if not occupancy.free(x, y, 1)}


@given(taken_places, places, st.integers(1, 2), st.integers(1, 4), st.sampled_from((-1, 0, 1)))
def test_a_number_is_beside_its_arrow_and_touches_nothing_else(
    others: set[tuple[int, int]], at: tuple[int, int], arrow: int, cells: int, before: int
) -> None:
    occupancy, (x, y) = CellOccupancy(WIDTH, HEIGHT), at
    own = {(x + n, y) for n in range(arrow)} & {(n, y) for n in range(WIDTH)}
    for place in others | own:
        occupancy.take(*place, 1)
    blocked = taken_cells(occupancy)
    side = occupancy.number_side(x, y, arrow, cells, before)

    def number(which: int) -> set[tuple[int, int]]:
        start = x - cells if which < 0 else x + arrow
        return {(start + n, y) for n in range(cells)}

    def fits(which: int, distance: int = 1) -> bool:
        cells_of_it = number(which)
        beyond = (min(cells_of_it)[0] - distance if which < 0 else max(cells_of_it)[0] + distance, y)
        inside = all(0 <= column < WIDTH for column, _ in cells_of_it)
        return inside and not (cells_of_it | {beyond}) & blocked

    stays = before != 0 and fits(before, 0)
    assert bool(side) == (stays or fits(-1) or fits(1))
    if side:
        assert stays or fits(side)
        assert taken_cells(occupancy) == blocked | number(side)
    if stays:
        assert side == before, "beside the arrow of another robot, if need be"


@given(taken_places, places)
def test_a_number_covers_a_label_only_where_both_sides_do(
    texts: set[tuple[int, int]], at: tuple[int, int]
) -> None:
    below = np.full((HEIGHT, WIDTH), StyleRole.FLOOR, np.uint8)
    for x, y in texts:
        below[y, x] = StyleRole.LABEL
    occupancy, (x, y) = CellOccupancy(WIDTH, HEIGHT, below), at
    occupancy.take(x, y, 1)
    free = [occupancy.free(start, y, 2) for start in (x - 2, x + 1)]
    side = occupancy.number_side(x, y, 1, 2, 0)
    assert side
    assert free[side > 0] or not any(free)


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
def test_only_a_wanted_label_covers_a_wall(
    walls: set[tuple[int, int]], at: tuple[int, int], covers_walls: bool
) -> None:
    roles = ground()
    for x, y in walls:
        roles[y, x] = StyleRole.WALL
    spot = CellOccupancy(WIDTH, HEIGHT).label_spot(*at, "Base", roles, covers_walls=covers_walls)
    assert spot or not covers_walls
    free = CellOccupancy(WIDTH, HEIGHT).label_spot(*at, "Base", roles)
    if spot and (free or not covers_walls):
        assert spot == free and (roles[spot[1], spot[0] : spot[0] + 4] == StyleRole.FLOOR).all()


def test_a_label_without_space_at_its_vertex_is_behind_the_wall_around_the_floor() -> None:
    roles = ground(slice(2, 3), slice(4, 5))
    roles[3] = StyleRole.EDGE
    roles[:2] = StyleRole.UNKNOWN
    assert CellOccupancy(WIDTH, HEIGHT).label_spot(10, 3, "Base", roles) == (10, 1)


def test_a_label_in_another_aisle_would_be_read_as_of_another_vertex() -> None:
    roles = ground(slice(3, 6))
    assert CellOccupancy(WIDTH, HEIGHT).label_spot(10, 4, "Base", roles) is None
    roles[3, 10] = StyleRole.FLOOR
    assert CellOccupancy(WIDTH, HEIGHT).label_spot(10, 4, "Base", roles) == (10, 2), "nothing between"


def test_a_number_is_on_the_side_without_a_wall() -> None:
    roles = ground()
    roles[:, 9] = StyleRole.WALL
    for before in (-1, 0, 1):
        assert CellOccupancy(WIDTH, HEIGHT, roles).number_side(10, 4, 1, 2, before) == 1, "not on the wall"
    roles[:, 12] = StyleRole.WALL
    for before in (-1, 1):
        assert CellOccupancy(WIDTH, HEIGHT, roles).number_side(10, 4, 1, 2, before) == before, "it stays"


FRAME = MapFrame(0.05, 400, 200)
CAMERA = Camera.fit((400, 200), 120, 40)
EMPTY = Scene("f", FRAME)
ROLES = st.sampled_from(Role)
near_middle = st.tuples(st.floats(9.7, 10.3), st.floats(4.8, 5.2), ROLES)


def names(scene: Scene, camera: Camera) -> set[int]:
    """The ids of the vertices whose labels stand; a label is its vertex' id."""
    cells = backdrop(scene, camera, MapOptions())
    texts = np.where(
        np.isin(
            cells.roles, (StyleRole.LABEL, StyleRole.TARGET, StyleRole.LABEL_BEYOND, StyleRole.TARGET_BEYOND)
        ),
        cells.codes,
        ord(" "),
    )
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
        assert "1→ Dock" in picture(backdrop(alone, camera, MapOptions()), alone, camera, MapOptions()).text()


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


@given(taken_places, places, st.integers(1, 3))
def test_a_number_in_place_of_an_arrow_touches_nothing(
    taken: set[tuple[int, int]], at: tuple[int, int], cells: int
) -> None:
    occupancy = CellOccupancy(WIDTH, HEIGHT)
    for x, y in taken | {at}:
        occupancy.take(x, y, 1)
    start = occupancy.number_over(*at, cells)
    x, y = at
    spots = {s: {(n, y) for n in range(s - 1, s + cells + 1)} - {at} for s in (x - cells + 1, x)}
    fitting = [s for s, near in spots.items() if not near & taken and s >= 0 and s + cells <= WIDTH]
    assert (start in fitting) if fitting else start is None
    if start is not None:
        assert not any(occupancy.free(n, y, 1) for n in range(start, start + cells))
