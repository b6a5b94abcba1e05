"""`order A B --until-done` of a robot that takes one stop at a time: this command gives the next one."""

from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from tests.support.cli import run
from tests.support.move_base_site import MoveBaseSite, move_base_site

ORDER = ("order", "robot_0", "Consumidores", "Base", "--until-done")


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[MoveBaseSite]:
    """Two robots with move_base, and a configuration for them in a file."""
    async with move_base_site(tmp_path) as running:
        (floor,) = running.config.floors
        (tmp_path / "config.toml").write_text(
            f'[rosbridge]\nurl = "{running.server.url}"\n[alarms]\nno_answer_after = 1.0\n'
            f'[profile]\nkind = "move_base"\n[[floors]]\nname = "floor_0"\ngraph = "{floor.graph}"\n'
            '[[robots]]\nname = "robot_0"\n[[robots]]\nname = "robot_1"\n'
        )
        yield running


async def test_it_stays_until_the_last_stop_is_reached(site: MoveBaseSite, tmp_path: Path) -> None:
    done = await run(tmp_path, *ORDER)
    assert (done.code, done.err) == (0, "")
    assert "robot_0 order Consumidores -> Base: done" in done.out
    assert len({goal["goal_id"]["id"] for goal in site.navigation().received}) == 2


async def test_it_ends_when_the_next_stop_is_refused(site: MoveBaseSite, tmp_path: Path) -> None:
    navigation = site.navigation()

    def refuse_the_second(_dt: float) -> None:
        navigation.rejects = bool(navigation.received)

    site.server.bridge.services.fleet_of("robot_0").troubles.append(refuse_the_second)
    done = await run(tmp_path, *ORDER, "--timeout", "60")
    assert done.code == 1 and "not done (refused: " in done.err


async def test_status_only_listens(site: MoveBaseSite, tmp_path: Path) -> None:
    done = await run(tmp_path, "status")
    assert "robot_0" in done.out and not site.advertised()


async def test_a_clear_loses_no_goal_of_others(site: MoveBaseSite, tmp_path: Path) -> None:
    site.server.speed = 1.0
    site.navigation().give(35.0, 20.0)
    done = await run(tmp_path, "clear", "robot_0")
    assert "robot_0 has no orders of this console" in done.err and "would lose" not in done.err
