"""The app before the console: which screen it begins with, and what it hands on."""

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.console.entry import Arrival, EntryApp
from fleet_tui.console.first_run import FirstRun
from fleet_tui.links.discovery.recognition import claimed
from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.robots.discovery import Listed
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.themes import load_themes
from tests.support.discovering import discovered

THEME = load_themes(None)[0]["dark"]
POSES = dict.fromkeys(("/amr/pose_a", "/amr/pose_b"), "geometry_msgs/msg/PoseWithCovarianceStamped")
UNSURE = DiscoveredSite(Link("ws://a:1"), claimed(Listed(POSES, {}, ("/amr/navigate_to_pose",))), {}, 2)
"""A site whose robot has two topics for poses."""


async def test_without_a_site_it_begins_with_the_first_run_and_leaves_with_none() -> None:
    app = EntryApp(THEME, True)
    async with app.run_test() as pilot:
        assert isinstance(app.screen, FirstRun)
        await pilot.press("ctrl+c")
        assert app.is_running, "as in the console it ends nothing"
        app.found(None)
    assert app.chosen is None


@pytest.mark.parametrize("colour", [True, False])
async def test_a_site_with_nothing_open_is_handed_on_at_once(server: RosbridgeServer, colour: bool) -> None:
    found = await discovered(server.url)
    app = EntryApp(THEME, colour)
    async with app.run_test():
        app.found(found)
    assert app.chosen is found


async def test_what_is_open_is_chosen_first_whether_it_was_known_before_or_found() -> None:
    async with EntryApp(THEME, True, UNSURE).run_test() as pilot:
        assert isinstance(pilot.app.screen, Arrival)
    app = EntryApp(THEME, True)
    async with app.run_test() as pilot:
        app.found(UNSURE)
        await pilot.pause()
        assert isinstance(app.screen, Arrival) and app.chosen is None
