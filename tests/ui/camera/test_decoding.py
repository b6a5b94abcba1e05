"""Pictures of any make, decoded small; hostile bytes are named, never raised."""

import io
import struct
import zlib

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from fleet_tui.ui.camera.decoding import MOST_PIXELS, decode


def file(image: Image.Image, format_: str = "PNG", **more: object) -> bytes:
    into = io.BytesIO()
    image.save(into, format_, **more)
    return into.getvalue()


def half_red(mode: str = "RGB", size: tuple[int, int] = (64, 48)) -> Image.Image:
    image = Image.new("RGB", size, (0, 0, 0))
    image.paste((255, 0, 0), (0, 0, size[0] // 2, size[1]))
    return image.convert(mode)


@pytest.mark.parametrize(
    ("mode", "format_"),
    [
        *[("RGB", "JPEG"), ("L", "JPEG"), ("CMYK", "JPEG")],
        *[("RGB", "PNG"), ("RGBA", "PNG"), ("L", "PNG"), ("LA", "PNG"), ("P", "PNG"), ("1", "PNG")],
    ],
)
def test_every_mode_is_scaled_to_fit(mode: str, format_: str) -> None:
    found = decode(file(half_red(mode), format_), 20, 40)
    assert found.pixels is not None and not found.reason
    assert found.size == (64, 48) and found.pixels.shape == (15, 20, 3)
    left, right = found.pixels[7, 2].astype(int), found.pixels[7, 17].astype(int)
    assert left[0] > 60 + right[0] and right.max() < 40


def test_a_small_picture_is_enlarged_and_a_line_keeps_one_pixel() -> None:
    small, line = (decode(file(half_red(size=size)), 32, 16).pixels for size in ((4, 2), (4000, 1)))
    assert small is not None and small.shape == (16, 32, 3)
    assert line is not None and line.shape == (1, 32, 3)


def test_sixteen_bits_of_grey_are_scaled_not_cut() -> None:
    deep = Image.fromarray(np.full((4, 4), 0x8000, np.uint16))
    found = decode(file(deep), 4, 4).pixels
    assert found is not None and found[0, 0].tolist() == [128, 128, 128]


def test_transparent_palettes_and_animations_are_shown() -> None:
    assert decode(file(half_red("P"), transparency=b"\x80\x00"), 8, 8).pixels is not None
    frames = file(half_red(), save_all=True, append_images=[Image.new("RGB", (64, 48), (0, 0, 255))])
    found = decode(frames, 8, 8).pixels
    assert found is not None and found[0, 0].tolist() == [255, 0, 0]


def claiming(width: int, height: int) -> bytes:
    head = b"IHDR" + struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    file = b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + head + struct.pack(">I", zlib.crc32(head))
    return file + struct.pack(">I", 100) + b"IDAT" + bytes(100)


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "unreadable: cut off"),
        (b"\x1b]52;c;xx", "unreadable: cut off, or neither JPEG nor PNG"),
        (file(half_red(), "GIF"), "unreadable: cut off, or neither JPEG nor PNG"),
        (file(half_red(size=(200, 200)), "JPEG")[:900], "unreadable: image file is truncated"),
        (claiming(30_000, 30_000), f"exceeds {MOST_PIXELS:,} px"),
        (claiming(10_000, 10_000), f"10000 x 10000 px exceeds {MOST_PIXELS:,} px"),
        (claiming(0, 5), "unreadable"),
    ],
)
def test_hostile_files_are_named(data: bytes, reason: str, capfd: pytest.CaptureFixture[str]) -> None:
    found = decode(data, 80, 40)
    assert found.pixels is None and reason in found.reason and found.reason.isprintable()
    assert capfd.readouterr() == ("", "")


FILES = [file(half_red(), "JPEG"), file(half_red("CMYK"), "JPEG"), file(half_red("P")), file(half_red("LA"))]


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(
    st.sampled_from(FILES),
    st.lists(st.tuples(st.floats(0, 1), st.binary(min_size=1, max_size=8)), max_size=6),
    st.floats(0, 1),
)
def test_no_mutation_of_a_file_gets_through(
    data: bytes, changes: list[tuple[float, bytes]], kept: float
) -> None:
    changed = bytearray(data)
    for place, new in changes:
        start = int(place * len(changed))
        changed[start : start + len(new)] = new
    found = decode(bytes(changed[: 20 + int(kept * len(changed))]), 16, 12)
    if found.pixels is None:
        assert found.reason
    else:
        height, width, parts = found.pixels.shape
        assert 0 < height <= 12 and 0 < width <= 16 and parts == 3
