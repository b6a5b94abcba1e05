"""One robot of each kind at one site, behind a bridge of ROS 1 and two of ROS 2, and the configuration."""

from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, asynccontextmanager
from pathlib import Path

from fleet_tui.config.schema import Config
from fleet_tui.console.demo import demo_config
from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.rmf.fleet import RmfFleet
from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.simulator.site import MIXED

OH, MOVE_BASE, NAV2, RMF = "robot_0", "robot_1", "robot_2", "tiny/robot_3"
"""The robots, each of the kind that its constant is named after."""


class MixedSite:
    """The running servers, the fleets that navigate, and the configuration that points at all."""

    def __init__(self, servers: list[RosbridgeServer], fleets: list[Fleet], config: Config) -> None:
        self.servers, self.config = servers, config
        _, self.move_base, self.nav2, _ = fleets


@asynccontextmanager
async def mixed_site(folder: Path) -> AsyncIterator[MixedSite]:
    """Run a site; the graph file is in the folder."""
    fleets: list[Fleet] = [
        OhFleet(1, 1, seed=1, quiet=True),
        MoveBaseFleet(1, 1, seed=1, quiet=True, first=1),
        Nav2Fleet(1, 1, seed=1, quiet=True, first=2),
        RmfFleet(1, 1, seed=1, quiet=True, first=3, period=0.1),
    ]
    servers = [
        RosbridgeServer(fleets[:2], rate=20.0, dialect=ROS1),
        RosbridgeServer(fleets[2], rate=20.0, dialect=ROS2),
        RosbridgeServer(fleets[3], rate=20.0, dialect=ROS2),
    ]
    async with AsyncExitStack() as stack:
        for server in servers:
            await server.start()
            stack.push_async_callback(server.stop)
            server.bridge.started -= 10.0  # such a bridge has discovered every publisher
        first, *others = [server.url for server in servers]
        config = demo_config(Config(), first, len(KINDS), 1, "", MIXED, folder, others)
        yield MixedSite(servers, fleets, config)
