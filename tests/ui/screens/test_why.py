"""`w`: the panel on the selected robot, live, and the keys in it."""

import re

import msgspec
import pytest
from msgspec.structs import replace
from textual.widgets import Input

from fleet_tui.model.commands import ResumeRobot
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.situation.why.reason import Reason
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.screens.confirm import Confirm
from fleet_tui.ui.screens.ordering.form import OrderForm
from fleet_tui.ui.screens.why import Why
from tests.support.console_pilot import Console, console
from tests.support.fleets import place_order
from tests.support.planted_console import SITE, planted
from tests.support.scenario import plant
from tests.support.situations import BASE, CONSUMIDORES
from tests.support.watched_store import config_of

REPORTED = re.compile(r"reported \d")
"""The age of evidence."""


def is_open(it: Console) -> bool:
    return it.app.main.query_one(Why).is_open


@pytest.mark.parametrize("size", [(120, 40), (80, 24)])
async def test_it_names_the_cause_and_its_key_does_the_fix(size: tuple[int, int]) -> None:
    async with planted(2, 2, size) as it:
        it.fleet.plant("paused:robot_0")
        await it.press("w")
        await it.shows("Why: robot_0")
        await it.shows("▶ 1. paused (elsewhere)  (certain)")
        await it.shows("r resume")
        await it.press("r")
        await it.shows("▶ 1. no orders")
        assert it.sent == [ResumeRobot("robot_0")]
        await it.press("escape")
        await it.hides("Why: robot_0")


async def test_it_is_live_and_goes_with_the_robot() -> None:
    async with planted(2, 2) as it:
        await it.press("w")
        await it.shows("▶ 1. no orders")
        it.fleet.plant("obstacle:robot_0,paused:robot_1")
        await it.shows("▶ 1. obstacle")
        await it.press("]")
        await it.shows("Why: robot_1")
        await it.shows("▶ 1. paused")
        await it.press("[")
        await it.shows("Why: robot_0")
        await it.press("w")
        await it.hides("Why: ")


async def test_order_and_clear_open_what_they_open_elsewhere() -> None:
    async with planted() as it:
        await it.press("w", "o")
        await it.shows("Charger ")
        assert it.app.main.query_one(OrderForm).is_open and not is_open(it)
        await it.type("Base")
        await it.press("enter")
        await it.type("Store")
        await it.press("enter")
        await it.until(lambda state: state.robots["robot_0"].orders.orders)
        await it.press("w", "X")
        await it.shows("Clear all 1 order of robot_0?")
        assert it.app.main.query_one(Confirm).is_open and not is_open(it)
        await it.press("n")
        assert len(it.sent) == 1


async def test_a_pause_reaches_through_it() -> None:
    async with planted(2, 2) as it:
        await it.press("w", "f12")
        await it.until(lambda _: len(it.sent) == 2)
        await it.until(lambda state: all(one.is_decided for one in state.commands))
        await it.press("P")
        await it.until(lambda _: len(it.sent) == 4)
        await it.shows("    sent by this console, ")
        assert is_open(it)


async def test_other_keys_do_nothing_in_it() -> None:
    async with planted() as it:
        await it.press("w", "s", "m", "*", "A", "}")
        assert is_open(it)
        assert it.sent == []


async def test_remapped_keys_work_and_show() -> None:
    config = msgspec.structs.replace(config_of(SITE, 1), keys={"why": "W", "resume": "f5"})
    async with planted(config=config) as it:
        it.fleet.plant("paused:robot_0")
        await it.press("W")
        await it.shows("F5 resume")
        await it.press("f5")
        await it.shows("▶ 1. no orders")
        await it.press("W")
        await it.hides("Why: ")


async def test_the_robots_menu_has_it() -> None:
    async with planted() as it:
        await it.press("tab", "enter")
        await it.shows("Explain why it")
        await it.press("j", "j", "j", "j", "j", "enter")
        await it.shows("▶ 1. no orders")


