"""Two quiet simulated robots with move_base behind a bridge of ROS 1, and the console's configuration."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.order import at_vertices
from fleet_tui.robots.profile import Profile
from fleet_tui.simulator.graph_files import write_graphs
from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.move_base.navigation import SimMoveBase
from fleet_tui.simulator.ros import actionlib
from fleet_tui.simulator.server import RosbridgeServer

SPEED = 20.0


class MoveBaseSite:
    """A running server, its fleet, and the configuration that points at it."""

    def __init__(self, fleet: MoveBaseFleet, server: RosbridgeServer, config: Config) -> None:
        self.fleet, self.server, self.config = fleet, server, config

    def navigation(self, robot: str = "robot_0") -> SimMoveBase:
        """The move_base of a robot."""
        return self.fleet.navigation[robot]

    def to(self, *labels: str, robot: str = "robot_0") -> PlaceOrder:
        """An order to these places."""
        names = self.fleet.building.floors[0].labels
        return PlaceOrder(
            robot, at_vertices(*[str(next(id_ for id_ in names if names[id_] == label)) for label in labels])
        )

    def published(self, end: str) -> list[dict[str, Any]]:
        """The messages that arrived on topics with this end."""
        return [
            dict(one["msg"])
            for one in self.server.bridge.received
            if one["op"] == "publish" and str(one["topic"]).endswith(end)
        ]

    def advertised(self) -> list[str]:
        """The topics that were advertised."""
        return [str(one["topic"]) for one in self.server.bridge.received if one["op"] == "advertise"]


@asynccontextmanager
async def move_base_site(folder: Path, robots: int = 2, speed: float = SPEED) -> AsyncIterator[MoveBaseSite]:
    """Run a site; the graph file is in the folder."""
    fleet = MoveBaseFleet(robots, 1, seed=1, quiet=True)
    for navigation in fleet.navigation.values():
        # As long as for a console whose time does not run faster.
        navigation.server.kept = actionlib.KEPT * speed
    server = RosbridgeServer(fleet, rate=50.0, speed=speed)
    await server.start()
    (graph,) = write_graphs(folder / "graph.geojson", 1)
    config = Config(
        rosbridge=Link(server.url),
        floors=[FloorEntry("floor_0", graph=str(graph))],
        robots=[RobotEntry(name) for name in fleet.robots],
        profile=Profile(kind="move_base"),
    )
    try:
        yield MoveBaseSite(fleet, server, config)
    finally:
        await server.stop()
