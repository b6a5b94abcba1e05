"""Map images become classes as map_server makes them; what can't be read is said, never raised."""

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from fleet_tui.maps.images import load_floor_map
from fleet_tui.model.geometry import Pose
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN

DEPOT = Path(__file__).parent.parent.parent / "shared" / "maps" / "depot"
BASE = "image: m.png\nresolution: 0.05\norigin: [-1.0, -2.0, 0.5]\n"

Write = Callable[..., Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Writes m.png with one row of shades and m.yaml beside it."""

    def written(yaml: str = BASE, shades: tuple[int, ...] = (0, 128, 255), name: str = "m.yaml") -> Path:
        Image.fromarray(np.array([shades], np.uint8)).save(tmp_path / "m.png")
        (tmp_path / name).write_text(yaml, encoding="utf-8")
        return tmp_path / name

    return written


def grid(path: Path, added: bool = False) -> OccupancyGrid:
    loaded = load_floor_map("floor_0", path, added)
    assert (loaded.floor, loaded.problem) == ("floor_0", "")
    assert loaded.grid is not None
    return loaded.grid


def classes(path: Path) -> list[int]:
    row: list[int] = grid(path).levels[0][0].tolist()
    return row


def problem(path: Path) -> str:
    loaded = load_floor_map("floor_0", path, False)
    assert loaded.grid is None
    assert loaded.problem.startswith(f"map {path.name}: ") and "\n" not in loaded.problem
    return loaded.problem


def as_map_server_does(shade: int, negate: bool, occupied: float, free: float) -> int:
    """image_loader.cpp: occ = (255 - shade) / 255; > occupied_thresh, < free_thresh, else unknown."""
    occupancy = (shade if negate else 255 - shade) / 255.0
    if occupancy > occupied:
        return OCCUPIED
    return FREE if occupancy < free else UNKNOWN


@pytest.mark.parametrize("negate", [0, 1])
@pytest.mark.parametrize("thresholds", [(0.65, 0.196), (0.65, 0.25), (0.9, 0.1), (0.5, 0.5)])
def test_every_shade_is_what_map_server_makes_of_it(
    write: Write, negate: int, thresholds: tuple[float, float]
) -> None:
    occupied, free = thresholds
    yaml = f"{BASE}negate: {negate}\noccupied_thresh: {occupied}\nfree_thresh: {free}\nmode: trinary\n"
    wanted = [as_map_server_does(shade, bool(negate), occupied, free) for shade in range(256)]
    assert classes(write(yaml, tuple(range(256)))) == wanted


def test_the_usual_three_shades_without_thresholds(write: Write) -> None:
    assert classes(write(shades=(0, 205, 254))) == [OCCUPIED, FREE, FREE]
    assert classes(write(shades=(0, 128, 255))) == [OCCUPIED, UNKNOWN, FREE]


def test_the_frame_with_its_turn(write: Write) -> None:
    frame = grid(write()).frame
    assert (frame.resolution, frame.width, frame.height) == (0.05, 3, 1)
    assert frame.origin == Pose(-1.0, -2.0, 0.5) and not frame.added
    assert grid(write(), added=True).frame.added
    assert grid(write(BASE.replace("0.5]", "1]"), name="m.YML")).frame.origin.yaw == 1.0


def test_row_0_is_the_top_of_the_image(tmp_path: Path) -> None:
    Image.fromarray(np.array([[0, 0], [255, 255]], np.uint8)).save(tmp_path / "m.pgm")
    assert grid(tmp_path / "m.pgm").levels[0].tolist() == [[OCCUPIED] * 2, [FREE] * 2]


def test_a_plain_image_waits_for_map_metadata(write: Write, tmp_path: Path) -> None:
    write()
    loaded = load_floor_map("floor_0", tmp_path / "m.png", False)
    assert loaded.grid is not None and not loaded.tied
    assert (loaded.grid.frame.width, loaded.grid.frame.height) == (3, 1)
    assert load_floor_map("floor_0", tmp_path / "m.yaml", False).tied


def test_images_of_colour_and_of_one_bit(tmp_path: Path) -> None:
    Image.new("RGB", (2, 1), (255, 255, 255)).save(tmp_path / "rgb.png")
    Image.new("1", (2, 1), 0).save(tmp_path / "bit.png")
    assert classes(tmp_path / "rgb.png") == [FREE, FREE]
    assert classes(tmp_path / "bit.png") == [OCCUPIED, OCCUPIED]


@pytest.mark.parametrize(
    ("yaml", "says"),
    [
        ("", "no image"),
        ("- 1\n", "no image"),
        ("image: 7\n", "origin: nothing instead of [x, y, yaw]"),
        ("image: [\n", "unreadable"),
        ("\x1b: 1\n", "unreadable"),
        ("x: " + "[" * 5000, "unreadable"),
        (BASE.replace("m.png", "gone.png"), "/gone.png"),
        (BASE.replace("m.png", "file:///srv/gone.png"), "no image /srv/gone.png"),
        (BASE.replace("m.png", "package://site/gone.png"), "image package://site/gone.png: packages are"),
        (BASE.replace("m.png", "m.yaml"), "m.yaml is not a supported image"),
        (BASE.replace("m.png", "."), "unreadable"),
        (BASE.replace("0.05", "0"), "resolution 0.0 m/px"),
        (BASE.replace("0.05", "-1"), "resolution -1.0 m/px"),
        (BASE.replace("0.05", ".nan"), "resolution: '.nan' instead of a number"),
        (BASE.replace("0.05", "0,05"), "resolution: '0,05' instead of a number"),
        (BASE.replace("resolution: 0.05\n", ""), "resolution is missing"),
        (BASE + "occupied_thresh: " + "9" * 400 + "\n", "instead of a number"),
        (BASE + "free_thresh: true\n", "free_thresh: 'true' instead of a number"),
        (BASE.replace("[-1.0, -2.0, 0.5]", "5"), "origin: 5 instead of [x, y, yaw]"),
        (BASE.replace("-2.0, 0.5", "-2.0"), "origin: ['-1.0', '-2.0'] instead of"),
        (BASE.replace("-2.0", "x"), "origin[1]: 'x' instead of a number"),
        (BASE.replace("-2.0", ".inf"), "origin[1]: '.inf' instead of a number"),
    ],
)
def test_what_is_wrong_is_said(write: Write, yaml: str, says: str) -> None:
    assert says in problem(write(yaml))


@pytest.mark.parametrize(
    ("yaml", "frame"),
    [
        (BASE.replace("0.5]", "1e-16]"), (0.05, -1.0, -2.0, 1e-16)),
        (BASE.replace("0.05", "'5e-2'"), (0.05, -1.0, -2.0, 0.5)),
        (BASE.replace("-1.0", "+.5"), (0.05, 0.5, -2.0, 0.5)),
        (BASE.replace("[-1.0, -2.0, 0.5]", "'[-1.0, -2.0, 0.5]'"), (0.05, -1.0, -2.0, 0.5)),
        (BASE.replace("0.05", "010"), (10.0, -1.0, -2.0, 0.5)),
        (BASE.replace("m.png", ".\\m.png") + "negate: 'no'\n", (0.05, -1.0, -2.0, 0.5)),
        (BASE + "made: 2020-99-99\nx: !!int zz\n", (0.05, -1.0, -2.0, 0.5)),
    ],
)
def test_values_are_those_of_map_server(
    write: Write, yaml: str, frame: tuple[float, float, float, float]
) -> None:
    found = grid(write(yaml)).frame
    resolution, *origin = frame
    assert (found.resolution, found.origin) == (resolution, Pose(*origin))


def test_files_that_are_not_there_or_not_whole(write: Write, tmp_path: Path) -> None:
    assert "no such file" in problem(tmp_path / "gone.yaml")
    assert f"no image {tmp_path}/gone.png" in problem(tmp_path / "gone.png")
    (tmp_path / "dir.yaml").mkdir()
    assert "unreadable" in problem(tmp_path / "dir.yaml")
    (tmp_path / "latin.yaml").write_bytes(b"image: \xff\n")
    assert "unreadable" in problem(tmp_path / "latin.yaml")
    (tmp_path / "cut.pgm").write_bytes(b"P5\n3 2\n255\n\0\0\0")
    assert "unreadable" in problem(tmp_path / "cut.pgm")
    (tmp_path / "huge.pgm").write_bytes(b"P5\n20000 9000\n255\n")
    assert "exceeds 100,000,000 px" in problem(tmp_path / "huge.pgm")
    (tmp_path / "text.png").write_text("<svg/>")
    assert "text.png is not a supported image" in problem(tmp_path / "text.png")


def test_a_large_map_warns_nobody(tmp_path: Path, recwarn: pytest.WarningsRecorder) -> None:
    """A warning on stderr would tear the screen; Pillow's own limit is below ours."""
    (tmp_path / "large.pbm").write_bytes(b"P4\n9600 9600\n" + bytes(9600 * 1200))
    assert grid(tmp_path / "large.pbm").levels[0].shape == (9600, 9600)
    assert not recwarn.list


@pytest.fixture(scope="session")
def image(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("damaged") / "m.png"
    Image.fromarray(np.arange(64, dtype=np.uint8).reshape(8, 8)).save(path)
    return path


@given(cut=st.integers(0, 120), flips=st.dictionaries(st.integers(0, 119), st.integers(0, 255), max_size=4))
def test_a_damaged_image_is_drawn_or_said(image: Path, cut: int, flips: dict[int, int]) -> None:
    payload = bytearray(image.read_bytes()[:cut])
    for place, byte in flips.items():
        payload[place : place + 1] = bytes([byte]) if place < len(payload) else b""
    damaged = image.with_name("damaged.png")
    damaged.write_bytes(payload)
    loaded = load_floor_map("floor_0", damaged, False)
    assert (loaded.grid is None) is bool(loaded.problem)


@pytest.mark.skipif(
    not DEPOT.is_dir(), reason="the depot map lies beside the repository only where it was built"
)
def test_the_depot_map() -> None:
    found = grid(DEPOT / "depot.yaml")
    assert (found.frame.width, found.frame.height, found.frame.resolution) == (604, 307, 0.05)
    assert found.frame.origin == Pose(0.0, 0.0, 0.0)
    base = found.levels[0]
    with Image.open(DEPOT / "depot.pgm") as picture:
        dark = np.asarray(picture.convert("L")) < 255 * (1 - 0.65)
    assert ((base == OCCUPIED) == dark).all() and dark.any()
    assert math.isclose((base == FREE).mean() + (base == UNKNOWN).mean() + dark.mean(), 1.0)
    assert all((level == OCCUPIED).any() for level in found.levels)