async def test_an_order_for_a_low_battery_has_the_way_to_the_charger() -> None:
    async with planted(1, 1) as it:
        form = it.app.main.query_one(OrderForm)
        robot = it.fleet.world.robots["robot_0"]
        robot.battery, robot.pose = 15.0, replace(robot.pose, x=robot.pose.x + 3.0)
        await it.until(lambda state: state.alarms)
        await it.press("o")
        assert [field.value for field in form.query(Input)] == ["robot_0", "", ""], "as always"
        await it.press("escape", "w")
        await it.shows("battery 1")
        await it.press("o")
        await it.shows("To      Charger")
        assert [field.value for field in form.query(Input)][2] == "Charger"
        assert it.sent == [], "it is only proposed"
        await it.press("enter")
        await it.until(lambda state: state.robots["robot_0"].orders.orders)


async def test_long_lines_go_on_as_far_in_as_they_began() -> None:
    async with planted(1, 1, (60, 24)) as it:
        it.fleet.plant("battery:robot_0")
        await it.press("w")
        await it.shows("the robot may reserve the rest")
        await it.shows("\n│     a charger, reported ")


async def test_reasons_that_a_small_screen_cuts_are_reached_by_scrolling(server: RosbridgeServer) -> None:
    plant(server, "battery:robot_0,obstacle:robot_0")
    async with console(config_of(server.url, 1, 1), (60, 16)) as it:
        await it.press("w")
        await it.shows("1. obstacle")
        await it.hides("3. ")
        await it.press(*["down"] * 9)
        await it.shows("3. ")
        await it.press(*["k"] * 9)
        await it.shows("1. obstacle")


async def test_the_outcome_of_a_key_is_in_view_below_it() -> None:
    async with planted(1, 1, (80, 24)) as it:
        await it.press("w", "p")
        await it.shows("robot_0 pause: ")


@pytest.mark.parametrize("key", ["w", "i"])
async def test_an_alarm_is_acknowledged_where_it_is_read(key: str) -> None:
    async with planted(2) as it:
        it.fleet.world.robots["robot_1"].battery = 5.0
        await it.until(lambda state: state.unacknowledged)
        await it.press("!", key, "a")
        await it.until(lambda state: not state.unacknowledged)


async def test_errors_of_its_own_diagnostics_are_received_while_it_is_open(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        order = place_order("robot_0", CONSUMIDORES, BASE)
        it.app.backend.submit(order)
        await it.until(lambda state: state.robots["robot_0"].orders.current is not None)
        plant(server, "stuck:robot_0")
        for key in "wi":
            await it.press(key)
            await it.shows("drive: ERROR no odometry")
            await it.press("escape")
            await it.until(lambda _: not server.bridge.subscribers("/diagnostics"))


async def test_diagnostics_open_where_the_first_cause_is(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        it.app.backend.submit(place_order("robot_1", CONSUMIDORES, BASE))
        await it.until(lambda state: state.robots["robot_1"].orders.current is not None)
        plant(server, "stuck:robot_1")
        await it.press("1", "w")
        await it.shows("1. drive: ERROR wheels turn")
        await it.shows("2. drive: ERROR no odometry")
        await it.press("d")
        await it.shows("Robot log")
        it.app.main.features.diagnostics.show("robot_1", Reason(Message("no odometry"), EMPTY, page="health"))
        await it.shows("Robot diagnostics")
        await it.shows("▸✗ ERROR", "diagnostics-rows")
        marked = next(line for line in it.pane("diagnostics-rows").splitlines() if "▸" in line)
        assert "robot_1" in marked


async def test_in_a_small_box_evidence_gives_way_to_further_causes_and_a_sign_tells_of_more(
    server: RosbridgeServer,
) -> None:
    plant(server, "obstacle:robot_1,paused:robot_1,battery:robot_1")
    async with console(config_of(server.url, 2, 2), (80, 24)) as it:
        await it.press("1", "w")
        await it.shows("4. battery: ERROR empty")
        await it.shows("  (likely)")
        assert len(REPORTED.findall(it.text)) == 1, "further causes are without evidence"
        await it.pilot.resize_terminal(80, 18)
        await it.shows(", PgUp PgDn")
        await it.press("pagedown")
        await it.hides("▶ 1. paused")
        await it.pilot.resize_terminal(200, 80)
        await it.shows("▶ 1. paused")
        await it.hides("PgUp PgDn")
        assert len(REPORTED.findall(it.text)) > 1
