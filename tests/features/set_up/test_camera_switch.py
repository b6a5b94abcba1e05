"""The camera by key: in the place of the map, or above it, and gone again."""

import pytest

from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.senses.camera import NAME
from tests.support.console_pilot import Console, console
from tests.support.nav2_site import Site

TOPIC = f"/robot_0/{NAME}"


async def opened(it: Console, *texts: str) -> None:
    await it.until(lambda state: state.robots["robot_0"].pose)
    await it.press("V")
    for text in texts:
        await it.shows(text, "camera")


@pytest.mark.parametrize(("size", "has_map"), [((80, 24), False), ((120, 40), True)])
async def test_v_opens_the_picture_and_closes_it(site: Site, size: tuple[int, int], has_map: bool) -> None:
    async with console(site.config, size) as it:
        await opened(it, "Camera robot_0", "▀")
        assert bool(it.app.main.features.map.size.height) is has_map
        pictured = {
            part.style.bgcolor.number
            for part in it.app.main.features.camera_switch.view.render_line(size[1] // 4)
            if part.style is not None and part.style.bgcolor is not None
        }
        assert len(pictured) > 1
        await it.press("V")
        assert it.app.main.focused is it.app.main.features.map and it.app.main.features.map.size.height
        await it.until(lambda _: not site.server.bridge.subscribers(TOPIC))


async def test_escape_closes_it_and_it_follows_the_selected_robot(site: Site) -> None:
    async with console(site.config, (80, 24)) as it:
        await opened(it, "Camera robot_0")
        await it.press("]")
        await it.shows("Camera robot_1", "camera")
        await it.shows("▀", "camera")
        await it.press("escape")
        assert not it.app.main.features.camera.is_open and it.app.main.focused is it.app.main.features.map


async def test_a_hostile_picture_is_named(site: Site) -> None:
    play(site.server, [("camera-huge", "robot_0")])
    async with console(site.config, (120, 40)) as it:
        await opened(it, "exceeds 16,000,000 px")


async def test_a_screen_without_space_says_so(site: Site) -> None:
    async with console(site.config, (80, 24)) as it:
        await it.pilot.resize_terminal(50, 14)
        await it.press("V")
        await it.shows("no space for a picture")
        assert not it.app.main.features.camera.is_open
