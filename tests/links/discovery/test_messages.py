"""Messages that name robots: taken from the bridge for some seconds, only where there are such topics."""

import time

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.messages import sample_messages
from fleet_tui.links.discovery.wire import BridgeConnection
from tests.support.rmf_site import hospital

TYPES = {"/fleet_states": "rmf_fleet_msgs/msg/FleetState", "/nav_graphs": "rmf_building_map_msgs/msg/Graph"}


async def test_each_fleet_has_sent_its_own() -> None:
    async with hospital() as site:
        wire = BridgeConnection(Link(site.server.url))
        try:
            assert not await wire.connect(5.0)
            found = await sample_messages(wire, TYPES, time.monotonic() + 0.5)
            assert set(found) == set(TYPES) and len(found["/fleet_states"]) >= 2
            assert len(found["/nav_graphs"]) == 2
            began = time.monotonic()
            assert await sample_messages(wire, {"/odom": "nav_msgs/msg/Odometry"}, began + 9.0) == {}
            assert time.monotonic() < began + 9.0
        finally:
            wire.close()
