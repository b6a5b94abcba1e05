"""A simulated hospital with fleets of Open-RMF behind a bridge, and the console's configuration for it."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from fleet_tui.config.schema import Config
from fleet_tui.console.demo import demo_config
from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.model.order import at_vertices
from fleet_tui.simulator.rmf.fleet import RmfFleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.watched_store import WatchedStore

LONG_AGO = 10.0
"""Seconds: such a bridge has discovered every publisher."""
SPEED = 20.0
FIRST, SECOND = "tiny/robot_0", "carrier/robot_1"


class Hospital:
    """A running server, its fleets, and the configuration that points at it."""

    def __init__(self, fleet: RmfFleet, server: RosbridgeServer, config: Config) -> None:
        self.fleet, self.server, self.config = fleet, server, config

    def sent(self) -> list[dict[str, object]]:
        """The requests that arrived."""
        return self.fleet.dispatcher.requests

    def frames(self, op: str) -> list[dict[str, object]]:
        """The operations of clients on the topic of requests, as they came over the wire."""
        received = self.server.bridge.received
        return [one for one in received if one["op"] == op and one.get("topic") == "/task_api_requests"]


@asynccontextmanager
async def hospital(
    robots: int = 2, floors: int = 1, speed: float = SPEED, rate: float = 50.0, period: float = 0.05
) -> AsyncIterator[Hospital]:
    """Run a quiet hospital."""
    fleet = RmfFleet(robots, floors, seed=1, quiet=True, period=period)
    server = RosbridgeServer(fleet, rate=rate, speed=speed, dialect=ROS2)
    await server.start()
    server.bridge.started -= LONG_AGO
    try:
        yield Hospital(fleet, server, demo_config(Config(), server.url, robots, floors, "2", "rmf"))
    finally:
        await server.stop()


def to(*places: str, robot: str = FIRST, to_any: bool = False) -> PlaceOrder:
    """An order to these places."""
    return PlaceOrder(robot, at_vertices(*places), to_any)


def rmf_ready(state: FleetState) -> bool:
    """Poses and graphs have come, and commands get through."""
    robots = state.robots.values()
    known = all(robot.pose and robot.knows_all_graphs() for robot in robots)
    return known and all(link.command_path is CommandPath.ALIVE for link in state.links.values())


async def stands_at(store: WatchedStore, id_: int, *stages: Stage) -> CommandRecord:
    """Wait until a command has reached one of these stages."""
    state = await store.until(
        lambda state: any(one.id == id_ and one.stage in stages for one in state.commands)
    )
    return next(one for one in state.commands if one.id == id_)
