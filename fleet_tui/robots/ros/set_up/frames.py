"""Static transforms (tf2_msgs/TFMessage) as fixed frames of a robot."""

import math
from typing import Any

import msgspec

from fleet_tui.model.set_up.frames import Frames, Transform
from fleet_tui.robots.parts import read_all
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.facts import FARTHEST
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import LONGEST_NAME, MOST_FRAMES, truncate

UNIT = 0.1
"""Deviation of a quaternion from unit length above which it is no rotation."""


class _Moved(msgspec.Struct, frozen=True):
    translation: ros.Point
    rotation: ros.Quaternion


class TransformStamped(msgspec.Struct, frozen=True):
    """geometry_msgs/TransformStamped."""

    header: ros.Header
    child_frame_id: str
    transform: _Moved


class _TransformsMessage(msgspec.Struct, frozen=True):
    """tf2_msgs/TFMessage."""

    transforms: list[Any]


_read = ros.reader(_TransformsMessage)
_read_one = ros.reader(TransformStamped)


def read_transforms(msg: object) -> list[TransformStamped]:
    """Read the transforms of a message. Raises WireError if none can be read."""
    faults = list[str]()
    parts: list[TransformStamped] = read_all(
        _read_one, _read(msg).transforms, Message("transforms"), MOST_FRAMES, faults
    )
    if faults and not parts:
        raise WireError(faults[0])
    return parts


def read_frames(msg: object) -> Frames:
    """Read static transforms, each by the name of its frame. Raises WireError if none can be read."""
    parts = read_transforms(msg)
    return {_name(one.child_frame_id): moved for one in parts if (moved := _transform(one)) is not None}


def _transform(one: TransformStamped) -> Transform | None:
    at, turn = one.transform.translation, one.transform.rotation
    place, rotation = (at.x, at.y, at.z), (turn.x, turn.y, turn.z, turn.w)
    length = math.hypot(*rotation)
    if not all(abs(value) <= FARTHEST for value in place) or not abs(length - 1.0) <= UNIT:
        return None
    x, y, z, w = (value / length for value in rotation)
    return Transform(_name(one.header.frame_id), place, (x, y, z, w))


def _name(frame: str) -> str:
    return truncate(frame.lstrip("/"), LONGEST_NAME)
