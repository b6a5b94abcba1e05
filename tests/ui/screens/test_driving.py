"""A robot driven by keys, from the console to the wheels, and every way out of it."""

import asyncio
import math
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from msgspec.structs import replace
from textual import events

from fleet_tui.commands.driving import hold
from fleet_tui.model.kind import DRIVE
from fleet_tui.model.set_up.driving import STILL, DrivePhase, DriveState
from fleet_tui.robots.profile import DriveConfig
from fleet_tui.simulator.kinds import play
from fleet_tui.text.language import Message
from fleet_tui.ui.terminal.key_releases import KeyReleased
from tests.support.console_pilot import Console, console
from tests.support.fleets import of_kinds
from tests.support.nav2_site import Site, nav2_site
from tests.support.planted_console import SITE, PlantedConsole, planted
from tests.support.watched_store import config_of

R0 = "robot_0"


@pytest.fixture
async def slow_site(tmp_path: Path) -> AsyncIterator[Site]:
    """Two robots that take their time."""
    async with nav2_site(tmp_path, speed=1.0, rate=20.0) as running:
        yield running


@asynccontextmanager
async def driving(
    site: Site, size: tuple[int, int] = (120, 40), robot_timeout: float | None = 0.5, holonomic: bool = False
) -> AsyncIterator[Console]:
    """Run a console, and begin to drive the first robot."""
    limits = replace(site.config.drive, robot_timeout=robot_timeout, holonomic=holonomic)
    async with console(replace(site.config, drive=limits), size) as it:
        await it.press("T")
        if robot_timeout is None:
            await it.shows("robot_0 may not stop by itself when the link is cut:")
            await it.press("y")
        await it.shows("DRIVE robot_0 0.00 m/s", "map")
        yield it


@asynccontextmanager
async def led(size: tuple[int, int] = (120, 40)) -> AsyncIterator[PlantedConsole]:
    """Run a console that drives a robot which keeps all it is told; a key is held until another one."""
    config = replace(config_of(SITE, 2), drive=DriveConfig(robot_timeout=0.5))
    async with planted(config=config, size=size) as it:
        kind = it.store.state.robots[R0].kind
        driven = replace(kind, accepts=(*kind.accepts, DRIVE))
        it.store.put(of_kinds(it.store.state, driven, driven))
        await it.press("T")
        it.backend.drives[-1].state = DriveState(DrivePhase.READY)
        await it.shows("DRIVE robot_0 0.00 m/s", "map")
        yield it


def is_led(it: PlantedConsole) -> bool:
    """Tell whether the robot was told to move last."""
    steered = it.backend.drives[-1].steered
    return bool(steered) and steered[-1].speeds != STILL


def end_of(it: PlantedConsole) -> Message:
    """The reason for which the drive ended."""
    state = it.backend.drives[-1].state
    assert state.phase is DrivePhase.ENDED
    return state.reason


@pytest.fixture
def held(monkeypatch: pytest.MonkeyPatch) -> None:
    """A tap would end before anyone could tell what ended it."""
    monkeypatch.setattr(hold, "TAP", 600.0)


async def press_until(it: Console, key: str, text: str, pane: str) -> None:
    """Hold a key until a text stands in a pane, as fast as keyboards repeat it: a burst drives nothing."""
    ends = time.monotonic() + 20.0
    while text not in it.pane(pane):
        assert time.monotonic() < ends, it.text
        await it.press(key)
        await asyncio.sleep(0.03)


def frames(site: Site) -> list[tuple[float, float, float]]:
    """The twists that the bridge received."""
    found = [
        one["msg"]
        for one in site.server.bridge.received
        if one.get("topic") == f"/{R0}/cmd_vel" and one["op"] == "publish"
    ]
    return [(one["linear"]["x"], one["linear"]["y"], one["angular"]["z"]) for one in found]


async def test_a_key_still_held_once_the_drive_has_ended_is_no_command(slow_site: Site) -> None:
    async with driving(slow_site) as it:
        await it.press("a")
        await slow_site.server.stop()
        await press_until(it, "a", "no link", "alarms")
        await it.press("a", "s", "w", "d")
        assert "DRIVE robot_0 ended: let go of the key" in it.pane("map")
        assert not it.app.main.notices.text.startswith("acknowledged") and "Why: " not in it.text
        await it.hides("DRIVE", "map")
        await it.press("a")
        await it.shows("acknowledged", "message")


def is_still(site: Site) -> bool:
    return frames(site)[-1] == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_keys_move_the_robot_and_silence_stops_it(slow_site: Site, size: tuple[int, int]) -> None:
    robot = slow_site.navigation().robot
    async with driving(slow_site, size) as it:
        start = robot.pose
        await it.press("w", "a")
        await it.until(lambda _: robot.pose != start)
        await it.until(lambda _: is_still(slow_site))
        moved = [one for one in frames(slow_site) if one != (0.0, 0.0, 0.0)]
        assert moved and all(0.0 <= ahead <= 0.1 and 0.0 <= turning <= 0.2 for ahead, _, turning in moved)
        assert it.app.main.features.driving.controls.mode is not None
        await it.press("escape")
        await it.hides("DRIVE", "map")
        assert slow_site.server.bridge.subscribers(f"/{R0}/cmd_vel") == 0 or is_still(slow_site)


async def test_it_asks_first_where_a_robot_may_not_stop_by_itself(slow_site: Site) -> None:
    async with driving(slow_site, robot_timeout=None) as it:
        start = slow_site.navigation().robot.pose
        await it.press("w")
        await it.until(lambda _: slow_site.navigation().robot.pose != start)


