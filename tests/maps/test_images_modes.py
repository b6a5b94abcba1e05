"""The modes of map_server's YAML, images of every depth, and files that lie about themselves."""

import struct
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from fleet_tui.maps.images import load_floor_map
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN

YAML = """image: {image}
resolution: 0.05
origin: [0, 0, 0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.2
"""
F, X, U = FREE, OCCUPIED, UNKNOWN


@pytest.fixture
def save(tmp_path: Path) -> Callable[..., Path]:
    """Writes an image with a YAML beside it that has more lines at its end."""

    def saved(picture: Image.Image, *more: str, name: str = "m.png", **options: Any) -> Path:
        picture.save(tmp_path / name, **options)
        (tmp_path / "m.yaml").write_text(YAML.format(image=name) + "\n".join(more))
        return tmp_path / "m.yaml"

    return saved


def row(path: Path) -> list[int]:
    """The classes of the picture's first row."""
    loaded = load_floor_map("floor_0", path, False)
    assert loaded.grid is not None, loaded.problem
    found: list[int] = loaded.grid.levels[0][0].tolist()
    return found


def problem(path: Path) -> str:
    loaded = load_floor_map("floor_0", path, False)
    assert loaded.grid is None
    return loaded.problem


def greys(*shades: int) -> Image.Image:
    return Image.fromarray(np.array([shades], np.uint8))


def colours(*pixels: tuple[int, ...]) -> Image.Image:
    return Image.fromarray(np.array([pixels], np.uint8))


def test_trinary_is_the_mode_when_none_is_named(save: Callable[..., Path]) -> None:
    picture = greys(0, 89, 90, 204, 205, 255)
    for mode in ([], ["mode: trinary"], ["mode: Trinary"]):
        assert row(save(picture, *mode)) == [X, X, U, U, F, F]


def test_scale_says_more_between_the_thresholds(save: Callable[..., Path]) -> None:
    # Occupancy 0.2 .. 0.65 becomes 0 .. 100 %: up to 25 % counts as free, from 65 % on as occupied.
    shades = [255, 204, 190, 176, 174, 150, 131, 128, 60]
    percent = [max(0.0, min(100.0, ((255 - shade) / 255 - 0.2) / 0.45 * 100)) for shade in shades]
    wanted = [F if part <= 25.5 else X if part >= 64.5 else U for part in percent]
    assert wanted.count(U) >= 2
    assert row(save(greys(*shades), "mode: scale")) == wanted


def test_raw_takes_the_pixel_for_the_percentage(save: Callable[..., Path]) -> None:
    assert row(save(greys(0, 25, 26, 64, 65, 100, 101, 255), "mode: raw")) == [F, F, U, U, X, X, U, U]


def test_negate_turns_black_and_white_round_except_in_raw(save: Callable[..., Path]) -> None:
    picture = greys(0, 255, 128)
    assert row(save(picture, "negate: 1")) == [F, X, U]
    assert row(save(picture, "negate: true")) == [F, X, U]
    assert row(save(picture, "negate: 1", "mode: scale"))[:2] == [F, X]
    assert row(save(picture, "negate: 1", "mode: raw"))[0] == F


def test_colours_are_averaged_not_weighted_as_the_eye_does(save: Callable[..., Path]) -> None:
    # Green alone is bright to the eye, but a third to map_server; so are red and blue.
    assert row(save(colours((0, 255, 0), (255, 0, 0), (0, 0, 255)))) == [X, X, X]
    assert row(save(colours((255, 255, 0), (255, 255, 255)))) == [U, F]


def test_alpha_is_a_channel_in_trinary_and_a_veil_in_scale(save: Callable[..., Path]) -> None:
    picture = colours((255, 255, 255, 255), (255, 255, 255, 0), (0, 0, 0, 0), (0, 0, 0, 255))
    assert row(save(picture)) == [F, U, X, X]
    assert row(save(picture, "mode: scale")) == [F, U, U, X]
    grey = Image.fromarray(np.array([[[255, 255], [255, 0], [0, 255]]], np.uint8), "LA")
    assert row(save(grey, "mode: scale")) == [F, U, X]


