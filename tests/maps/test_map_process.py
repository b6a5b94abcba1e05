"""Maps that are decoded in a process of their own."""

import json

import pytest

from fleet_tui.maps.map_process import decode_apart
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN
from fleet_tui.robots.adapter import Feed
from fleet_tui.robots.profile import Profile
from fleet_tui.text.errors import WireError

POSE = {"position": {"x": 1.0, "y": 2.0, "z": 0.0}, "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}}
INFO = {"resolution": 0.05, "width": 3, "height": 2, "origin": POSE}


def frame(**changes: object) -> bytes:
    msg = {"info": INFO, "data": [100, 0, 0, -1, -1, 0], **changes}
    return json.dumps({"op": "publish", "topic": "/robot_0/floor_0/map", "msg": msg}).encode()


MAP = Feed("map", ("robot_0",), "floor_0", "/robot_0/floor_0/map", "nav_msgs/OccupancyGrid")


def test_what_is_no_map_is_named() -> None:
    with pytest.raises(WireError, match="info"):
        decode_apart(Profile(), MAP, frame(info=None))
    with pytest.raises(WireError, match="bytes"):
        decode_apart(Profile(), MAP, b'{"op":')


def test_a_map_comes_back_as_it_is_read_here() -> None:
    found = decode_apart(Profile(), MAP, frame())
    assert (found.robot, found.floor) == ("robot_0", "floor_0")
    assert found.grid.frame == MapFrame(0.05, 3, 2, Pose(1.0, 2.0))
    assert found.grid.levels[0].tolist() == [[UNKNOWN, UNKNOWN, FREE], [OCCUPIED, FREE, FREE]], (
        "top row first"
    )
