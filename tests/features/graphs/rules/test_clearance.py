"""Room for the robot on the map."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.graphs.rules import clearance as module
from fleet_tui.features.graphs.rules.clearance import clearance, spread, widened
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, build_grid


def hall() -> OccupancyGrid:
    """10 x 5 m of floor; a pillar at (5, 2.5), unknown ground from x = 8 on."""
    cells = np.full((100, 200), FREE, np.uint8)
    cells[48:52, 98:102] = OCCUPIED
    cells[:, 160:] = UNKNOWN
    return build_grid(MapFrame(0.05, 200, 100), cells)


def texts(*places: tuple[float, float], width: float = 0.6, grid: OccupancyGrid | None = None) -> list[str]:
    vertices = {str(n): DocumentVertex(str(n), x, y) for n, (x, y) in enumerate(places)}
    edges = {str(n): DocumentEdge(str(n), str(n), str(n + 1)) for n in range(len(places) - 1)}
    found = clearance(DocumentFloor("f", vertices, edges), grid or hall(), width)
    return [one.text for group in found for one in group]


def test_vertices_near_obstacles_and_on_unknown_ground() -> None:
    assert texts((5.0, 2.05)) == ["vertex 0: nearer to an obstacle than 0.40 m"]
    assert texts((5.0, 1.9)) == [] and texts((5.0, 2.05), width=0.3) == []
    assert texts((9.0, 1.0)) == ["vertex 0: on unknown ground"]


def test_edges_without_room() -> None:
    assert texts((1.0, 2.5), (7.0, 2.5)) == ["edge 0 from 0 to 1: no room for a robot 0.6 m wide"]
    assert texts((1.0, 2.0), (7.0, 2.0)) == []
    assert texts((1.0, 2.15), (7.0, 2.15)) == ["edge 0 from 0 to 1: no room for a robot 0.6 m wide"]
    assert texts((1.0, 1.0), (9.0, 1.0))[1:] == ["edge 0 from 0 to 1: no room for a robot 0.6 m wide"]


def test_a_turned_map_and_a_wide_robot(monkeypatch: pytest.MonkeyPatch) -> None:
    grid = hall()
    turned = OccupancyGrid(MapFrame(0.05, 200, 100, Pose(10.0, 0.0, np.pi / 2)), grid.levels)
    assert texts((10.0 - 2.5, 5.0), grid=turned) == ["vertex 0: nearer to an obstacle than 0.40 m"]
    monkeypatch.setattr(module, "WIDEST", 4)
    assert texts((5.0, 2.05)) and texts((5.0, 1.5)) == []


def test_off_the_map_and_nowhere() -> None:
    assert texts((50.0, 50.0)) == [] or texts((50.0, 50.0)) == ["vertex 0: on unknown ground"]
    assert texts((float("nan"), 0.0), (1.0, 1.0)) is not None
    assert texts() == []


@given(st.lists(st.booleans(), min_size=9, max_size=9), st.integers(0, 9))
def test_spreading_reaches_just_so_far(row: list[bool], across: int) -> None:
    mask = np.array([row])
    near = [any(row[max(0, n - across) : n + across + 1]) for n in range(9)]
    assert spread(mask, across).tolist() == [near]


def test_widening_is_round() -> None:
    mask = np.zeros((7, 7), np.bool_)
    mask[3, 3] = True
    rows = ["".join(".#"[int(cell)] for cell in row) for row in widened(mask, 2.5)]
    assert rows == [".......", "..###..", ".#####.", ".#####.", ".#####.", "..###..", "......."]
