"""Large maps as JSON, from a bridge that knows no CBOR: decoded apart, right to the cell."""

import json
import time
from collections.abc import AsyncIterator

import numpy as np
import pytest

from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.robots.ros.operations import topic_of
from fleet_tui.robots.ros.reading import WORTH_A_PROCESS
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.watched_store import WatchedStore, config_of

WIDTH, HEIGHT = 1500, 1300
POSE = {"position": {"x": 1.0, "y": 2.0, "z": 0.0}, "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}}
INFO = {"resolution": 0.05, "width": WIDTH, "height": HEIGHT, "origin": POSE}


def cells() -> list[int]:
    """Free with one wall along the lower edge and unknown in the last row."""
    return [100] * WIDTH + [0] * (WIDTH * (HEIGHT - 2)) + [-1] * WIDTH


def frame(**changes: object) -> bytes:
    msg = {"info": INFO, "data": cells(), **changes}
    return json.dumps({"op": "publish", "topic": "/robot_0/floor_0/map", "msg": msg}).encode()


@pytest.fixture
async def store(server: RosbridgeServer) -> AsyncIterator[WatchedStore]:
    config = config_of(server.url, 1)
    store = WatchedStore(initial_state(config, time.monotonic()))
    link = FleetLink(config, store)
    link.open()
    await store.until(lambda state: state.robots["robot_0"].pose)
    link.show_map("robot_0", "floor_0")
    await store.until(lambda state: state.robots["robot_0"].maps["floor_0"].grid)
    yield store
    link.close()


async def test_a_large_json_map_arrives(server: RosbridgeServer, store: WatchedStore) -> None:
    text = frame().decode()
    assert len(text) > WORTH_A_PROCESS
    server.bridge.publish_raw("/robot_0/floor_0/map", text)

    def has_come(_: object) -> bool:
        grid = store.state.robots["robot_0"].maps["floor_0"].grid
        return grid is not None and grid.frame.width == WIDTH

    await store.until(has_come)
    grid = store.state.robots["robot_0"].maps["floor_0"].grid
    assert grid is not None
    level = grid.levels[0]
    assert (level[0] == 0).all()
    assert (level[1:-1] == 1).all()
    assert (level[-1] == 2).all()
    assert np.shape(level) == (HEIGHT, WIDTH)


async def test_a_large_map_whose_size_lies_is_named(server: RosbridgeServer, store: WatchedStore) -> None:
    server.bridge.publish_raw("/robot_0/floor_0/map", frame(info={**INFO, "height": 7}).decode())
    state = await store.until(lambda state: state.robots["robot_0"].faults)
    assert "1500 x 7 px has" in state.robots["robot_0"].last_fault


@pytest.mark.parametrize(
    ("text", "topic"),
    [
        (b'{"op":"publish","topic":"\\/a\\/b","msg":{', "/a/b"),
        (b'{"topic" : "/a", "op":"publish"}', "/a"),
        (b"{}", ""),
        (b'{"topic":"\\q"}', ""),
        (b"\xff\xfe" * 600 + b'"topic":"/a"', ""),
    ],
)
def test_the_topic_is_found_without_decoding(text: bytes, topic: str) -> None:
    assert topic_of(text) == topic


async def test_what_comes_faster_than_it_can_be_read_is_passed_over_and_that_is_said(
    server: RosbridgeServer, store: WatchedStore, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fleet_tui.links.rosbridge.telemetry.MOST_WAITING", 0)
    text = frame().decode()
    for _ in range(3):
        server.bridge.publish_raw("/robot_0/floor_0/map", text)
    state = await store.until(lambda state: state.links["rosbridge"].faults >= 2)
    size = f"{len(text) / 1e6:.0f} MB"
    assert state.links["rosbridge"].last_fault.endswith(f"dropped: {size} still being decoded")

    def shows(width: int, resolution: float) -> bool:
        grid = store.state.robots["robot_0"].maps["floor_0"].grid
        return grid is not None and (grid.frame.width, grid.frame.resolution) == (width, resolution)

    await store.until(lambda _: shows(WIDTH, 0.05))
    server.bridge.publish_raw("/robot_0/floor_0/map", frame(info={**INFO, "resolution": 0.1}).decode())
    await store.until(lambda _: shows(WIDTH, 0.1))
