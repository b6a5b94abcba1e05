"""`d`: the diagnostics screen on the real loopback simulator, with keys alone."""

import re

import msgspec
import pytest

from fleet_tui.model.commands import PauseRobot
from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.diagnostics_pane import OVERHEARD, listens, open_page, pane, say
from tests.support.planted_console import SITE, planted
from tests.support.watched_store import config_of

BATTERY = "/robot_0/battery"


def asked(server: RosbridgeServer, op: str) -> list[str]:
    return [one["topic"] for one in server.bridge.received if one["op"] == op and one["topic"] in OVERHEARD]


@pytest.mark.parametrize("size", [(120, 40), (80, 24)])
async def test_a_wrong_field_is_seen_from_the_topic_to_the_raw_text(
    server: RosbridgeServer, size: tuple[int, int]
) -> None:
    async with console(config_of(server.url, 2, 2), size) as it:
        await open_page(it, 2, "Topics 30, 0 with problems")
        await it.sees(
            lambda: bool(re.search(r"● live +\d\.\d s ago /robot_0/pose +\d+\.\d Hz", pane(it))), "a rate"
        )
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
        await it.shows("▲ Object missing required field `data`")
        assert '"percent": 55.5' in it.text and "… 87 more of 99" in it.text
        server.bridge.muted.clear()
        await it.hides('"percent": 55.5')
        await it.press("b")
        await it.shows('"percent": 55.5')
        await it.press("escape")
        await it.shows("Topics 30,", "diagnostics-rows")
        assert "/_0/battery: 1" in pane(it)
        await it.press("escape")
        await it.hides("[2 Topics]")


async def test_on_a_wide_screen_the_message_of_the_marked_topic_is_beside_the_topics(
    server: RosbridgeServer,
) -> None:
    async with console(config_of(server.url, 2, 2), (200, 60)) as it:
        await open_page(it, 1, "Link")
        await it.shows("/robot_0/pose", "diagnostics-beside")
        await it.press("2", "home", "down")
        await it.shows("Raw /robot_0/queue", "diagnostics-beside")
        await it.press("down")
        await it.shows("Raw /robot_0/obstacle", "diagnostics-beside")
        await it.shows('"data": 0.0', "diagnostics-beside")


async def test_log_and_health_are_subscribed_while_it_is_open(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        assert asked(server, "subscribe") == []
        await open_page(it, 5, "Robot diagnostics")
        await listens(it, server)
        assert asked(server, "subscribe") == OVERHEARD
        play(server, parse_faults("obstacle:robot_1", server.world.robots))
        await it.shows("▲ WARN")
        assert "robot_1: laser" in pane(it) and "6 parts, 1 WARN" in pane(it)
        await it.press("pageup", "enter")  # the cursor may be on what came first
        await it.shows("hardware: laser-001")
        await it.press("escape")
        await it.until(lambda _: not any(server.bridge.subscribers(topic) for topic in OVERHEARD))
        assert asked(server, "unsubscribe") == OVERHEARD
        await it.press("d", "escape", "d")
        await listens(it, server)
        assert it.app.main.features.diagnostics.refreshing is not None


async def test_the_mouse_outside_and_another_overlay_end_it_too() -> None:
    async with planted(2, 2) as it:
        await it.press("d")
        await it.until(lambda _: it.backend.reads_logs)
        await it.press("f1")
        await it.shows("Diagnostics (d)")
        await it.until(lambda _: not it.backend.reads_logs)
        await it.until(lambda _: it.app.main.features.diagnostics.refreshing is None)


async def test_what_robots_log_does_not_act_on_the_screen(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await open_page(it, 4, "Robot log")
        await listens(it, server)
        say(server, 2, "\x1b[2J\x1b]52;c;AAAA\x07\u202e[red]x[/]\n仓库", node="\x9b1m")
        await it.shows("␛[2J␛]52;c;AAAA␇\ufffd[red]x[/]␊仓库")
        server.bridge.publish_raw("/rosout", {"level": 2, "name": "/x", "msg": 4})
        await it.press("2", "pagedown", "pagedown", "pagedown", "pagedown")
        await it.shows("1 bad", "diagnostics-rows")


async def test_a_pause_reaches_through_it_and_the_status_line_stays() -> None:
    async with planted(2, 2) as it:
        await open_page(it, 2, "Topics")
        await it.press("/", "f12")
        assert it.sent == [PauseRobot("robot_0"), PauseRobot("robot_1")]
        assert it.app.main.features.diagnostics.is_open and "alarms" in it.text.splitlines()[0]


async def test_keys_in_it_command_no_robot_and_letters_go_to_the_field() -> None:
    async with planted(2, 2) as it:
        await it.press("d", "p", "x", "X", "o", "s", "2", "/", "/", "d", "q", "2", "space", "f")
        await it.shows("//dq2 f: 0")
        assert it.sent == []
        await it.press("escape", "d")
        await it.hides("[2 Topics]")


async def test_remapped_keys_work_and_show() -> None:
    config = msgspec.structs.replace(config_of(SITE, 2), keys={"diagnostics": "D", "freeze": "ctrl+f"})
    async with planted(config=config) as it:
        await it.press("D", "3")
        await it.shows("Ctrl-F freeze")
        await it.press("ctrl+f")
        await it.shows("frozen 0 s ago")
        await it.press("D")
        await it.hides("[3 Raw]")


async def test_help_names_its_keys() -> None:
    async with planted() as it:
        await it.press("d", "f1")
        await it.shows("Diagnostics (d)")
        await it.type("Freeze")
        await it.shows("Space f  Freeze or resume the message or the robot log")


async def test_the_footer_names_no_key_that_does_nothing() -> None:
    async with planted() as it:
        for opened in ("d", "o", ":"):
            await it.press(opened)
            await it.sees(lambda: " F12 pause all" in it.text.splitlines()[-1], "footer")
            footer = it.text.splitlines()[-1]
            assert " F1 help" in footer and not {" o order", " ? help", " menu"} & {*re.split("  +", footer)}
            await it.press("escape")
            await it.sees(lambda: " o order" in it.text.splitlines()[-1], "footer")
