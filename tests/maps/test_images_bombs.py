"""Map files made to hang or to fill the memory: refused in words, soon, and within a bound."""

import struct
import subprocess
import sys
import zlib
from itertools import pairwise
from pathlib import Path

import pytest
from PIL import Image

from fleet_tui.maps.images import load_floor_map

pytestmark = pytest.mark.nightly

BASE = "image: m.png\nresolution: 0.05\norigin: [0, 0, 0]\n"
PEAK = 700
"""Megabytes that the process may take for the largest image there may be."""


def problem(path: Path) -> str:
    loaded = load_floor_map("floor_0", path, False)
    assert (loaded.grid is None) is bool(loaded.problem)
    return loaded.problem


def chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(width: int, height: int, data: bytes, *more: bytes, depth: int = 8, kind: int = 0) -> bytes:
    head = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0)
    parts = [chunk(b"IHDR", head), *more, chunk(b"IDAT", zlib.compress(data)), chunk(b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


IMAGES = {
    "vast.png": (png(60_000, 60_000, b""), "exceeds 100,000,000 px"),
    "endless.png": (png(2**31 - 1, 2**31 - 1, b""), "100,000,000 px"),
    "nothing.png": (png(0, 0, b""), "map nothing.png: "),
    "lies.png": (png(9_000, 9_000, b"\0\0"), "unreadable"),
    "vast.gif": (b"GIF89a" + struct.pack("<HHBBB", 65_535, 65_535, 0, 0, 0), "is not a supported image"),
    "vast.pgm": (b"P5\n999999999999 999999999999\n255\n", "unreadable"),
    "digits.pgm": (b"P5\n" + b"9" * 100_000, "unreadable"),
    "comment.pgm": (b"P5\n#" + b"x" * 1_000_000, "unreadable"),
    "plain.pgm": (b"P2\n9999 9999\n255\n" + b"1 " * 1000, "unreadable"),
    "vast.bmp": (
        b"BM" + struct.pack("<IHHIIiiHHIIIIII", 100, 0, 0, 54, 40, 99_999, 99_999, 1, 24, *[0] * 6),
        "px",
    ),
    "empty.png": (b"", "is not a supported image"),
    "starts.svg": (b"<svg/>", "is not a supported image"),
    "runs.eps": (b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 9 9\n", "is not a supported image"),
    "tags.tiff": (b"II*\0\x08\0\0\0\xff\xff" + b"\xff" * 100, "is not a supported image"),
}


@pytest.mark.parametrize("name", list(IMAGES))
def test_an_image_that_is_a_bomb(tmp_path: Path, name: str, recwarn: pytest.WarningsRecorder) -> None:
    content, says = IMAGES[name]
    (tmp_path / name).write_bytes(content)
    said = problem(tmp_path / name)
    assert says in said and len(said) < 300
    assert not recwarn.list


@pytest.mark.parametrize("start", [b"zTXta\0\0", b"iTXta\0\1\0\0\0", b"iCCPa\0\0"])
def test_a_text_in_an_image_that_is_a_bomb(
    tmp_path: Path, start: bytes, recwarn: pytest.WarningsRecorder
) -> None:
    long = zlib.compress(bytes(200_000_000), 1)
    (tmp_path / "m.png").write_bytes(png(1, 1, b"\0\0", chunk(start[:4], start[4:] + long)))
    assert len(problem(tmp_path / "m.png")) < 300
    assert not recwarn.list


def bomb(line: str, last: str) -> str:
    """Ten to the power of nine of something, in a few lines."""
    names = "abcdefghij"
    lines = [line.format(new=new, old=",".join([f"*{old}"] * 10)) for old, new in pairwise(names)]
    return f"a: &a {last}\n" + "\n".join(lines) + "\n"


YAML = {
    "aliases": (bomb("{new}: &{new} [{old}]", "[x]") + "mode: *j\n", "aliases not supported"),
    "merges": (bomb("{new}: &{new} {{<<: [{old}]}}", "{x: 1}"), "aliases not supported"),
    "itself": ("mode: &x [*x]\n", "aliases not supported"),
    "sexagesimal": ("x: 1" + ":1" * 30_000 + "\n", ""),
    "sexagesimal float": ("occupied_thresh: 1" + ":1" * 30_000 + ".5\n", "too large"),
    "large": ("#" * 100_000, "over 65,536 bytes"),
    "deep": ("x: " + "{a: " * 15_000, "nested too deep"),
    "keys": ("".join(f"k{n}: 1\n" for n in range(6_000)), ""),
    "python": ("mode: !!python/object/apply:os.system [exit]\n", "could not determine a constructor"),
    "new object": ("mode: !!python/object/new:type [a, [], {}]\n", "could not determine a constructor"),
    "control": ('mode: "\\e]52;c;eA==\\a"\n', "is not one of trinary"),
}


@pytest.mark.parametrize("name", list(YAML))
def test_a_yaml_that_is_a_bomb(tmp_path: Path, name: str) -> None:
    text, says = YAML[name]
    Image.new("L", (2, 2)).save(tmp_path / "m.png")
    (tmp_path / "m.yaml").write_text(BASE + text)
    assert says in problem(tmp_path / "m.yaml")


def test_a_file_without_an_end(tmp_path: Path) -> None:
    (tmp_path / "m.yaml").symlink_to("/dev/zero")
    (tmp_path / "m.png").symlink_to("/dev/zero")
    for name in ("m.yaml", "m.png"):
        assert "not a regular file" in problem(tmp_path / name)
    (tmp_path / "long.yaml").write_text("#" * 70_000)
    assert "over 65,536 bytes" in problem(tmp_path / "long.yaml")


MEASURED = """
import sys
from pathlib import Path
from fleet_tui.maps.images import load_floor_map
assert load_floor_map("floor_0", Path(sys.argv[1]), False).grid
print(next(line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM")))
"""


def test_the_largest_image_there_may_be_takes_so_much_memory(tmp_path: Path) -> None:
    """In colour, with alpha: 400 MB of pixels in a file of 400 kB."""
    row = zlib.compressobj(1)
    data = b"".join(row.compress(bytes(40_001)) for _ in range(10_000)) + row.flush()
    head = struct.pack(">IIBBBBB", 10_000, 10_000, 8, 6, 0, 0, 0)
    parts = (chunk(b"IHDR", head), chunk(b"IDAT", data), chunk(b"IEND", b""))
    (tmp_path / "m.png").write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(parts))
    command = [sys.executable, "-c", MEASURED, str(tmp_path / "m.png")]
    assert int(subprocess.check_output(command)) * 1024 / 1e6 < PEAK
