"""Levels of a building from the bridge: a picture each, with its place in the world."""

import io
from collections.abc import Sequence

import msgspec

from fleet_tui.model.events import GridReceived
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import check_frame
from fleet_tui.robots.ros.facts import check_finite
from fleet_tui.text.errors import MapError, WireError
from fleet_tui.text.language import Message

MOST_LEVELS = 50


class ImageMessage(msgspec.Struct, frozen=True):
    """rmf_building_map_msgs/AffineImage: metres and radians of the upper left corner, metres per pixel."""

    x_offset: float
    y_offset: float
    yaw: float
    scale: float
    data: bytes
    name: str = ""


class LevelMessage(msgspec.Struct, frozen=True):
    """rmf_building_map_msgs/Level."""

    name: str
    images: list[ImageMessage] = []


class BuildingMessage(msgspec.Struct, frozen=True):
    """rmf_building_map_msgs/BuildingMap."""

    levels: list[LevelMessage]


_decode = msgspec.json.Decoder(BuildingMessage).decode


def read_levels(msg: object, at: float) -> Sequence[GridReceived]:
    """Return the first picture of each level of a rmf_building_map_msgs/BuildingMap. Raises WireError."""
    try:
        building = _decode(msg) if isinstance(msg, msgspec.Raw) else msgspec.convert(msg, BuildingMessage)
    except (msgspec.MsgspecError, RecursionError) as problem:
        raise WireError(str(problem)) from None
    levels = (level for level in building.levels[:MOST_LEVELS] if level.images)
    return [_grid(level.name, level.images[0], at) for level in levels]


def _grid(level: str, image: ImageMessage, at: float) -> GridReceived:
    # With numpy and Pillow, whose import takes longer than a whole command without a screen.
    from fleet_tui.maps.images import OccupancyThresholds, classes_of
    from fleet_tui.model.occupancy import build_grid

    check_finite(
        image.x_offset,
        image.y_offset,
        image.yaw,
        image.scale,
        field=Message("level {level}: image", level=level[:40]),
    )
    try:
        classes = classes_of(io.BytesIO(image.data), image.name or "image", OccupancyThresholds())
        height, width = classes.shape
        # A frame has the lower left corner.
        corner = Pose(image.x_offset, image.y_offset, image.yaw).after(Pose(0.0, -height * image.scale))
        frame = MapFrame(image.scale, width, height, corner)
        check_frame(frame)
        return GridReceived("", level, build_grid(frame, classes), at)
    except (MapError, OSError) as problem:
        raise WireError(f"level {level[:40]}: {problem}") from None