@pytest.mark.usefixtures("held")
async def test_any_other_key_stops_and_does_nothing_else() -> None:
    async with led() as it:
        for key in ("y", "o", "f", "q", "x", "space", "up", "enter", "0"):
            await it.press("w")
            assert is_led(it)
            await it.press(key)
            assert not is_led(it) and it.sent == []
            assert it.app.main.features.driving.controls.mode is not None, key
            assert it.app.is_running and it.app.main.focused is it.app.main.features.map


@pytest.mark.usefixtures("held")
@pytest.mark.parametrize(
    ("key", "reason"),
    [
        ("escape", "left by key"),
        ("?", "the map lost the focus"),
        (":", "the map lost the focus"),
        ("f1", "the map lost the focus"),
        ("tab", "the map lost the focus"),
        ("P", "pause all"),
        ("f12", "pause all"),
    ],
)
async def test_these_keys_stop_and_leave(key: str, reason: str) -> None:
    async with led() as it:
        await it.press("w")
        assert is_led(it)
        await it.press(key)
        assert end_of(it) == reason
        assert it.app.main.features.driving.controls.mode is None
        if reason != "pause all":
            assert it.app.main.notices.text == f"robot_0 is not driven any more: {reason}"


async def test_a_terminal_without_the_focus_stops_it(slow_site: Site) -> None:
    async with driving(slow_site) as it:
        await it.press("w")
        it.app.post_message(events.AppBlur())
        await it.settled()
        await it.until(lambda _: is_still(slow_site))
        assert it.app.main.features.driving.controls.mode is None


async def test_another_robot_ends_it() -> None:
    async with led() as it:
        await it.press("w")
        it.app.main.navigation.select("robot_1")
        await it.hides("DRIVE", "map")
        assert end_of(it) == "another robot"


async def test_an_order_from_elsewhere_ends_it_and_keeps_it_from_beginning(slow_site: Site) -> None:
    async with driving(slow_site) as it:
        slow_site.navigation().give(20.0, 7.0)
        await it.shows("robot_0 is not driven any more: robot_0 has 1 order: cancel or clear first")
        await it.press("T")
        await it.shows("robot_0 has 1 order: cancel or clear first", "message")
        await it.hides("DRIVE", "map")


async def test_another_publisher_ends_it(slow_site: Site) -> None:
    play(slow_site.server, [("foreign-drive", R0)])
    async with driving(slow_site) as it:
        await press_until(it, "w", "someone else drives", "message")


async def test_a_bridge_that_lags_ends_it(slow_site: Site) -> None:
    play(slow_site.server, [("lag", R0)])
    async with driving(slow_site) as it:
        await press_until(it, "w", "lag: no echo for 0.3 s", "message")
        await it.until(lambda _: is_still(slow_site))


async def test_the_speed_changes_within_the_caps_and_goes_sideways_only_if_it_can(slow_site: Site) -> None:
    async with driving(slow_site, holonomic=True) as it:
        await it.press(*"+" * 9, "q")
        await it.until(lambda _: any(sideways > 0.0 for _, sideways, _ in frames(slow_site)))
        await it.press(*"wq" * 10)
        await it.until(lambda _: is_still(slow_site))
        assert max(math.hypot(x, y) for x, y, _ in frames(slow_site)) <= 0.3 + 1e-9
        mode = it.app.main.features.driving.controls.mode
        assert mode is not None and mode.share == 1.0


async def test_a_bridge_without_a_listener_is_named(slow_site: Site) -> None:
    named = replace(slow_site.config.profile, topics={"drive": "/{robot}/nowhere"})
    limits = replace(slow_site.config.drive, robot_timeout=0.5)
    async with console(replace(slow_site.config, profile=named, drive=limits)) as it:
        await it.press("T")
        await it.shows("robot_0 is not driven any more: nobody listens on /robot_0/nowhere")
        await it.hides("DRIVE", "map")


async def test_a_console_that_quits_stops_the_robot(slow_site: Site) -> None:
    async with driving(slow_site) as it:
        await it.press("w")
        await it.until(lambda _: not is_still(slow_site))
        drive = it.app.main.features.driving.controls.drive
        assert drive is not None
    assert drive.state.phase is DrivePhase.ENDED
    assert is_still(slow_site)


@pytest.mark.usefixtures("held")
async def test_the_release_of_a_key_stops_the_robot() -> None:
    async with led() as it:
        await it.press("w")
        it.app.post_message(KeyReleased("up"))
        await it.settled()
        assert is_led(it)
        it.app.post_message(KeyReleased("w"))
        await it.until(lambda _: not is_led(it))
        assert it.app.main.features.driving.controls.mode is not None


async def test_nothing_is_driven_without_the_map_that_tells_it(slow_site: Site) -> None:
    async with driving(slow_site, (80, 24)) as it:
        await it.press("escape", "V")
        await it.shows("Camera robot_0", "camera")
        began = len(frames(slow_site))
        await it.press("T")
        await it.shows("no map in view: close the camera (V)")
        assert it.app.main.features.driving.controls.mode is None and len(frames(slow_site)) == began


async def test_a_map_that_goes_out_of_view_ends_the_drive(slow_site: Site) -> None:
    async with console(
        replace(slow_site.config, drive=replace(slow_site.config.drive, robot_timeout=0.5))
    ) as it:
        await it.until(lambda state: state.robots[R0].pose)
        await it.press("V")
        await it.shows("Camera robot_0", "camera")
        await it.press("T")
        await it.shows("DRIVE robot_0 0.00 m/s", "map")
        await it.pilot.resize_terminal(80, 24)
        await it.shows("robot_0 is not driven any more: ")
        assert is_still(slow_site)
