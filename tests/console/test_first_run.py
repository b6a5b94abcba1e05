"""The first run: the places, the robots at an address, and why none."""

import pytest

from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.entry_app import SIZES, entry


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("colour", [True, False])
async def test_it_names_the_places_the_robots_and_the_keys(
    server: RosbridgeServer, size: tuple[int, int], colour: bool
) -> None:
    async with entry(address=server.url, size=size, colour=colour) as it:
        await it.shows("$FLEET_TUI_CONFIG", "./config.toml", "~/c/config.toml", "no configuration found")
        await it.shows(
            server.url, "2 robots (oh_ressources), 2 floors", "robot_0, robot_1", "floor_0, floor_1"
        )
        await it.shows("fleet-tui demo", "fleet-tui config init", f"fleet-tui doctor --url {server.url}")
        await it.shows(
            "enter open", "a other address", "d demo", "r retry", "q quit", "Enter opens the console"
        )
        assert not server.bridge.services.calls and {one["op"] for one in server.bridge.received} <= {
            "call_service",
            "subscribe",
        }
        await it.pilot.press("enter")
        await it.ended()
        assert isinstance(it.app.chosen, DiscoveredSite) and len(it.app.chosen.config.robots) == 2


@pytest.mark.parametrize("size", SIZES)
async def test_it_says_why_nothing_is_there_and_opens_nothing(size: tuple[int, int]) -> None:
    async with entry(address="ws://127.0.0.1:9", size=size) as it:
        await it.shows(
            "ws://127.0.0.1:9",
            "connection refused",
            "correct the address",
            "fleet-tui demo",
            "a other address",
        )
        assert "enter open" not in it.text
        await it.pilot.press("enter")
        assert it.app.is_running
        await it.pilot.press("q")
        await it.ended()
        assert it.app.chosen is None


async def test_one_key_leads_to_simulated_robots() -> None:
    async with entry(address="ws://127.0.0.1:9") as it:
        await it.shows("d demo", "d opens a simulated fleet")
        await it.pilot.press("d")
        await it.ended()
        assert it.app.chosen == "demo"


async def test_another_address(server: RosbridgeServer) -> None:
    async with entry(address="ws://127.0.0.1:9") as it:
        await it.shows("connection refused")
        await it.pilot.press("a", *"quiet:1", "enter")
        await it.shows("ws://quiet:1", "unknown host")
        await it.pilot.press("a", "escape")
        await it.pilot.press("a", *server.url.removeprefix("ws://"), "enter")
        await it.shows(server.url, "2 robots (oh_ressources)")
        await it.pilot.press("enter")
        await it.ended()
        assert it.app.chosen is not None


async def test_an_address_that_is_none() -> None:
    async with entry(address="http://robot:9090") as it:
        await it.shows("did you mean ws://robot:9090?")
        await it.pilot.press("ctrl+c")
        assert it.app.is_running


async def test_asked_again_it_finds_what_is_there_now(server: RosbridgeServer) -> None:
    server.bridge.services.rosapi_alive = False
    async with entry(address=server.url) as it:
        await it.shows("start rosapi beside rosbridge")
        server.bridge.services.rosapi_alive = True
        await it.pilot.press("r")
        await it.shows("2 robots (oh_ressources), 2 floors")
