"""Saves a map as map_server's YAML with a P5 PGM beside it: at full precision, read back and compared."""

import math
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np

from fleet_tui.maps.images import load_floor_map
from fleet_tui.model.grid import FREE, OCCUPIED, OccupancyGrid
from fleet_tui.storage.whole_file import write_whole
from fleet_tui.text.errors import MapError
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize

SHADES = {OCCUPIED: 0, FREE: 254}
"""Brightness of the classes; unknown ground is UNKNOWN_SHADE."""
UNKNOWN_SHADE = 205
THRESHOLDS = "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
YAML = (".yaml", ".yml")
_PLAIN = re.compile(r"[A-Za-z0-9_.-]+")


def map_files(path: Path) -> tuple[Path, Path]:
    """Return the YAML and the PGM of a map that is saved as either, or under a name without an ending."""
    stem = path.with_suffix("") if path.suffix.lower() in (*YAML, ".pgm") else path
    yaml = path if path.suffix.lower() in YAML else stem.with_name(f"{stem.name}.yaml")
    return yaml, stem.with_name(f"{stem.name}.pgm")


def pgm_of(grid: OccupancyGrid) -> bytes:
    """Return the image of a map, row 0 at the top."""
    shades = np.full(256, UNKNOWN_SHADE, dtype=np.uint8)
    for kind, shade in SHADES.items():
        shades[kind] = shade
    height, width = grid.levels[0].shape
    return f"P5\n{width} {height}\n255\n".encode() + shades[grid.levels[0]].tobytes()


def yaml_of(grid: OccupancyGrid, image: str) -> str:
    """Return the YAML of a map, at full precision. Raises MapError for a frame that it can't describe."""
    frame = grid.frame
    if frame.added:
        raise MapError(Message('the map is placed by origin = "added", which map_server can\'t express'))
    if not _PLAIN.fullmatch(image):
        raise MapError(
            Message("{image}: use letters, digits, _, - and . in the name of a map", image=f"{image!r}")
        )
    numbers = frame.resolution, frame.origin.x, frame.origin.y, frame.origin.yaw
    if not all(map(math.isfinite, numbers)):
        raise MapError(Message("the position of the map is not finite"))
    # Without an exponent, which YAML reads as a text; the shortest digits that read back the same.
    resolution, x, y, yaw = (np.format_float_positional(number, trim="0") for number in numbers)
    head = f"image: {image}\nmode: trinary\nresolution: {resolution}\norigin: [{x}, {y}, {yaw}]\n"
    return head + THRESHOLDS


def save_map(grid: OccupancyGrid, path: Path, report: Callable[[Message], None] = lambda _step: None) -> Path:
    """Save a map and return its YAML. Existing files stay as `.bak`. `report` gets each step. Takes long: not
    for the loop. Raises MapError."""
    yaml, pgm = map_files(path)
    text = yaml_of(grid, pgm.name)
    for file, content in ((pgm, pgm_of(grid)), (yaml, text.encode())):
        report(Message("writing {name}", name=file.name))
        try:
            write_whole(file, content, keep=True, is_shared=True)
        except OSError as problem:
            # Its name is that of a temporary file.
            reason = problem.strerror or problem if file.parent.is_dir() else f"no folder {file.parent}"
            raise MapError(Message("{file} cannot be written: {reason}", file=file, reason=reason)) from None
    report(Message("comparing {name}", name=yaml.name))
    _compare(grid, yaml)
    return yaml


def _compare(grid: OccupancyGrid, yaml: Path) -> None:
    loaded = load_floor_map("", yaml, added=False)
    if loaded.grid is None:
        raise MapError(Message("{yaml}: read back: {problem}", yaml=yaml, problem=loaded.problem))
    if loaded.grid.frame != grid.frame or not np.array_equal(loaded.grid.levels[0], grid.levels[0]):
        raise MapError(
            Message("{yaml}: differs from the map when read back: the disk may be full or faulty", yaml=yaml)
        )


def file_name(floor: str) -> str:
    """Return a file's name for a floor: a typed line ends at a space."""
    return "_".join(sanitize(floor).split()).replace("/", "_")
