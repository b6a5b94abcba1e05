"""Any grid, frame and camera give a picture that fills its canvas, and places there come back."""

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import build_grid
from fleet_tui.text.sanitize import cell_width
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Mission, Scene, SceneRobot, SceneVertex

metres = st.one_of(st.floats(-60, 60), st.sampled_from([math.nan, math.inf, -math.inf, 1e300]))
been = st.tuples(st.floats(-60, 60), st.floats(-60, 60), st.floats(0, 60))
lines = st.tuples(metres, metres, metres, metres)
poses = st.builds(Pose, st.floats(-50, 50), st.floats(-50, 50), st.floats(-7, 7))


@st.composite
def grids(draw: st.DrawFn) -> OccupancyGrid:
    width, height = draw(st.integers(1, 70)), draw(st.integers(1, 70))
    frame = MapFrame(draw(st.floats(0.01, 5.0)), width, height, draw(poses))
    rng = np.random.default_rng(draw(st.integers(0, 99)))
    return build_grid(frame, rng.integers(0, 3, (height, width), dtype=np.uint8))


robots = st.builds(
    SceneRobot,
    name=st.just("r"),
    number=st.integers(1, 300),
    pose=st.builds(Pose, metres, metres, metres),
    cargo=st.booleans(),
    selected=st.booleans(),
    online=st.booleans(),
    paused=st.booleans(),
    obstacle=st.booleans(),
    other_map=st.booleans(),
    age=metres,
    mark=st.text("0123456789", max_size=4),
)
vertices = st.builds(
    SceneVertex,
    id=st.text(max_size=3),
    x=metres,
    y=metres,
    role=st.sampled_from(Role),
    label=st.text(st.sampled_from("aB 仓é한\x1b\u0301"), max_size=9),
)


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    grid = draw(grids())
    some = st.lists(lines, max_size=4).map(tuple)
    edges = draw(some)
    return Scene(
        "floor",
        grid.frame,
        draw(st.sampled_from([grid, None])),
        tuple(draw(st.lists(vertices, max_size=9))),
        edges,
        tuple(draw(st.lists(robots, max_size=9))),
        ("1", "2"),
        one_way=edges[::2],
        mission=draw(st.one_of(st.none(), st.builds(Mission, some, some, st.one_of(st.none(), lines)))),
        trail=np.array(draw(st.lists(been, max_size=9))).reshape(-1, 3),
    )


@st.composite
def cameras(draw: st.DrawFn, frame: MapFrame) -> Camera:
    camera = Camera.fit((frame.width, frame.height), draw(st.integers(1, 130)), draw(st.integers(1, 50)))
    middle = draw(st.tuples(st.floats(-10, 90), st.floats(-10, 90)))
    return camera.zoomed(draw(st.floats(0.01, 500)), middle).centred(*middle)


looks = st.builds(
    MapOptions,
    drawing=st.sampled_from(Drawing),
    edges=st.booleans(),
    labels=st.booleans(),
    trails=st.booleans(),
    cursor=st.one_of(st.none(), st.tuples(st.floats(-60, 60), st.floats(-60, 60))),
    pointed=st.one_of(st.none(), st.integers(0, 9)),
)


@given(st.data(), scenes(), looks)
def test_every_view_is_a_picture_that_fills_its_canvas(
    data: st.DataObject, scene: Scene, look: MapOptions
) -> None:
    camera = data.draw(cameras(scene.frame))
    cells = picture(backdrop(scene, camera, look), scene, camera, look)
    assert cells.codes.shape == cells.roles.shape == (camera.height, camera.width)
    for runs in cells.all_runs():
        text = "".join(part for part, _ in runs)
        assert cell_width(text) == camera.width
        assert text.isprintable()
        assert text.isascii() or look.drawing is not Drawing.ASCII


@given(st.data(), grids())
def test_a_cell_to_metres_and_back_is_the_same_cell(data: st.DataObject, grid: OccupancyGrid) -> None:
    frame, camera = grid.frame, data.draw(cameras(grid.frame))
    x, y = data.draw(st.integers(0, camera.width - 1)), data.draw(st.integers(0, camera.height - 1))
    place = frame.to_world(*camera.to_pixel(x, y))
    assert camera.to_cell(*frame.to_pixel(*place)) == (x, y)
