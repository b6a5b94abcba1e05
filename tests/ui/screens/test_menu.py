"""Menus of rows: by number, by mark, and once."""

from functools import partial

import pytest

from fleet_tui.model.commands import PauseRobot
from fleet_tui.text.language import Message, verbatim
from tests.support.ordering import one_packet
from tests.support.planted_console import in_the_way, planted


async def test_the_menu_of_a_row_goes_to_the_robot() -> None:
    async with in_the_way("robot_1") as it:
        await it.shows("▲ new  high   robot_1 obstacle 44 s", "alarms")
        it.app.main.alarms.focus()
        await it.press("enter")
        await it.shows("robot_1: obstacle 44 s")
        await it.shows("2  Show robot_1 on the map")
        (alarm,) = it.store.state.alarms
        await it.shows(f"first seen {it.app.main.settings.clock(alarm.first_wall)}, last seen ")
        await it.press("1")
        await it.shows("Queue robot_1", "queue")
        assert "robot_1" in it.app.main.navigation.robot


async def test_the_menu_acknowledges_by_number_and_names_the_key() -> None:
    async with in_the_way("robot_0") as it:
        it.app.main.alarms.focus()
        await it.press("enter")
        await it.shows("5  Acknowledge (a)")
        await it.press("5")
        await it.shows("acknowledged: obstacle alarm of robot_0")
        await it.until(lambda state: state.unacknowledged == 0)
        await it.shows("△ seen high   robot_0 obstacle 44 s", "alarms")
        await it.press("enter")
        await it.shows("Shelve for")
        assert "Acknowledge" not in it.text


async def test_an_alarm_that_is_over_has_no_menu() -> None:
    async with planted() as it:
        it.app.main.features.alarms.menu("robot_0", "obstacle")
        await it.shows("the alarm of robot_0 has cleared")


async def test_two_enters_in_a_menu_do_it_once() -> None:
    async with planted() as it:
        await it.press("tab", "enter", "j")
        one_packet(it, "\r\r")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        await it.pilot.pause()
        assert it.sent == [PauseRobot("robot_0")]


async def test_the_keys_of_entries_choose_them_for_the_robot_of_the_menu() -> None:
    async with planted(2) as it:
        it.app.main.fleet.focus()
        await it.press("down", "enter")
        await it.shows("Explain why it is not moving (w)")
        await it.press("w")
        await it.shows("Why: robot_1")
        await it.hides("Explain why it is not moving (w)")
        await it.press("escape", "enter", "z")
        await it.shows("Pause (p)")
        await it.press("p")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert [record.command.robot for record in it.store.state.commands] == ["robot_1"]


@pytest.mark.parametrize("screen", ["d", "H", "J", "B", "w", "i"])
async def test_all_robots_are_paused_from_every_screen(screen: str) -> None:
    async with planted(2) as it:
        await it.press(screen, "P")
        await it.until(lambda state: all(state.is_paused(robot) for robot in state.robots.values()))
        assert it.sent == [PauseRobot("robot_0"), PauseRobot("robot_1")]


@pytest.mark.parametrize("many", [2, 12])
async def test_a_list_of_things_filters_as_one_types_and_no_letter_is_a_command(many: int) -> None:
    async with planted() as it:
        chosen: list[int] = []
        entries = [(verbatim(f"place {n} (p)"), partial(chosen.append, n)) for n in range(many)]
        it.app.main.features.menu.show(Message("Places"), entries, searched=True)
        await it.shows("Choose")
        await it.type("p 1")
        await it.hides("place 0")
        await it.press("enter")
        assert chosen == [1] and it.sent == []


async def test_actions_keep_their_keys_however_many_they_are() -> None:
    async with planted() as it:
        chosen: list[int] = []
        entries = [
            (verbatim(f"action {n} ({'abcdefghilmn'[n]})"), partial(chosen.append, n)) for n in range(12)
        ]
        it.app.main.features.menu.show(Message("Actions"), entries)
        await it.shows("9  action 8")
        await it.press("m")
        await it.hides("action 8")
        it.app.main.features.menu.show(Message("Actions"), entries)
        await it.press("9")
        await it.hides("action 8")
        assert chosen == [10, 8] and it.sent == []
