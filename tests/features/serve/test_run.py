"""The console in a browser, without one: the same websocket that the page opens."""

import asyncio
import os
import signal
from contextlib import AsyncExitStack
from pathlib import Path
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus
from websockets.typing import Origin

from fleet_tui.features.serve.run import MOST_TABS
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.serve import WITHIN, Served, about, served_here, serving, until

NO_CONSOLE = "/no/console/is/opened"


async def get(page: Served, path: str = "", **headers: str) -> tuple[int, str, str]:
    """Status, body and content policy of an answer."""

    def fetch() -> tuple[int, str, str]:
        request = Request(page.url + path, headers=headers)
        try:
            with urlopen(request, timeout=WITHIN) as answer:
                return answer.status, answer.read().decode(), answer.headers["Content-Security-Policy"]
        except HTTPError as refused:
            return refused.code, refused.read().decode(), refused.headers["Content-Security-Policy"]

    return await asyncio.to_thread(fetch)


async def test_the_page_and_all_it_needs_come_from_here() -> None:
    async with served_here(NO_CONSOLE) as it:
        status, page, policy = await get(it)
        assert status == 200 and "fleet-tui" in page
        assert "http://" not in page and "https://" not in page and "//fonts" not in page
        assert "default-src 'self'" in policy and "frame-ancestors 'none'" in policy
        for file in ("static/js/textual.js", "static/css/xterm.css"):
            assert file in page
            assert (await get(it, file))[0] == 200
        assert "static/fonts/RobotoMono-VariableFont_wght.ttf" in page


