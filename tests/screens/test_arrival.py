"""The screens before the console under the pilot: what they show at any size, and what they open."""

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

import pytest
from textual.pilot import Pilot

from fleet_tui.adapters.discovery import Listed
from fleet_tui.config.schema import Link
from fleet_tui.discovery.recognition import claimed
from fleet_tui.discovery.site import DiscoveredSite
from fleet_tui.entry import EntryApp
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.themes import load_themes

PLACES = (("$FLEET_TUI_CONFIG", "not set"), ("./config.toml", "not there"), ("~/c/config.toml", "not there"))
SIZES = [(60, 15), (80, 24), (120, 40)]
ODOM, AMCL = "nav_msgs/msg/Odometry", "geometry_msgs/msg/PoseWithCovarianceStamped"
MAP = "nav_msgs/msg/OccupancyGrid"


class Entry:
    """The app before the console, and what it shows."""

    def __init__(self, app: EntryApp, pilot: Pilot[None]) -> None:
        self.app, self.pilot = app, pilot

    @property
    def text(self) -> str:
        return "\n".join(strip.text for strip in self.app.screen._compositor.render_strips())

    async def shows(self, *texts: str) -> None:
        """Wait until all this stands there, wherever its lines are broken."""
        await self.until(lambda: all(text in " ".join(self.text.split()) for text in texts), "\n".join(texts))

    async def until(self, holds: Callable[[], bool], what: str) -> None:
        try:
            async with asyncio.timeout(15):
                while not holds():
                    await self.pilot.pause(0.02)
        except TimeoutError:
            raise AssertionError(f"never: {what}\n{self.text}") from None

    async def ended(self) -> None:
        await self.until(lambda: not self.app.is_running, "the end")


@asynccontextmanager
async def entry(
    site: DiscoveredSite | None = None,
    address: str = "",
    size: tuple[int, int] = (80, 24),
    colour: bool = True,
) -> AsyncIterator[Entry]:
    app = EntryApp(load_themes(None)[0]["dark"], colour, site, PLACES, address)
    async with app.run_test(size=size) as pilot:
        yield Entry(app, pilot)


def unsure(robots: int = 1) -> DiscoveredSite:
    """A site with two topics for poses, and two floors that nothing tells."""
    topics = {"/hall/map": MAP, "/roof/map": MAP}
    for n in range(robots):
        topics |= {f"/amr_{n}/odom": ODOM, f"/amr_{n}/pose_a": AMCL, f"/amr_{n}/pose_b": AMCL}
    actions = tuple(f"/amr_{n}/navigate_to_pose" for n in range(robots))
    return DiscoveredSite(Link("ws://site:9090"), claimed(Listed(topics, {}, actions)), {}, len(topics))


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
        await it.shows("fleet-tui demo", "fleet-tui config init", "fleet-tui doctor --url URL")
        await it.shows("enter open", "a other address", "r retry", "q quit", "Enter opens the console")
        assert not server.bridge.services.calls and {one["op"] for one in server.bridge.received} <= {
            "call_service",
            "subscribe",
        }
        await it.pilot.press("enter")
        await it.ended()
        assert it.app.chosen is not None and len(it.app.chosen.config.robots) == 2


@pytest.mark.parametrize("size", SIZES)
async def test_it_says_why_nothing_is_there_and_opens_nothing(size: tuple[int, int]) -> None:
    async with entry(address="ws://127.0.0.1:9", size=size) as it:
        await it.shows("ws://127.0.0.1:9", "connection refused", "correct the address", "fleet-tui demo")
        await it.pilot.press("enter")
        assert it.app.is_running
        await it.pilot.press("q")
        await it.ended()
        assert it.app.chosen is None


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


@pytest.mark.parametrize("size", SIZES)
async def test_what_is_not_certain_is_chosen_first(size: tuple[int, int]) -> None:
    async with entry(unsure(), size=size) as it:
        await it.shows("ws://site:9090: 1 robot (nav2), 2 floors", "Please check.")
        await it.shows("> topic of pose (nav2)", "none of 2", "floor of amr_0", "any floor")
        await it.shows("enter open", "up/down line", "left/right choose", "q quit")
        await it.pilot.press("right")
        await it.shows("/{robot}/pose_a", "1 of 2")
        await it.pilot.press("right", "down", "left")
        await it.shows("/{robot}/pose_b", "< roof", "2 of 2")
        await it.pilot.press("enter")
        await it.ended()
        assert it.app.chosen is not None
        config = it.app.chosen.config
        assert config.profile.topics["pose"] == "/{robot}/pose_b"
        assert config.robots[0].floors == ["roof"]


async def test_many_choices_scroll_with_the_cursor() -> None:
    async with entry(unsure(20), size=(60, 15)) as it:
        await it.shows("floor of amr_0")
        await it.pilot.press(*["down"] * 20)
        await it.shows("> floor of amr_19")
        await it.pilot.press("q")
        await it.ended()
        assert it.app.chosen is None


async def test_of_another_kind_there_are_fewer_choices() -> None:
    topics = {"/amr/odom": ODOM, "/amr/pose_a": AMCL, "/amr/pose_b": AMCL, "/map": MAP}
    topics |= {"/amr/queue": "oh_ressources/msg/ActionQueue", "/amr/pose": "geometry_msgs/msg/PoseStamped"}
    claims = claimed(Listed(topics, {}, ("/amr/navigate_to_pose",)))
    async with entry(DiscoveredSite(Link("ws://site:9090"), claims, {}, 5)) as it:
        await it.shows("kind of amr", "oh_ressources")
        await it.pilot.press("right")
        await it.shows("< nav2", "topic of pose (nav2)")
        await it.pilot.press("down", "up", "right")
        await it.shows("< oh_ressources")
        assert "topic of pose (nav2)" not in it.text
