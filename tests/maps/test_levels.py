"""Levels of a building: pictures in the place that the message says, bad ones refused with their level."""

import base64
import io
import math
from typing import Any

import msgspec
import pytest
from PIL import Image

from fleet_tui.maps.levels import read_levels
from fleet_tui.model.geometry import Pose
from fleet_tui.text.errors import WireError


def picture(width: int = 4, height: int = 2) -> bytes:
    file = io.BytesIO()
    Image.new("L", (width, height), 255).save(file, "PNG")
    return file.getvalue()


def level(name: str = "L1", data: bytes | None = None, **more: float) -> dict[str, Any]:
    placed = {"x_offset": 1.0, "y_offset": 10.0, "yaw": 0.0, "scale": 0.5, **more}
    image = {
        "name": "plan",
        "encoding": "png",
        "data": base64.b64encode(data or picture()).decode(),
        **placed,
    }
    return {"name": name, "elevation": 0.0, "images": [image]}


def read(*levels: dict[str, Any]) -> list[Any]:
    return list(read_levels(msgspec.Raw(msgspec.json.encode({"name": "b", "levels": levels})), 5.0))


def test_the_upper_left_corner_is_placed_and_turned() -> None:
    (one,) = read(level())
    assert (one.robot, one.floor, one.at) == ("", "L1", 5.0)
    assert one.grid.frame.origin == Pose(1.0, 9.0) and one.grid.frame.resolution == 0.5
    (turned,) = read(level(yaw=math.pi / 2))
    assert (turned.grid.frame.origin.x, turned.grid.frame.origin.y) == pytest.approx((2.0, 10.0))


def test_a_level_without_a_picture_has_no_map() -> None:
    assert [one.floor for one in read(level("L1"), {"name": "L2", "images": []}, level("L3"))] == ["L1", "L3"]


@pytest.mark.parametrize(
    ("bad", "problem"),
    [
        (level(data=b"no picture"), "level L1: plan is not a supported image"),
        (level(data=picture()[:40]), "level L1: "),
        (level(scale=0.0), "level L1: "),
        (level(x_offset=1e99), "level L1: image is not a finite number"),
        ({"images": []}, "name"),
    ],
)
def test_a_bad_one_is_refused_with_its_level(bad: dict[str, Any], problem: str) -> None:
    with pytest.raises(WireError, match=problem):
        read(bad)
