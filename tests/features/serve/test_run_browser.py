"""The console in a real browser: what xterm.js makes of the bytes, keys as the browser sends them."""

import io
import os
import signal
from pathlib import Path

import pytest
from PIL import Image

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.browser import CHROMIUM, browser
from tests.support.serve import serving, until

pytestmark = [pytest.mark.nightly, pytest.mark.skipif(CHROMIUM is None, reason="no chromium is installed")]


async def test_a_person_looks_around_in_a_browser(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it, browser(tmp_path) as tab:
        await tab.go(it.url)
        text = await tab.shows("Consumidores")
        assert "robot_1" in text and "read-only" in text and "Queue" in text
        assert await tab.notice() == ""

        await tab.press("?")  # without a click: the terminal has the focus
        await tab.shows("type to search")
        await tab.press("Escape")
        await tab.shows_no_longer("type to search")
        await tab.press("p")
        await tab.shows("not sent (this console is read-only)")
        assert not server.bridge.services.calls

        await tab.resize(800, 500)
        rows = await tab.has_rows(20, 30)
        assert "robot_0" in rows[0]
        with Image.open(io.BytesIO(await tab.picture())) as shot:
            assert len(shot.convert("RGB").getcolors(2**20) or ()) > 20

        assert {url.split("/")[2] for url in tab.asked} == {it.place}
        assert [error for error in tab.errors if "WebGL" not in error] == []

        await tab.call("Page.navigate", url="about:blank")
        await until(lambda: not it.consoles())


async def test_an_order_to_pause_from_a_browser_reaches_the_robot(
    server: RosbridgeServer, tmp_path: Path
) -> None:
    async with serving(tmp_path, server.url, "--allow-commands") as it, browser(tmp_path) as tab:
        await tab.go(it.url)
        await tab.shows("Consumidores")
        await tab.press("p")
        await until(lambda: [name for name, _ in server.bridge.services.calls if "pause" in name.lower()])


async def test_a_browser_says_that_its_picture_is_old(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it, browser(tmp_path) as tab:
        await tab.go(it.url)
        await tab.shows("robot_1")
        os.kill(it.process.pid, signal.SIGSTOP)
        try:
            await tab.says("this picture is old")
        finally:
            os.kill(it.process.pid, signal.SIGCONT)
        await tab.says_nothing()
        await tab.press("q")
        await tab.says("The console has ended.")


async def test_a_browser_says_that_the_server_is_gone(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it, browser(tmp_path) as tab:
        await tab.go(it.url)
        await tab.shows("robot_1")
        await it.stop(signal.SIGKILL)
        await tab.says("lost: this picture is old")
