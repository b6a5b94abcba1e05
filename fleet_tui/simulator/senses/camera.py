"""The camera of a simulated robot: a view along the walls of the floor's own plan."""

import io
import math

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.floorplan import RESOLUTION, Cells
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Message, Topic, headers
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.senses.laser import Surveyor, cells_along

TYPE = "sensor_msgs/CompressedImage"
NAME = "camera/image_raw/compressed"
FORMAT = "bgr8; jpeg compressed bgr8"
SIZE = 320, 240
WIDE = math.radians(70.0)
# metres
NEAREST = 0.1
FARTHEST = 20.0
TALL = 1.1  # metres from the camera's height to the top, and to the bottom, of a wall
PANEL = 20  # cells of a wall in one shade

CEILING = np.array([190.0, 196.0, 205.0])
GROUND = np.array([122.0, 108.0, 92.0])
SHADES = np.array([[205.0, 120.0, 70.0], [90.0, 135.0, 180.0]])
"""Colours of the panels of walls, by turns."""

Pixels = NDArray[np.uint8]
_STEPS = np.arange(NEAREST, FARTHEST, RESOLUTION)


def view(cells: Cells, pose: Pose, size: tuple[int, int] = SIZE) -> Pixels:
    """Return the view from a pose, of shape (height, width, 3)."""
    width, height = size
    offsets = np.linspace(WIDE / 2, -WIDE / 2, width)
    metres, shades = _walls(cells, pose, offsets + pose.yaw)
    half = height / 2.0 * TALL / np.maximum(metres * np.cos(offsets), 0.2)
    lines = (np.arange(height) + 0.5 - height / 2.0)[:, np.newaxis]
    depth = np.abs(lines) / (height / 2.0)
    seen = np.where((lines < 0)[..., np.newaxis], CEILING, GROUND) * (0.45 + 0.55 * depth[..., np.newaxis])
    seen = np.broadcast_to(seen, (height, width, 3))
    walls = shades * (1.0 / (1.0 + 0.12 * metres))[:, np.newaxis]
    is_wall = (np.abs(lines) < half) & (metres < FARTHEST)
    return np.where(is_wall[..., np.newaxis], walls, seen).astype(np.uint8)


def _walls(
    cells: Cells, pose: Pose, angles: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the metres to the wall at each angle, FARTHEST without one, and its colour."""
    rows, columns, hits = cells_along(cells, pose, angles, _STEPS)
    first = hits.argmax(axis=1)
    beams = np.arange(len(angles))
    metres = np.where(hits.any(axis=1), _STEPS[first], FARTHEST)
    return metres, SHADES[(rows[beams, first] // PANEL + columns[beams, first] // PANEL) % 2]


def jpeg(pixels: Pixels) -> bytes:
    """Return pixels as a JPEG file."""
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=80)
    return file.getvalue()


def message(header: Message, data: bytes, format_: str = FORMAT) -> Payload:
    """sensor_msgs/CompressedImage."""
    return Payload({"header": header, "format": format_, "data": data})


def camera_topic(robot: Surveyor, dialect: Dialect) -> Topic:
    """The pictures of a robot, two a second, from its true pose."""
    header = headers(dialect, f"{robot.name}/camera")

    def payload(now: float) -> Payload:
        return message(header(now), jpeg(view(robot.floor.cells, robot.pose)))

    return Topic(f"/{robot.name}/{NAME}", dialect.message_type(TYPE), payload, robot)
