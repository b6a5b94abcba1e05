"""Static transforms from the wire, and hostile ones."""

import json
import math
from typing import Any

import msgspec
import pytest

from fleet_tui.model.set_up.frames import Transform
from fleet_tui.robots.ros.set_up.frames import read_frames
from fleet_tui.text.errors import WireError
from fleet_tui.text.limits import MOST_FRAMES

NO_TURN = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}


def transform(child: str = "/laser", x: Any = 0.5, turn: Any = NO_TURN) -> dict[str, Any]:
    moved = {"translation": {"x": x, "y": 0.0, "z": 0.1}, "rotation": turn}
    return {"header": {"frame_id": "/base_link"}, "child_frame_id": child, "transform": moved}


def read(*transforms: object) -> object:
    return read_frames(msgspec.Raw(json.dumps({"transforms": transforms}).encode()))


def test_each_frame_has_its_parent() -> None:
    wanted = Transform("base_link", (0.5, 0.0, 0.1), (0.0, 0.0, 0.0, 1.0))
    assert read(transform()) == {"laser": wanted}


@pytest.mark.parametrize(
    "bad", [transform(x=1e300), transform(turn={**NO_TURN, "w": 0.0}), transform(turn={**NO_TURN, "w": 9.0})]
)
def test_what_is_no_transform_is_left_out(bad: dict[str, Any]) -> None:
    assert read(bad, transform("mast")) == read(transform("mast"))
    assert read(bad) == {}


def test_a_bad_one_does_not_cost_the_others() -> None:
    assert read({"child_frame_id": 7}, transform()) == read(transform())
    with pytest.raises(WireError, match=r"transforms\[0\]"):
        read({"child_frame_id": 7})
    with pytest.raises(WireError):
        read_frames(msgspec.Raw(b'{"transforms": 3}'))


def test_their_number_is_limited() -> None:
    found = read(*(transform(f"f{n}") for n in range(MOST_FRAMES + 5)))
    assert isinstance(found, dict) and len(found) == MOST_FRAMES


def test_a_rotation_is_made_one_of_unit_length() -> None:
    found = read_frames({"transforms": [transform(turn={**NO_TURN, "w": 1.05})]})
    assert math.isclose(math.hypot(*found["laser"].turn), 1.0)
