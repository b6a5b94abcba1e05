"""`d`: the diagnostics screen on the real loopback simulator, with keys alone."""

import base64
import json
import logging
import re
from collections.abc import Iterator

import msgspec
import pytest

from fleet_tui.backend import LiveBackend
from fleet_tui.log_file import TAIL
from fleet_tui.simulator.faults import parse_faults, play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console, console
from tests.support.watched_store import config_of

OVERHEARD = ["/rosout", "/diagnostics"]
BATTERY = "/robot_0/battery"


def asked(server: RosbridgeServer, op: str) -> list[str]:
    return [one["topic"] for one in server.bridge.received if one["op"] == op and one["topic"] in OVERHEARD]


def pane(it: Console) -> str:
    return it.pane("diagnostics-rows")


def say(server: RosbridgeServer, level: int, words: str, node: str = "/robot_0/drive") -> None:
    server.bridge.publish_raw("/rosout", {"level": level, "name": node, "msg": words})


async def open_page(it: Console, number: int, title: str) -> None:
    await it.press("d", str(number))
    await it.shows(title, "diagnostics-rows")


async def listens(it: Console, server: RosbridgeServer) -> None:
    await it.until(lambda _: all(server.bridge.subscribers(topic) for topic in OVERHEARD))


@pytest.fixture
def own_log() -> Iterator[logging.Logger]:
    TAIL.lines.clear()
    root = logging.getLogger()
    root.addHandler(TAIL)
    yield logging.getLogger("fleet_tui.something")
    root.removeHandler(TAIL)
    TAIL.lines.clear()


@pytest.mark.parametrize("size", [(120, 40), (80, 24)])
async def test_the_link_with_round_trip_and_rates(server: RosbridgeServer, size: tuple[int, int]) -> None:
    async with console(config_of(server.url, 2, 2), size) as it:
        await it.press("d")
        await it.shows("● up for")
        await it.shows("● ok")
        assert re.search(r"round trip +\d+(\.\d+)? ms, \d", pane(it))
        await it._wait(lambda: bool(re.search(r"messages +[234]\d\.\d /s, \d+\.\d kB/s", pane(it))), "rates")
        assert "0 reconnects" in pane(it)
        assert "robot_0" in it.text.splitlines()[0] and server.url in it.text.splitlines()[0]
        await server.drop_clients()
        await it.shows("1 reconnect")
        assert "last lost" in pane(it)


