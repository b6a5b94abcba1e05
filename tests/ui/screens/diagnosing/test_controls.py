"""Controls of the diagnostics screen: freeze, copy, and follow the end."""

import base64
import json
import re

import pytest

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.diagnostics_pane import lines, listens, open_page, pane, say
from tests.support.watched_store import config_of


async def test_a_message_stays_while_it_is_frozen(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("d", "2", "enter", "space")
        await it.shows("frozen 0 s ago")
        await it.shows("Raw /robot_0/pose")
        (stamp,) = re.findall(r'"seq": (\d+)', pane(it))
        frames = it.app.backend.counters["rosbridge"].topics["/robot_0/pose"]
        seen = frames.count
        await it.shows("frozen 2 s ago")
        assert frames.count > seen + 5
        assert f'"seq": {stamp}' in pane(it) and "s ago, 2" in pane(it)
        await it.press("f")
        await it.hides("frozen")
        await it.hides(f'"seq": {stamp}')


async def test_the_end_of_the_log_is_followed_unless_one_looks_back(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2), (80, 24)) as it:
        await open_page(it, 4, "Robot log")
        await listens(it, server)
        for n in range(60):
            say(server, 2, f"line {n}.")
        await it.shows("line 59.")
        count = 1 + lines(it)  # the bridge has logged something, too
        await it.press("pageup", "pageup", "pageup")
        await it.shows("▸", "diagnostics-rows")
        marked = next(line for line in pane(it).splitlines() if "▸" in line)
        say(server, 2, "news")
        await it.shows(f"{count} of {count} lines")
        assert marked in pane(it) and "news" not in pane(it)
        await it.press("f")
        await it.shows("frozen")
        say(server, 2, "later")
        await it.press("pagedown", "pagedown", "pagedown", "pagedown")
        await it.shows("news", "diagnostics-rows")
        assert "later" not in pane(it)
        await it.press("f")
        await it.shows("later", "diagnostics-rows")


async def test_enter_shows_the_whole_of_a_line_that_is_cut_and_hides_it_again(
    server: RosbridgeServer,
) -> None:
    message = "no plan to the goal because " + "of this wall and " * 12 + "the end."
    async with console(config_of(server.url, 2, 2), (80, 24)) as it:
        await open_page(it, 4, "Robot log")
        await listens(it, server)
        for n in range(20):  # while lines are free it goes on in the next one
            say(server, 2, f"line {n}")
        say(server, 8, message)
        await it.shows("no plan", "diagnostics-rows")
        assert "the end." not in pane(it)
        await it.press("enter", "pagedown")
        await it.shows("the end.", "diagnostics-rows")
        say(server, 2, "news")
        await it.shows("news", "diagnostics-rows")
        assert "the end." in pane(it)
        await it.press("up", "enter")
        await it.hides("the end.", "diagnostics-rows")


async def test_copies_by_osc_52(server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        sent: list[str] = []
        monkeypatch.setattr(it.driver, "write", sent.append)
        monkeypatch.delenv("TMUX", raising=False)
        await it.press("d", "2", "down", "enter", "y")
        await it.shows("copied to the clipboard: the message of /robot_0/queue")
        (sequence,) = sent
        found = re.fullmatch(r"\x1b\]52;c;([A-Za-z0-9+/=]+)\x07", sequence)
        assert found is not None
        text = base64.b64decode(found.group(1)).decode()
        assert json.loads(text)["orders"] == []
        assert f"{len(text):,} characters" in it.text
        monkeypatch.setenv("TMUX", "/tmp/tmux")
        await it.press("1", "y")
        await it.shows("copied to the clipboard (tmux needs: set -s set-clipboard on): the row, ")
        assert base64.b64decode(sent[1].split(";")[2][:-1]).decode().split() == ["rosbridge", server.url]


async def test_copying_waits_for_a_terminal_that_still_reads_a_picture(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with console(config_of(server.url, 1)) as it:
        answers = [False, True, *5 * [False]]
        monkeypatch.setattr(it.app.output, "call", lambda _sequence: answers.pop(0))
        await it.press("d", "y")
        await it.shows("copied to the clipboard: the row, ")
        await it.press("y")
        await it.shows("not copied: the terminal is not reading")
        assert answers == []
