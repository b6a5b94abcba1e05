"""Map images from files: map_server's YAML, or a plain image that map_metadata places in the world."""

import warnings
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import IO, Any

import numpy as np
import yaml
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError
from yaml.reader import ReaderError

from fleet_tui.config.small_file import read_text
from fleet_tui.maps.formats.fields import is_number
from fleet_tui.model.events import FloorMapLoaded
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import MAX_PIXELS, OccupancyGrid, check_frame
from fleet_tui.model.occupancy import CLASS_OF_CELL, FREE, OCCUPIED, UNKNOWN, Classes, build_grid
from fleet_tui.storage.handles import open_file
from fleet_tui.text.errors import MapError
from fleet_tui.text.language import Message

MODES = ("trinary", "scale", "raw")
# Not all formats of Pillow: TIFF's library writes on stderr, EPS starts a program.
FORMATS = ("PPM", "PNG", "BMP", "JPEG", "GIF", "WEBP")
MAX_YAML = 2**16  # bytes
_BAND = 256  # rows converted to classes at a time: a large image in colour is not copied whole


@dataclass(frozen=True, slots=True)
class OccupancyThresholds:
    """The thresholds by which map_server (ROS 1) and nav2_map_server turn brightness into occupancy, 0 to 1.

    The defaults are theirs, for a plain image too.
    """

    mode: str = "trinary"
    negate: bool = False
    occupied_above: float = 0.65
    free_below: float = 0.25


def load_floor_map(floor: str, path: Path, added: bool) -> FloorMapLoaded:
    """Return a floor's map file, or its error. Takes long for large images: not for the loop."""
    try:
        if path.suffix.lower() in (".yaml", ".yml"):
            return FloorMapLoaded(floor, _from_yaml(path, added))
        classes = _classes(path, OccupancyThresholds())
        frame = MapFrame(1.0, classes.shape[1], classes.shape[0])
        return FloorMapLoaded(floor, build_grid(frame, classes), tied=False)
    except MapError as problem:
        return FloorMapLoaded(floor, None, Message("map {name}: {problem}", name=path.name, problem=problem))


_FLAGS = {
    **dict.fromkeys(("1", "true", "yes", "on", "y"), True),
    **dict.fromkeys(("0", "false", "no", "off", "n"), False),
}


def _number(value: Any, where: str) -> float:
    if value is None:
        raise MapError(Message("{key} is missing", key=where))
    if not isinstance(value, str) or not is_number(value) or not abs(float(value)) <= 1e300:
        shown = f"{value[:40]!r}" if isinstance(value, str) else Message("a list or a mapping")
        raise MapError(Message("{where}: {shown} instead of a number", where=where, shown=shown))
    return float(value)


def _origin(value: Any) -> Pose:
    if isinstance(value, str) and value.startswith("["):
        value = value.strip("[] ").split(",")  # in quotes as a whole
    if not isinstance(value, list) or len(value) != 3:
        shown = str(value)[:60] if value is not None else Message("nothing")
        raise MapError(Message("origin: {shown} instead of [x, y, yaw]", shown=shown))
    return Pose(*(_number(part, f"origin[{n}]") for n, part in enumerate(value)))


def _from_yaml(path: Path, added: bool) -> OccupancyGrid:
    table = _table(path)
    origin = _origin(table.get("origin"))
    resolution = _number(table.get("resolution"), "resolution")
    # Before the image: an error in the small file should not cost the reading of the large one.
    check_frame(MapFrame(resolution, 1, 1))
    classes = _classes(_image_path(path, table["image"]), _reading(table))
    height, width = classes.shape
    frame = MapFrame(resolution, width, height, origin, added)
    check_frame(frame)
    return build_grid(frame, classes)


def _image_path(path: Path, image: str) -> Path:
    """Return where the image of a YAML file is: beside it, unless its path is a whole one."""
    image = image.removeprefix("file://")
    if image.startswith("package://"):
        raise MapError(
            Message("image {image}: packages are known to ROS alone: give the path of the file", image=image)
        )
    if image.startswith("~/"):
        return Path.home() / image[2:]
    if "\0" in image:
        raise MapError(Message("no image {path}", path=image))
    is_there = "\\" not in image
    with suppress(OSError):  # a name that is too long
        is_there = is_there or (path.parent / image).is_file()
    # Written on Windows, unless a file is called so.
    return path.parent / (image if is_there else image.replace("\\", "/"))


class _PlainTexts(yaml.BaseLoader):
    """Leaves each value as it is written, since YAML 1.1 reads numbers that map_server does not. Rejects
    aliases: a few lines can expand to more than fits into memory."""

    def compose_node(self, parent: Any, index: Any) -> Any:
        """Compose anything else."""
        if self.check_event(yaml.AliasEvent):
            raise yaml.YAMLError("aliases not supported")
        return super().compose_node(parent, index)


def _table(path: Path) -> dict[str, Any]:
    try:
        table = yaml.load(read_text(path, MAX_YAML), _PlainTexts)
    except FileNotFoundError:
        raise MapError(Message("no such file")) from None
    except UnicodeDecodeError:
        raise MapError(Message("unreadable: not text in UTF-8")) from None
    except yaml.MarkedYAMLError as problem:
        line = Message(" in line {line}", line=problem.problem_mark.line + 1) if problem.problem_mark else ""
        raise MapError(
            Message("unreadable: not YAML: {problem}{line}", problem=problem.problem, line=line)
        ) from None
    except yaml.YAMLError as problem:
        reason = "control characters" if isinstance(problem, ReaderError) else str(problem)
        raise MapError(Message("unreadable: not YAML: {reason}", reason=reason)) from None
    except OSError as problem:
        raise MapError(_reason(problem)) from None
    except RecursionError:
        raise MapError(Message("unreadable: nested too deep")) from None
    except (ValueError, LookupError, AttributeError, ArithmeticError) as problem:
        raise MapError(Message("unreadable: {problem}", problem=" ".join(str(problem).split()))) from None
    if not isinstance(table, dict) or not isinstance(table.get("image"), str):
        raise MapError(Message("not a map_server file: no image"))
    return table


