"""Robots that publish no graph: what the map shows of a graph from a file."""

from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.robots.profile import Profile
from fleet_tui.simulator.graph_files import write_graphs
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console


@pytest.fixture
async def nav2() -> AsyncIterator[RosbridgeServer]:
    running = RosbridgeServer(Nav2Fleet(1, 1, seed=1, quiet=True), dialect=ROS2)
    await running.start()
    yield running
    await running.stop()


def config_with(url: str, graph: Path) -> Config:
    floors, robots = [FloorEntry("floor_0", graph=str(graph))], [RobotEntry("robot_0")]
    return Config(rosbridge=Link(url), floors=floors, robots=robots, profile=Profile(kind="nav2"))


async def test_its_labels_are_on_the_map(nav2: RosbridgeServer, tmp_path: Path) -> None:
    (file,) = write_graphs(tmp_path / "routes.geojson", 1)
    async with console(config_with(nav2.url, file)) as it:
        await it.shows("Consumidores")


async def test_one_that_cannot_be_read_is_named(nav2: RosbridgeServer, tmp_path: Path) -> None:
    (tmp_path / "routes.geojson").write_text("{}")
    async with console(config_with(nav2.url, tmp_path / "routes.geojson"), wait=False) as it:
        await it.shows("graph routes.geojson: no known format")
