"""Map images from files: map_server's YAML, or a plain image that map_metadata ties to the world."""

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import yaml
from PIL import Image, UnidentifiedImageError

from fleet_tui.errors import MapError
from fleet_tui.model.events import FloorMapLoaded
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import (
    FREE,
    MAX_PIXELS,
    OCCUPIED,
    UNKNOWN,
    Classes,
    OccupancyGrid,
    build_grid,
    check_frame,
)

# map_server's own defaults, for a plain image too.
OCCUPIED_ABOVE, FREE_BELOW = 0.65, 0.25


def load_floor_map(floor: str, path: Path, added: bool) -> FloorMapLoaded:
    """A floor's map file, or what is wrong with it. Takes long for large images: not for the loop."""
    try:
        if path.suffix.lower() in (".yaml", ".yml"):
            return FloorMapLoaded(floor, _from_yaml(path, added))
        classes = _classes(path, negate=False, occupied=OCCUPIED_ABOVE, free=FREE_BELOW)
        frame = MapFrame(1.0, classes.shape[1], classes.shape[0])
        return FloorMapLoaded(floor, build_grid(frame, classes), tied=False)
    except MapError as problem:
        return FloorMapLoaded(floor, None, f"map {path.name}: {problem}")


def _number(table: dict[str, Any], key: str, default: float | None = None) -> float:
    value = table.get(key, default)
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) <= 1e300:
        raise MapError(f"{key} must be a number" if key in table else f"{key} is missing")
    return float(value)


def _from_yaml(path: Path, added: bool) -> OccupancyGrid:
    try:
        table = yaml.safe_load(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise MapError("no such file") from None
    except (OSError, ValueError, LookupError, AttributeError, yaml.YAMLError, RecursionError) as problem:
        raise MapError(f"can't be read: {' '.join(str(problem).split())}") from None
    if not isinstance(table, dict) or not isinstance(table.get("image"), str):
        raise MapError("is no map_server file: it names no image")
    origin = table.get("origin")
    if not isinstance(origin, list) or len(origin) not in (2, 3):
        raise MapError("origin must be [x, y, yaw]")
    x, y, yaw = (_number({"origin": part}, "origin") for part in [*origin, 0.0][:3])
    classes = _classes(
        path.parent / table["image"],
        negate=bool(table.get("negate", 0)),
        occupied=_number(table, "occupied_thresh", OCCUPIED_ABOVE),
        free=_number(table, "free_thresh", FREE_BELOW),
    )
    height, width = classes.shape
    frame = MapFrame(_number(table, "resolution"), width, height, Pose(x, y, yaw), added)
    check_frame(frame)
    return build_grid(frame, classes)


def _classes(path: Path, negate: bool, occupied: float, free: float) -> Classes:
    """Brightness to classes as map_server does it: dark is occupied unless negated."""
    shades = np.arange(256) / 255.0
    darkness = shades if negate else 1.0 - shades
    table = np.where(darkness > occupied, OCCUPIED, np.where(darkness < free, FREE, UNKNOWN)).astype(np.uint8)
    return np.asarray(table[_pixels(path)], dtype=np.uint8)


def _pixels(path: Path) -> Classes:
    """An image as 8-bit grey, uint8 of shape (height, width)."""
    try:
        with warnings.catch_warnings():
            # Pillow's own limit is lower than ours and warns on stderr, which would tear the screen.
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            with Image.open(path) as image:
                if image.width * image.height > MAX_PIXELS:
                    raise MapError(f"{image.width} x {image.height} px is over {MAX_PIXELS:,} px")
                return np.asarray(image.convert("L"), dtype=np.uint8)
    except FileNotFoundError:
        raise MapError(f"no image {path.name}") from None
    except UnidentifiedImageError:
        raise MapError(f"{path.name} is no image") from None
    except Image.DecompressionBombError:
        raise MapError(f"{path.name} is over {MAX_PIXELS:,} px") from None
    except (OSError, ValueError, SyntaxError) as problem:
        raise MapError(f"{path.name} can't be read: {problem}") from None