def _reason(problem: OSError) -> Message:
    if isinstance(problem, IsADirectoryError):
        return Message("unreadable: a folder: name a file")
    return Message("unreadable: {strerror}", strerror=problem.strerror or problem)


def _reading(table: dict[str, Any]) -> OccupancyThresholds:
    usual = OccupancyThresholds()
    mode, negate = str(table.get("mode", usual.mode)).lower(), str(table.get("negate", 0)).lower()
    if mode not in MODES:
        raise MapError(
            Message("mode {mode} is not one of {modes}", mode=f"{mode[:20]!r}", modes=", ".join(MODES))
        )
    if negate not in _FLAGS:
        raise MapError(Message("negate: {negate} instead of 0 or 1", negate=f"{negate[:20]!r}"))
    occupied = _number(table.get("occupied_thresh", str(usual.occupied_above)), "occupied_thresh")
    free = _number(table.get("free_thresh", str(usual.free_below)), "free_thresh")
    return OccupancyThresholds(mode, _FLAGS[negate], occupied, free)


def _classes(path: Path, reading: OccupancyThresholds) -> Classes:
    """Return an image file as classes, uint8 of shape (height, width)."""
    try:
        with open_file(path) as file:
            return classes_of(file, path.name, reading)
    except FileNotFoundError:
        raise MapError(Message("no image {path}", path=path)) from None
    except OSError as problem:
        raise MapError(Message("{name} {reason}", name=path.name, reason=_reason(problem))) from None


def classes_of(file: IO[bytes], name: str, reading: OccupancyThresholds) -> Classes:
    """Return an open image as classes, uint8 of shape (height, width). Raises MapError and OSError."""
    try:
        with warnings.catch_warnings():
            # Pillow's own limit is lower than ours and warns on stderr, which would garble the screen.
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            with Image.open(file, formats=FORMATS) as image:
                if image.width * image.height > MAX_PIXELS:
                    raise MapError(
                        Message(
                            "{width} x {height} px exceeds {max_pixels} px",
                            width=image.width,
                            height=image.height,
                            max_pixels=f"{MAX_PIXELS:,}",
                        )
                    )
                return _classified(image, reading)
    except UnidentifiedImageError:
        raise MapError(
            Message("{name} is not a supported image: {formats}", name=name, formats=", ".join(FORMATS))
        ) from None
    except Image.DecompressionBombError:
        raise MapError(
            Message("{name} exceeds {max_pixels} px", name=name, max_pixels=f"{MAX_PIXELS:,}")
        ) from None
    except (ValueError, SyntaxError, MemoryError) as problem:
        raise MapError(Message("{name} unreadable: {problem}", name=name, problem=problem)) from None


def _classified(image: Image.Image, reading: OccupancyThresholds) -> Classes:
    classes = np.empty((image.height, image.width), np.uint8)
    mode = _channels(image)
    for top in range(0, image.height, _BAND):
        band = image.crop((0, top, image.width, min(top + _BAND, image.height)))
        cells = np.asarray(band if mode.startswith("I") else band.convert(mode))
        classes[top : top + _BAND] = _band_classes(cells, reading)
    return classes


def _channels(image: Image.Image) -> str:
    """Return Pillow's name for the relevant channels of an image: grey, deep grey, colour, with alpha."""
    if image.mode.startswith("I"):
        return image.mode
    if "A" in image.mode or "a" in image.mode or "transparency" in image.info:
        return "RGBA"
    return "L" if image.mode in ("1", "L") else "RGB"


def _band_classes(cells: NDArray[Any], reading: OccupancyThresholds) -> Classes:
    """Return rows of pixels, 8 bits or (without channels) 16, as classes.

    map_server averages the channels, in trinary mode the alpha among them; in scale mode non-opaque pixels
    are unknown.
    """
    if cells.ndim == 2:
        top = 255 if cells.dtype == np.uint8 else 65535
        grey: Classes = _table_of(top, reading)[np.clip(cells, 0, top)]
        return grey
    colours = cells if reading.mode == "trinary" else cells[..., :3]
    sums = colours.sum(axis=2, dtype=np.uint16)
    classes: Classes = _table_of(255 * colours.shape[2], reading)[sums]
    if reading.mode == "scale" and cells.shape[2] == 4:
        classes[cells[..., 3] < 255] = UNKNOWN
    return classes


@lru_cache(8)
def _table_of(top: int, reading: OccupancyThresholds) -> Classes:
    """Return the class of every brightness from 0 to `top`."""
    bright = np.arange(top + 1)
    if reading.mode == "raw":
        percent = np.rint(bright / top * 255)
        return np.where(percent <= 100, CLASS_OF_CELL[percent.astype(np.uint8)], UNKNOWN).astype(np.uint8)
    dark = (bright if reading.negate else top - bright) / top
    between = np.full(top + 1, UNKNOWN, np.uint8)
    if reading.mode == "scale":
        # Values between the thresholds are percentages, classified like those of the live map.
        span = max(reading.occupied_above - reading.free_below, 1e-9)
        percent = np.rint((dark - reading.free_below) / span * 100)
        between = CLASS_OF_CELL[np.clip(percent, 0, 100).astype(np.uint8)]
    known = np.where(dark < reading.free_below, FREE, between)
    return np.where(dark > reading.occupied_above, OCCUPIED, known).astype(np.uint8)
