"""Pages of the diagnostics screen."""

import logging
import re
from collections.abc import Iterator

import pytest

from fleet_tui.config.log_file import TAIL
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.situation.alarms.trouble import in_trouble
from tests.support.console_pilot import console
from tests.support.diagnostics_pane import lines, listens, open_page, pane, say
from tests.support.planted_console import planted
from tests.support.scenario import plant
from tests.support.watched_store import config_of


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
        await it.sees(lambda: bool(re.search(r"messages +[234]\d\.\d /s, \d+\.\d kB/s", pane(it))), "rates")
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


async def test_the_robots_log_by_level_and_text(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await open_page(it, 4, "Robot log")
        await listens(it, server)
        await it.shows("Subscribed to /diagnostics")
        own = lines(it)  # of the bridge
        for level, words in ((1, "a detail"), (2, "order taken"), (30, "wheel slips"), (8, "motor hot")):
            say(server, level, words)
        await it.shows(f"{own + 3} of {own + 4} lines, INFO and worse")
        await it.press("v")
        await it.shows(f"2 of {own + 4} lines, WARN and worse")
        assert "order taken" not in pane(it) and "▲ WARN" in pane(it) and "✗ ERROR" in pane(it)
        await it.press("/")
        await it.type("MOTOR")
        await it.shows("/MOTOR: 1")
        say(server, 4, "motor hot again", "/robot_1/drive")
        await it.shows("motor hot again")
        await it.press("escape")
        await it.shows(f"3 of {own + 5} lines")
        await it.press("v", "v", "v")
        await it.shows(f"{own + 5} of {own + 5} lines, DEBUG and worse")


async def test_the_log_of_a_robot_in_trouble_comes_first_and_esc_shows_all(server: RosbridgeServer) -> None:
    plant(server, "battery:robot_1")
    async with console(config_of(server.url, 2, 2)) as it:
        await it.until(lambda state: "robot_1" in in_trouble(state))
        await it.press("1")
        await open_page(it, 4, "Robot log")
        await listens(it, server)
        say(server, 2, "of this one", "/robot_1/drive")
        say(server, 2, "of another one", "/robot_10/drive")
        await it.shows(" /robot_1: ")
        await it.shows("of this one", "diagnostics-rows")
        assert "of another one" not in pane(it)
        await it.press("escape")
        await it.shows("of another one", "diagnostics-rows")
        await it.press("escape", "1", "d")
        await it.shows("/rosout  ")
        assert " /robot_1: " not in pane(it)


async def test_of_a_robot_in_trouble_it_opens_on_the_page_of_the_cause() -> None:
    async with planted(2, 2, faults="battery:robot_1") as it:
        await it.until(lambda state: "robot_1" in in_trouble(state) and "robot_0" not in in_trouble(state))
        await it.press("d")
        await it.shows("[1 Link]")
        await it.press("escape", "1", "d")
        await it.shows("[2 Topics]")


async def test_the_console_on_itself(server: RosbridgeServer, own_log: logging.Logger) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        own_log.warning("something odd")
        await open_page(it, 6, "Console")
        await it.shows("something odd", "diagnostics-rows")
        # The pilot's screen has its own loop: one tick of the console's own timer is waited for.
        await it.sees(lambda: bool(re.search(r"tick +\d+(\.\d+)? ms", pane(it))), "a tick")
        assert re.search(r"memory +\d+\.\d MB, peak \d+\.\d MB", pane(it))
        assert re.search(r"process +\d+ threads", pane(it)) and "budget 100 ms" in pane(it)


async def test_before_there_is_a_link_it_says_that_the_console_starts() -> None:
    async with planted(2) as it:
        it.app.main.features.actions["diagnostics"]()
        await it.shows("console starting")
