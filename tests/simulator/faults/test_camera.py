"""Faults of cameras: half pictures, enormous ones, and none any more."""

import io
from collections.abc import Mapping
from typing import Any

import pytest
from PIL import Image

from fleet_tui.simulator.faults import camera
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.senses.camera import NAME
from fleet_tui.simulator.server import RosbridgeServer

TOPIC = f"/robot_0/{NAME}"


def planted(fault: str, world: OhFleet | MoveBaseFleet | None = None) -> RosbridgeServer:
    server = RosbridgeServer(world or OhFleet(1, 1, seed=1, quiet=True))
    play(server, [(fault, "robot_0")])
    return server


def picture(server: RosbridgeServer) -> bytes:
    msg: Mapping[str, Any] = server.bridge.topics[TOPIC].payload(7.0).msg
    data = msg["data"]
    assert isinstance(data, bytes)
    return data


def test_a_truncated_picture_does_not_load() -> None:
    half = Image.open(io.BytesIO(picture(planted("camera-truncated", MoveBaseFleet(1, 1, seed=1)))))
    with pytest.raises(OSError, match="truncated"):
        half.load()


def test_a_huge_picture_is_a_small_file() -> None:
    data = picture(planted("camera-huge"))
    assert len(data) < 200
    with pytest.raises(Image.DecompressionBombError):
        Image.open(io.BytesIO(data))


def test_a_camera_that_stops_is_silent_after_a_while() -> None:
    server = planted("camera-stops")
    trouble = server.bridge.services.fleet_of("robot_0").troubles[-1]
    trouble(camera.STOPS)
    assert TOPIC not in server.bridge.muted
    trouble(0.1)
    assert TOPIC in server.bridge.muted