async def test_a_tab_is_the_console(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it, it.tab() as page:
        await page.shows("robot_1")
        await page.shows("read-only")
        await page.shows("Consumidores")
        await page.press("?")
        await page.shows("type to search")
        await page.press("\x1b")
        await until(lambda: "type to search" not in page.text(), page.text)
        await page.resize(80, 24)
        await until(lambda: "? help" in page.screen.display[23], page.text)
        await page.shows("robot_1")
        await page.say("ping", "12")


async def test_a_browser_may_only_watch(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it:
        async with it.tab() as page:
            await page.shows("Consumidores")
            await page.press("p")
            await page.shows("not sent (this console is read-only)")
        assert not server.bridge.services.calls
        _, said = await it.stop()
    assert "read-only" in said and "warning" not in said


@pytest.mark.nightly
async def test_a_browser_commands_where_that_is_allowed(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url, "--allow-commands") as it:
        async with it.tab() as page:
            await page.shows("Consumidores")
            assert "read-only" not in page.text()
            await page.press("p")
            await until(
                lambda: [name for name, _ in server.bridge.services.calls if "pause" in name.lower()],
                page.text,
            )
        _, said = await it.stop()
    assert "Commands allowed" in said


async def test_no_other_page_opens_a_console() -> None:
    async with served_here(NO_CONSOLE) as it:
        for origin in ("http://evil.example", "null", "http://127.0.0.1", "http://localhost:1"):
            with pytest.raises(InvalidStatus) as refused:
                async with it.tab(origin):
                    pass
            assert refused.value.response.status_code == 403, origin


async def test_a_name_that_was_bound_to_this_address_is_not_ours() -> None:
    async with served_here(NO_CONSOLE) as it:
        status, said, _ = await get(it, Host="evil.example")
        assert status == 403 and "by its address" in said
        assert (await get(it, Host="localhost:9"))[0] == 200  # through a tunnel


@pytest.mark.nightly
async def test_a_closed_tab_ends_its_console(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it:
        async with it.tab() as page:
            await page.shows("robot_1")
            consoles = it.consoles()
            assert len(consoles) == 1
        await it.ended(*consoles)


@pytest.mark.nightly
async def test_a_page_learns_that_its_console_has_ended(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it, it.tab() as page:
        await page.shows("robot_1")
        await page.press("q")
        assert await page.closed() == "The console has ended."


@pytest.mark.nightly
async def test_a_page_learns_that_its_console_was_killed(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it, it.tab() as page:
        await page.shows("robot_1")
        os.kill(it.consoles()[0], signal.SIGKILL)
        assert await page.closed() == "The console has ended."


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 0), (signal.SIGKILL, -signal.SIGKILL)]
)
async def test_however_the_server_ends_so_do_its_consoles(
    number: int, code: int, server: RosbridgeServer, tmp_path: Path
) -> None:
    async with serving(tmp_path, server.url) as it, it.tab() as one, it.tab() as other:
        await one.shows("robot_1")
        await other.shows("robot_1")
        consoles = it.consoles()
        assert len(consoles) == 2
        assert (await it.stop(number))[0] == code
        await it.ended(*consoles)


@pytest.mark.nightly
async def test_a_console_that_hangs_is_ended_too(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it:
        async with it.tab() as page:
            await page.shows("robot_1")
            (console,) = it.consoles()
            os.kill(console, signal.SIGSTOP)
        await it.ended(console)


@pytest.mark.nightly
async def test_a_browser_that_does_not_read_holds_nobody(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it:
        address, origin = f"ws://{it.place}/ws", Origin(f"http://{it.place}")
        async with connect(address, origin=origin, max_queue=1, close_timeout=0.1) as deaf:
            for number in range(400):  # each is answered with every cell
                await deaf.send(f'["resize", {{"width": {300 + number % 2}, "height": 100}}]')
            await until(it.consoles)
            (console,) = it.consoles()
            async with it.tab() as page:
                await page.shows("Consumidores")
        await it.ended(console)


IDLE = """
import sys
if "serve" not in sys.orig_argv:
    sys.exit(not sys.stdin.buffer.read(1))
"""
"""Consoles that do nothing until they are told to quit: a tab does not wait for its console."""


@pytest.mark.nightly
async def test_there_is_a_limit_to_tabs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "sitecustomize.py").write_text(IDLE)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path), prepend=os.pathsep)
    async with serving(tmp_path, "ws://127.0.0.1:1") as it, AsyncExitStack() as tabs:
        for _ in range(MOST_TABS):
            await tabs.enter_async_context(it.tab())
        async with it.tab() as page:
            assert await page.closed() == f"{MOST_TABS} tabs open, the maximum: close one."
        await until(lambda: len(it.consoles()) == MOST_TABS)


@pytest.mark.nightly
async def test_nonsense_from_a_page_changes_nothing(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, server.url) as it, it.tab() as page:
        await page.shows("robot_1")
        for text in ("{", "7", '["resize", 3]', '["resize", {"width": "a", "height": 2}]', '["stdin"]'):
            await page.socket.send(text)
        await page.press("?")
        await page.shows("type to search")


@pytest.mark.nightly
async def test_secrets_are_in_no_argument(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BRIDGE_WORD", "hunter2")
    async with serving(tmp_path, "ws://127.0.0.1:1") as it, it.tab() as page:
        await page.shows("robot_1")
        (console,) = it.consoles()
        assert b"BRIDGE_WORD=hunter2" in about(console, "environ")
        assert b"hunter2" not in about(console, "cmdline")


async def test_another_address_than_loopback_is_warned_of(tmp_path: Path) -> None:
    async with serving(tmp_path, "ws://127.0.0.1:1", "--host", "0.0.0.0") as it:
        _, said = await it.stop()
    assert "warning: anyone who reaches 0.0.0.0" in said and "no password" in said and "ssh -L" in said


@pytest.mark.nightly
async def test_a_browser_on_what_is_behind_an_address(server: RosbridgeServer, tmp_path: Path) -> None:
    async with serving(tmp_path, "ws://127.0.0.1:9", "--url", server.url) as it, it.tab() as page:
        await page.shows("2 robots (oh_ressources), 2 floors. :save keeps it")
        await page.shows("2 of 2 online")
    assert not server.bridge.services.calls
