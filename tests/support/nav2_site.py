"""Two quiet simulated robots with Nav2 behind a bridge of ROS 2, and the console's configuration for them."""

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path

from fleet_tui.config.schema import Config
from fleet_tui.console.demo import demo_config
from fleet_tui.links.queue_file import QueueFile
from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.model.order import at_vertices
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.nav2.navigation import SimNavigation
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.watched_store import WatchedStore

LONG_AGO = 10.0
"""Seconds: such a bridge has discovered every publisher."""
SPEED = 20.0

Holds = Callable[[FleetState], object]


class Site:
    """A running server, its fleet, and the configuration that points at it."""

    def __init__(self, fleet: Nav2Fleet, server: RosbridgeServer, config: Config) -> None:
        self.fleet, self.server, self.config = fleet, server, config

    def navigation(self, robot: str = "robot_0") -> SimNavigation:
        """The action servers of a robot."""
        return self.fleet.navigation[robot]

    def vertex(self, label: str) -> str:
        """The id of a vertex in the graph file."""
        found = [id_ for id_, name in self.fleet.building.floors[0].labels.items() if name == label]
        return str(found[0])

    def to(self, *labels: str, robot: str = "robot_0") -> PlaceOrder:
        """An order to these places."""
        return PlaceOrder(robot, at_vertices(*[self.vertex(label) for label in labels]))

    @asynccontextmanager
    async def started_again(self) -> AsyncIterator[None]:
        """A new bridge of the same robots at the port of the stopped one."""
        port = int(self.server.url.rpartition(":")[2])
        dialect = self.server.bridge.dialect
        again = RosbridgeServer(self.fleet, rate=50.0, speed=SPEED, dialect=dialect, port=port)
        await again.start()
        try:
            yield
        finally:
            await again.stop()

    def cancels(self) -> list[tuple[str, object]]:
        """The cancellations that arrived: the action and the id."""
        return [
            (service.removesuffix("/_action/cancel_goal"), args["goal_info"]["goal_id"]["uuid"])
            for service, args in self.server.bridge.services.calls
            if service.endswith("cancel_goal")
        ]


@asynccontextmanager
async def nav2_site(
    folder: Path, robots: int = 2, floors: int = 1, speed: float = SPEED, rate: float = 50.0
) -> AsyncIterator[Site]:
    """Run a site; the graph files are in the folder."""
    fleet = Nav2Fleet(robots, floors, seed=1, quiet=True)
    server = RosbridgeServer(fleet, rate=rate, speed=speed, dialect=ROS2)
    await server.start()
    server.bridge.started -= LONG_AGO
    try:
        yield Site(fleet, server, demo_config(Config(), server.url, robots, floors, "2", "nav2", folder))
    finally:
        await server.stop()


def keeping(folder: Path | None = None, name: str = "ana") -> QueueFile:
    """The folder in which a console keeps orders."""
    return QueueFile(folder, name)


def nav2_ready(state: FleetState) -> bool:
    """Poses and graphs have come, and commands get through."""
    robots = state.robots.values()
    known = all(robot.pose and robot.knows_all_graphs() for robot in robots)
    return known and all(link.command_path is CommandPath.ALIVE for link in state.links.values())


def placed(state: FleetState) -> list[CommandRecord]:
    """The orders that were given here, oldest first."""
    return [one for one in state.commands if isinstance(one.command, PlaceOrder)]


def record_of(state: FleetState, id_: object) -> CommandRecord:
    """The record of a command."""
    return next(one for one in state.commands if one.id == id_)


def stands(id_: object, *stages: Stage) -> Holds:
    """A command stands at one of these stages."""
    return lambda state: any(one.id == id_ and one.stage in stages for one in state.commands)


async def reached(store: WatchedStore, id_: object, *stages: Stage) -> CommandRecord:
    """Wait until a command stands at one of these stages."""
    return record_of(await store.until(stands(id_, *stages)), id_)
