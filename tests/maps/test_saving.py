"""Maps that are saved: read back as they were, at full precision, the older files kept."""

import re
from pathlib import Path

import numpy as np
import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from fleet_tui.maps import saving
from fleet_tui.maps.images import load_floor_map
from fleet_tui.maps.saving import map_files, pgm_of, save_map, yaml_of
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import Classes, build_grid, grid_from_ros
from fleet_tui.text.errors import MapError

PLACE = Pose(-1.1, 2.2, 0.3)
CLASSES = np.array([[0, 1, 2], [2, 1, 0]], np.uint8)


def grid(resolution: float = 0.0375, origin: Pose = PLACE, classes: Classes = CLASSES) -> OccupancyGrid:
    height, width = classes.shape
    return build_grid(MapFrame(resolution, width, height, origin), classes)


def test_a_map_has_the_shades_of_map_server() -> None:
    assert pgm_of(grid()) == b"P5\n3 2\n255\n" + bytes([205, 254, 0, 0, 254, 205])
    cells = grid_from_ros(MapFrame(1.0, 7, 1), np.array([0, 25, 26, 64, 65, 100, -1], np.int8).tobytes())
    assert pgm_of(cells)[-7:] == bytes([254, 254, 205, 205, 0, 0, 205])


def test_the_yaml_has_every_digit(tmp_path: Path) -> None:
    found = save_map(grid(0.05000000074505806, Pose(1e-7, -12345.678901234567, 0.1)), tmp_path / "hall")
    table = yaml.safe_load(found.read_text())
    assert table == {
        "image": "hall.pgm",
        "mode": "trinary",
        "resolution": 0.05000000074505806,
        "origin": [1e-7, -12345.678901234567, 0.1],
        "negate": 0,
        "occupied_thresh": 0.65,
        "free_thresh": 0.196,
    }


def test_files_are_named_alike_whatever_is_given() -> None:
    wanted = (Path("a/hall.yaml"), Path("a/hall.pgm"))
    assert (
        map_files(Path("a/hall")) == map_files(Path("a/hall.yaml")) == map_files(Path("a/hall.pgm")) == wanted
    )
    assert map_files(Path("hall.yml")) == (Path("hall.yml"), Path("hall.pgm"))
    assert map_files(Path("v1.2"))[0] == Path("v1.2.yaml")


@given(
    arrays(np.uint8, st.tuples(st.integers(1, 9), st.integers(1, 9)), elements=st.integers(0, 2)),
    st.floats(1e-4, 1e3),
    st.tuples(*[st.floats(-1e9, 1e9)] * 3),
)
def test_what_is_saved_is_loaded(
    tmp_path_factory: pytest.TempPathFactory,
    classes: Classes,
    resolution: float,
    origin: tuple[float, float, float],
) -> None:
    it = grid(resolution, Pose(*origin), classes)
    folder = tmp_path_factory.mktemp("maps")
    loaded = load_floor_map("", save_map(it, folder / "m"), added=False).grid
    assert loaded is not None and loaded.frame == it.frame
    assert np.array_equal(loaded.levels[0], it.levels[0])
    assert sorted(path.name for path in folder.iterdir()) == ["m.pgm", "m.yaml"]


def test_the_files_before_stay_as_bak(tmp_path: Path) -> None:
    steps = list[str]()
    save_map(grid(), tmp_path / "m", steps.append)
    save_map(grid(0.1), tmp_path / "m")
    assert steps == ["writing m.pgm", "writing m.yaml", "comparing m.yaml"]
    assert "0.0375" in (tmp_path / "m.yaml.bak").read_text() and (tmp_path / "m.pgm.bak").exists()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["m.pgm", "m.pgm.bak", "m.yaml", "m.yaml.bak"]


def test_files_that_differ_are_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(saving, "UNKNOWN_SHADE", 0)
    with pytest.raises(MapError, match="differs from the map when read back"):
        save_map(grid(), tmp_path / "m")


@pytest.mark.parametrize("name", ["a b", "x;rm", "ü", "a\n"])
def test_a_name_that_a_shell_or_a_yaml_misreads_is_refused(name: str) -> None:
    with pytest.raises(MapError, match="letters, digits"):
        yaml_of(grid(), f"{name}.pgm")


def test_what_cannot_be_described_or_written_is_named(tmp_path: Path) -> None:
    with pytest.raises(MapError, match='origin = "added"'):
        yaml_of(OccupancyGrid(MapFrame(1.0, 3, 2, Pose(0.0, 0.0), added=True), grid().levels), "m.pgm")
    with pytest.raises(MapError, match="not finite"):
        yaml_of(grid(origin=Pose(float("nan"), 0.0)), "m.pgm")
    with pytest.raises(MapError, match=re.escape("no folder")):
        save_map(grid(), tmp_path / "none" / "m")