def test_a_palette_with_a_transparent_colour(save: Callable[..., Path]) -> None:
    picture = Image.fromarray(np.array([[0, 1, 2]], np.uint8), "P")
    picture.putpalette([255, 255, 255, 0, 0, 0, 255, 255, 255])
    assert row(save(picture, "mode: scale", transparency=2)) == [F, X, U]


@pytest.mark.parametrize("name", ["m.png", "m.pgm"])
def test_sixteen_bits(save: Callable[..., Path], name: str) -> None:
    deep = Image.fromarray(np.array([[0, 255, 0x8000, 0xFFFF]], np.uint16))
    assert row(save(deep, name=name)) == [X, X, U, F]


def test_text_pgm_and_plain_bits(tmp_path: Path) -> None:
    (tmp_path / "m.pgm").write_text("P2\n# made by hand\n3 1\n255\n0 128 255\n")
    assert row(tmp_path / "m.pgm") == [X, U, F]
    (tmp_path / "bits.pbm").write_bytes(b"P4\n8 1\n\x0f")
    assert row(tmp_path / "bits.pbm") == [F] * 4 + [X] * 4


def test_the_image_may_lie_elsewhere(save: Callable[..., Path], tmp_path: Path) -> None:
    path = save(greys(0, 255))
    (tmp_path / "maps").mkdir()
    moved = path.rename(tmp_path / "maps" / "m.yaml")
    moved.write_text(YAML.format(image="../m.png"))
    assert row(moved) == [X, F]
    moved.write_text(YAML.format(image=tmp_path / "m.png"))
    assert row(moved) == [X, F]


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("mode: ternary", "mode 'ternary' is not one of trinary, scale, raw"),
        ("mode: 3", "mode '3' is not one of"),
        ("negate: maybe", "negate: 'maybe' instead of 0 or 1"),
        ("resolution: 0", "resolution 0.0 m/px"),
    ],
)
def test_what_is_no_mode_is_said(save: Callable[..., Path], line: str, says: str) -> None:
    assert says in problem(save(greys(0), line))


def png_of(width: int, height: int, packed: bytes) -> bytes:
    """A PNG that claims a size whatever it holds."""

    def chunk(kind: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("none.pgm", b"P5\n0 0\n255\n", ""),
        ("minus.pgm", b"P5\n-3 4\n255\n", ""),
        ("depth.pgm", b"P5\n1 1\n0\n\0", ""),
        ("short.pgm", b"P5\n4000 4000\n255\n" + bytes(100), "unreadable"),
        ("empty.png", b"", "not a supported image"),
        ("wide.png", png_of(2**31 - 1, 1, b""), "exceeds 100,000,000 px"),
        ("large.png", png_of(10_001, 10_000, b""), "exceeds 100,000,000 px"),
        ("hollow.png", png_of(5000, 5000, zlib.compress(b"")), "unreadable"),
        ("bomb.png", png_of(1, 1, zlib.compress(bytes(50_000_000))), None),
        ("page.eps", b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 9 9\n", "not a supported image"),
        ("deep.tif", b"II*\0\x08\0\0\0\0\0\0\0\0\0", "not a supported image"),
    ],
)
def test_files_that_lie(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], name: str, content: bytes, says: str | None
) -> None:
    (tmp_path / name).write_bytes(content)
    loaded = load_floor_map("floor_0", tmp_path / name, False)
    if says is None:  # more than was announced is not looked at
        assert loaded.grid is not None
    else:
        assert loaded.grid is None
        assert f"map {name}: " in loaded.problem and says in loaded.problem
    assert capfd.readouterr() == ("", "")


def test_a_yaml_too_large_to_be_one(tmp_path: Path) -> None:
    (tmp_path / "m.yaml").write_bytes(b"#" * 1_000_001)
    assert "over 65,536 bytes" in problem(tmp_path / "m.yaml")
