"""Tags and labels find what room there is, and two of them never read as one."""

from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.labels import LONGEST, Room
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.picture import backdrop, picture
from fleet_tui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.view.roles import StyleRole

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


@given(st.sets(places, max_size=WIDTH * HEIGHT), places, st.integers(1, 2), st.integers(1, 4))
def test_a_tag_touches_something_only_where_no_place_around_touches_nothing(
    taken: set[tuple[int, int]], at: tuple[int, int], glyph: int, cells: int
) -> None:
    room = Room(WIDTH, HEIGHT)
    for x, y in taken:
        room.take(x, y, 1)
    (x, y), around = at, (at[0] + glyph, at[0], at[0] + 1 - cells, at[0] - cells)
    room.take(x, y, glyph)
    alone = {
        (left, row)
        for row in range(y - 3, y + 4)
        for left in around
        if row != y and room.free(left - 1, row, cells + 2)
    }
    beside = room.free(x + glyph, y, cells + 1)
    spot = room.tag_spot(x, y, glyph, cells)
    if beside:
        assert spot == (x + glyph, y)
    elif spot is not None and spot[1] != y and (spot[0] in around) and alone:
        assert spot in alone


def test_a_tag_longer_than_any_place_finds_none() -> None:
    room = Room(4 * LONGEST, HEIGHT)
    assert room.tag_spot(2, 4, 1, LONGEST) == (3, 4)
    assert room.tag_spot(2, 6, 1, LONGEST + 1) is None


def test_the_start_of_a_row_is_not_beside_the_end_of_another() -> None:
    room = Room(WIDTH, HEIGHT)
    for y in range(HEIGHT):
        room.take(4, y, WIDTH - 4)
    assert room.tag_spot(WIDTH - 1, 4, 1, 2) is None
    assert room.free(0, 4, 4)


@given(st.sets(places, max_size=WIDTH * HEIGHT), places)
def test_a_tag_covers_a_label_only_where_nothing_else_is_free(
    texts: set[tuple[int, int]], at: tuple[int, int]
) -> None:
    below = np.full((HEIGHT, WIDTH), StyleRole.FLOOR, np.uint8)
    for x, y in texts:
        below[y, x] = StyleRole.LABEL
    room, before = Room(WIDTH, HEIGHT, below), Room(WIDTH, HEIGHT, below)
    for one in (room, before):
        one.take(*at, 1)
    spot = room.tag_spot(*at, 1, 2)
    assert spot is not None
    if {spot, (spot[0] + 1, spot[1])} & texts:
        near = [(x, y) for x in range(at[0] - 2, at[0] + 2) for y in range(at[1] - 3, at[1] + 4)]
        assert not any(before.free(*place, 2) for place in near)


def test_a_label_at_the_rim_ends_above_its_vertex_not_beside_the_neighbours() -> None:
    room, ground = Room(WIDTH, HEIGHT), np.full((HEIGHT, WIDTH), StyleRole.FLOOR, np.uint8)
    for x in (WIDTH - 6, WIDTH - 2):
        room.take(x, 4, 1)
    assert room.label_spot(WIDTH - 2, 4, "Consumidores", ground) == (WIDTH - 13, 3)


def test_where_all_is_labels_a_number_covers_one() -> None:
    assert Room(WIDTH, HEIGHT, np.full((HEIGHT, WIDTH), StyleRole.LABEL, np.uint8)).tag_spot(9, 4, 1, 2)


FRAME = MapFrame(0.05, 400, 200)
CAMERA = Camera.fit((400, 200), 120, 40)
EMPTY = Scene("f", FRAME)
ROLES = st.sampled_from(Role)
near_middle = st.tuples(st.floats(9.7, 10.3), st.floats(4.8, 5.2), ROLES)


def names(scene: Scene, camera: Camera) -> set[int]:
    """The ids of the vertices whose labels stand; a label is its vertex' id."""
    cells = backdrop(scene, camera, MapOptions(pointed="1"))
    texts = np.where(np.isin(cells.inks, (StyleRole.LABEL, StyleRole.TARGET)), cells.codes, ord(" "))
    return {int(word) - 10**9 for row in texts for word in "".join(map(chr, row)).split() if word.isdigit()}


def crowd(at: list[tuple[float, float, Role]]) -> Scene:
    vertices = tuple(SceneVertex(str(n), x, y, role, str(10**9 + n)) for n, (x, y, role) in enumerate(at))
    return replace(EMPTY, vertices=vertices, target_vertices=("0",))


def silent(scene: Scene, which: set[int]) -> Scene:
    """Some vertices without their labels; they stay marks that labels keep clear of."""
    vertices = (replace(v, label="", role=Role.DOCKING) if int(v.id) in which else v for v in scene.vertices)
    return replace(scene, vertices=tuple(vertices))


def importance(scene: Scene, n: int) -> tuple[bool, bool, bool, int]:
    return n != 0, n != 1, scene.vertices[n].role is Role.PLAIN, n


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


def test_a_number_rather_touches_a_label_than_that_it_goes_far_from_its_robot() -> None:
    below = np.full((HEIGHT, WIDTH), StyleRole.FLOOR, np.uint8)
    below[4, :9] = below[4, 11:] = StyleRole.LABEL
    assert Room(WIDTH, HEIGHT, below).tag_spot(9, 4, 1, 1) == (10, 4)


def taken_cells(room: Room) -> set[tuple[int, int]]:
    return {(x, y) for y in range(HEIGHT) for x in range(WIDTH) if not room.free(x, y, 1)}


@given(
    st.sets(places, max_size=WIDTH * HEIGHT // 2),
    places,
    st.integers(1, 2),
    st.integers(1, 4),
    st.integers(-6, 6),
    st.integers(-3, 3),
)
def test_a_tag_stays_only_where_it_covers_and_touches_nothing(
    others: set[tuple[int, int]], at: tuple[int, int], glyph: int, cells: int, dx: int, dy: int
) -> None:
    room = Room(WIDTH, HEIGHT)
    (x, y), own = at, {(at[0] + n, at[1]) for n in range(glyph)}
    for place in others - own:
        room.take(*place, 1)
    for place in own:
        room.take(*place, 1)
    before = taken_cells(room)
    stays = room.keep_tag(x, y, glyph, cells, dx, dy)
    tag = {(x + dx + n, y + dy) for n in range(cells)}
    if stays:
        ends = {(x + dx - 1, y + dy), (x + dx + cells, y + dy)}
        assert not tag & before
        assert not (ends - own) & before
        assert taken_cells(room) == before | tag
    else:
        assert taken_cells(room) == before


def test_a_number_stays_beside_its_robot_while_there_is_room_though_a_better_place_came_free() -> None:
    near, far = SceneRobot("r", 1, Pose(10.0, 5.0)), SceneRobot("s", 2, Pose(10.15, 5.0))
    crowded, alone = replace(EMPTY, robots=(near, far)), replace(EMPTY, robots=(far,))
    camera, tags = CAMERA.zoomed(1.0, (200, 100)), dict[int, tuple[int, int]]()

    def drawn(scene: Scene, remembered: dict[int, tuple[int, int]]) -> str:
        return picture(backdrop(scene, camera, MapOptions()), scene, camera, MapOptions(), remembered).text()

    drawn(crowded, tags)
    stood = tags[2]
    assert drawn(alone, tags) != drawn(alone, {})  # beside it there would be room now
    assert tags[2] == stood
