"""Alarms by key and menu."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import msgspec

from fleet_tui.model.alarm import AlarmStage
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console, console
from tests.support.watched_store import config_of


@asynccontextmanager
async def in_the_way(server: RosbridgeServer, *names: str) -> AsyncIterator[Console]:
    """A console with robots that touch something for 4.2 s."""
    server.bridge.muted.update(f"/{name}/obstacle" for name in names)
    async with console(config_of(server.url, 2, 2)) as it:
        for name in names:
            server.bridge.publish_raw(f"/{name}/obstacle", {"data": 44.2})
        await it.shows(f"Alarms {len(names)} new", "alarms")
        yield it


def stages(it: Console) -> list[AlarmStage]:
    return [alarm.stage for alarm in it.store.state.alarms]


async def test_the_menu_of_a_row_goes_to_the_robot(server: RosbridgeServer) -> None:
    async with in_the_way(server, "robot_1") as it:
        await it.shows("▲ new  high robot_1 obstacle 44.2 s", "alarms")
        it.app.main.alarms.focus()
        await it.press("enter")
        await it.shows("robot_1: obstacle 44.2 s")
        await it.shows("2  Show robot_1 on the map")
        (alarm,) = it.store.state.alarms
        await it.shows(f"first seen {it.app.main.settings.clock(alarm.first_wall)}, last seen ")
        await it.press("1")
        await it.shows("Queue robot_1", "queue")
        assert "robot_1" in it.app.main.navigation.robot


async def test_the_menu_acknowledges_by_number_and_names_the_key(server: RosbridgeServer) -> None:
    async with in_the_way(server, "robot_0") as it:
        it.app.main.alarms.focus()
        await it.press("enter")
        await it.shows("3  Acknowledge (a)")
        await it.press("3")
        await it.until(lambda state: state.unacknowledged == 0)
        await it.shows("△ seen high robot_0 obstacle 44.2 s", "alarms")
        await it.press("enter")
        await it.shows("Shelve for")
        assert "Acknowledge" not in it.text


async def test_shelved_and_taken_off_the_shelf(server: RosbridgeServer) -> None:
    async with in_the_way(server, "robot_0") as it:
        it.app.main.alarms.focus()
        await it.press("enter")
        await it.shows("4  Shelve for 30 min")
        await it.press("4")
        await it.until(lambda state: state.shelved)
        await it.shows("Alarms 1 shelved", "alarms")
        await it.shows("0 alarms ", "status")
        await it.shows("◇ shelved until", "alarms")
        await it.press("enter")
        await it.shows("3  Unshelve")
        await it.press("3")
        await it.until(lambda state: state.unacknowledged == 1)
        await it.shows("1 alarm (1 new)", "status")


async def test_a_shelf_ends_by_itself(server: RosbridgeServer) -> None:
    server.bridge.muted.add("/robot_0/obstacle")
    config = config_of(server.url, 1)
    config = msgspec.structs.replace(
        config, alarms=msgspec.structs.replace(config.alarms, shelve_for=0.5, offline_after=60.0)
    )
    async with console(config) as it:
        server.bridge.publish_raw("/robot_0/obstacle", {"data": 44.2})
        await it.shows("robot_0", "alarms")
        it.app.main.alarms.focus()
        await it.press("enter", "4")
        await it.until(lambda state: state.shelved)
        await it.until(lambda state: not state.shelved)
        assert stages(it) == [AlarmStage.UNACKNOWLEDGED]


async def test_a_and_a_again_go_through_the_list(server: RosbridgeServer) -> None:
    async with in_the_way(server, "robot_0", "robot_1") as it:
        await it.shows("robot_1", "alarms")
        await it.press("a")
        await it.shows("2 alarms (1 new)", "status")
        await it.press("a")
        await it.shows("2 alarms ", "status")
        await it.hides("new)")


async def test_the_cursor_goes_to_what_nobody_has_seen(server: RosbridgeServer) -> None:
    """From any pane, `a` means it; while the list itself is read, the cursor stays."""
    server.bridge.muted.update(("/robot_0/obstacle", "/robot_1/obstacle"))
    async with console(config_of(server.url, 2, 2)) as it:
        server.bridge.publish_raw("/robot_0/obstacle", {"data": 44.2})
        await it.shows("robot_0", "alarms")
        await it.press("a")
        await it.shows("▸△ seen high robot_0", "alarms")
        server.bridge.publish_raw("/robot_1/obstacle", {"data": 44.2})
        await it.shows("▸▲ new  high robot_1", "alarms")
        it.app.main.alarms.focus()
        await it.press("j", "a")
        assert it.app.main.alarms.listing.cursor == ("robot_0", "obstacle")
        assert it.store.state.unacknowledged == 1


async def test_an_alarm_that_is_over_has_no_menu(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        it.app.main.rest.alarms.menu("robot_0", "obstacle")
        await it.shows("the alarm of robot_0 has cleared")