async def test_a_lost_link_is_said_on_every_page(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await open_page(it, 4, "Robot log")
        await listens(it, server)
        await it.until(lambda _: it.app.backend.counters["rosbridge"].health)
        await server.stop()
        await it.shows("no link", "diagnostics-rows")
        for page in "125":
            await it.press(page)
            await it.shows("no link", "diagnostics-rows")
        await it.press("2")
        assert "● live" not in pane(it)


@pytest.mark.parametrize("size", [(120, 40), (80, 24)])
async def test_a_wrong_field_is_seen_from_the_topic_to_the_raw_text(
    server: RosbridgeServer, size: tuple[int, int]
) -> None:
    async with console(config_of(server.url, 2, 2), size) as it:
        await open_page(it, 2, "Topics 30, 0 with problems")
        await it._wait(lambda: bool(re.search(r"● live +/robot_0/pose +\d+\.\d Hz", pane(it))), "a rate")
        server.bridge.muted.add(BATTERY)
        server.bridge.publish_raw(BATTERY, {"percent": 55.5, "cells": list(range(99))})
        await it.shows("▲ bad data")
        await it.shows("1 with problems")
        await it.press("/")
        await it.type("_0/battery")
        await it.press("enter")
        await it.hides("/robot_1/battery")
        assert "1 bad" in pane(it)
        await it.press("enter")
        await it.shows(f"Raw {BATTERY}")
        assert "▲ Object missing required field `data`" in it.text
        assert '"percent": 55.5' in it.text and "… 87 more of 99" in it.text
        server.bridge.muted.clear()
        await it.hides('"percent": 55.5')
        await it.press("b")
        await it.shows('"percent": 55.5')
        await it.press("escape")
        await it.shows("Topics 1,", "diagnostics-rows")
        await it.press("escape")
        await it.hides("[2 Topics]")


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


async def test_log_and_health_are_subscribed_while_it_is_open(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        assert asked(server, "subscribe") == []
        await open_page(it, 5, "Robot diagnostics")
        await listens(it, server)
        assert asked(server, "subscribe") == OVERHEARD
        play(server, parse_faults("obstacle:robot_1", server.world.robots))
        await it.shows("▲ WARN")
        assert "robot_1: laser" in pane(it) and "6 parts, 1 WARN" in pane(it)
        await it.press("down", "down", "down", "down", "down", "enter")
        await it.shows("hardware: laser-001")
        await it.press("escape")
        await it.until(lambda _: not any(server.bridge.subscribers(topic) for topic in OVERHEARD))
        assert asked(server, "unsubscribe") == OVERHEARD
        await it.press("d", "escape", "d")
        await listens(it, server)
        assert it.app.main.rest.diagnostics._timer is not None


async def test_the_mouse_outside_and_another_overlay_end_it_too(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("d")
        await listens(it, server)
        await it.press("f1")
        await it.shows("Diagnostics (d)")
        await it.until(lambda _: not server.bridge.subscribers("/rosout"))
        assert it.app.main.rest.diagnostics._timer is None


async def test_the_robots_log_by_level_and_text(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await open_page(it, 4, "Robot log")
        await listens(it, server)
        for level, words in ((1, "a detail"), (2, "order taken"), (30, "wheel slips"), (8, "motor hot")):
            say(server, level, words)
        await it.shows("4 of 4 lines, DEBUG and worse")
        await it.press("v", "v")
        await it.shows("2 of 4 lines, WARN and worse")
        assert "order taken" not in pane(it) and "▲ WARN" in pane(it) and "✗ ERROR" in pane(it)
        await it.press("/")
        await it.type("MOTOR")
        await it.shows("1 of 4 lines")
        say(server, 4, "motor hot again", "/robot_1/drive")
        await it.shows("motor hot again")
        await it.press("escape")
        await it.shows("3 of 5 lines")
        await it.press("v", "v", "v")
        await it.shows("5 of 5 lines, DEBUG and worse")


async def test_the_end_of_the_log_is_followed_unless_one_looks_back(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2), (80, 24)) as it:
        await open_page(it, 4, "Robot log")
        await listens(it, server)
        for n in range(60):
            say(server, 2, f"line {n}.")
        await it.shows("line 59.")
        await it.press("pageup", "pageup", "pageup")
        await it.shows("▸", "diagnostics-rows")
        marked = next(line for line in pane(it).splitlines() if "▸" in line)
        say(server, 2, "news")
        await it.shows("61 of 61 lines")
        assert marked in pane(it) and "news" not in pane(it)
        await it.press("f")
        await it.shows("frozen")
        say(server, 2, "later")
        await it.press("pagedown", "pagedown", "pagedown", "pagedown")
        await it.shows("news", "diagnostics-rows")
        assert "later" not in pane(it)
        await it.press("f")
        await it.shows("later", "diagnostics-rows")


async def test_what_robots_log_does_not_act_on_the_screen(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await open_page(it, 4, "Robot log")
        await listens(it, server)
        say(server, 2, "\x1b[2J\x1b]52;c;AAAA\x07\u202e[red]x[/]\n仓库", node="\x9b1m")
        await it.shows("␛[2J␛]52;c;AAAA␇\ufffd[red]x[/]␊仓库")
        server.bridge.publish_raw("/rosout", {"level": 2, "name": "/x", "msg": 4})
        await it.press("2", "pagedown", "pagedown", "pagedown", "pagedown")
        await it.shows("1 bad", "diagnostics-rows")


async def test_copies_by_osc_52(server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        sent: list[str] = []
        monkeypatch.setattr(it.app._driver, "write", sent.append)
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
        await it.shows("copied to the clipboard: the row, ")
        assert "set-clipboard on" in it.text
        assert base64.b64decode(sent[1].split(";")[2][:-1]).decode() == f"rosbridge {server.url}"


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


async def test_a_pause_reaches_through_it_and_the_status_line_stays(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await open_page(it, 2, "Topics")
        await it.press("/", "f12")
        await it.until(lambda _: len(server.bridge.services.calls) == 2)
        assert it.app.main.rest.diagnostics.is_open and "alarms" in it.text.splitlines()[0]


async def test_keys_in_it_command_no_robot_and_letters_go_to_the_field(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("d", "p", "x", "X", "P", "o", "s", "2", "/", "/", "d", "q", "2", "space", "f")
        await it.shows("matching /dq2 f")
        assert server.bridge.services.calls == []
        await it.press("escape", "d")
        await it.hides("[2 Topics]")


async def test_the_console_on_itself(server: RosbridgeServer, own_log: logging.Logger) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        own_log.warning("something odd")
        await open_page(it, 6, "Console")
        await it.shows("something odd", "diagnostics-rows")
        # The pilot's screen has its own loop: one tick of the console's own timer is waited for.
        await it._wait(lambda: bool(re.search(r"tick +\d+(\.\d+)? ms", pane(it))), "a tick")
        assert re.search(r"memory +\d+\.\d MB, peak \d+\.\d MB", pane(it))
        assert re.search(r"process +\d+ threads", pane(it)) and "budget 100 ms" in pane(it)


async def test_remapped_keys_work_and_show(server: RosbridgeServer) -> None:
    config = msgspec.structs.replace(config_of(server.url, 2), keys={"diagnostics": "D", "freeze": "ctrl+f"})
    async with console(config) as it:
        await it.press("D", "3")
        await it.shows("ctrl+f freeze")
        await it.press("ctrl+f")
        await it.shows("frozen 0 s ago")
        await it.press("D")
        await it.hides("[3 Raw]")


async def test_before_there_is_a_link_it_says_that_the_console_starts(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2), wait=False) as it:
        await it.pilot.pause()
        assert isinstance(it.app.backend, LiveBackend)
        it.app.backend.links = None
        it.app.main.rest.actions.view.diagnostics()
        await it.shows("console starting")


async def test_help_names_its_keys(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("d", "f1")
        await it.shows("Diagnostics (d)")
        await it.type("Freeze")
        await it.shows("Space f  Freeze or resume the message or the robot log")


async def test_the_footer_names_no_key_that_does_nothing(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        for opened in ("d", "o", ":"):
            await it.press(opened)
            await it._wait(lambda: " F12 pause all" in it.text.splitlines()[-1], "footer")
            footer = it.text.splitlines()[-1]
            assert " F1 help" in footer and not {" o order", " ? help", " menu"} & {*re.split("  +", footer)}
            await it.press("escape")
            await it._wait(lambda: " o order" in it.text.splitlines()[-1], "footer")
