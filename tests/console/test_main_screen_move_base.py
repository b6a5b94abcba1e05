"""Robots with move_base on the screen: orders of two stops, goals of others, a pause of all."""

from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from fleet_tui.model.commands import Stage
from tests.support.console_pilot import console
from tests.support.move_base_site import MoveBaseSite, move_base_site
from tests.support.nav2_site import placed


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[MoveBaseSite]:
    async with move_base_site(tmp_path) as running:
        yield running


async def test_an_order_of_two_stops_by_keyboard_is_driven_to_its_end(site: MoveBaseSite) -> None:
    async with console(site.config) as it:
        await it.until(lambda state: all(robot.goals and robot.pose for robot in state.robots.values()))
        await it.press("o")
        await it.type("Consum")
        await it.press("enter")
        await it.type("Base")
        await it.press("enter")
        await it.shows("Consumidores -> Base", "queue")
        await it.shows("Queue robot_0 1 order", "queue")
        await it.until(lambda state: placed(state) and placed(state)[0].stage is Stage.DONE)
    assert len({goal["goal_id"]["id"] for goal in site.navigation().received}) == 2


async def test_pausing_all_names_whose_goals_were_stopped(site: MoveBaseSite) -> None:
    async with console(site.config) as it:
        await it.until(lambda state: all(robot.goals and robot.pose for robot in state.robots.values()))
        site.navigation("robot_1").give(35.0, 20.0)
        await it.shows("-> Consumidores (else", "fleet")
        await it.press("P")
        await it.shows("pause all: 2 confirmed, goals of other clients stopped", "message")
        await it.shows("resumable from here (robot_1)", "message")
