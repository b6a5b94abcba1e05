"""The activities of the robots beside the last events."""

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.watched_store import config_of

LARGE = (200, 60)


async def test_a_large_screen_shows_what_the_robots_did_below_a_map_without_other_floors_there(
    server: RosbridgeServer,
) -> None:
    async with console(config_of(server.url, 2, floors=2), LARGE) as it:
        await it.shows("robot_1", "activity")
        activity, recent = (it.app.main.query_one(name) for name in ("#activity", "#recent"))
        assert activity.size.height == recent.size.height and recent.region.right <= activity.region.x


async def test_small_maps_in_its_place_and_small_screens_have_none(server: RosbridgeServer) -> None:
    for robots, size in ((30, LARGE), (2, (120, 40)), (2, (80, 24))):
        async with console(config_of(server.url, robots, floors=2), size, wait=False) as it:
            await it.until(lambda _: it.app.main.is_complete)
            await it.shows("Fleet")
            await it.until(lambda _: not it.app.main.query_one("#activity").size.height)
