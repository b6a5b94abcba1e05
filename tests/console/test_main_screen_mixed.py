"""Robots of several kinds in one console: no kind's words or columns in another's rows, one pause for all."""

from collections.abc import AsyncIterator
from functools import partial
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.cli.status.report import report
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.alarms.conditions import conditions
from fleet_tui.situation.why.reason import Reason
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.fleet import fleet_table
from fleet_tui.ui.view.tables.queue import queue_table
from fleet_tui.ui.view.tables.table import Table
from tests.support.console_pilot import Console, console
from tests.support.mixed_site import MOVE_BASE, NAV2, OH, RMF, MixedSite, mixed_site

pytestmark = pytest.mark.nightly

KINDS = {OH: "oh_ressources", MOVE_BASE: "move_base", NAV2: "nav2", RMF: "rmf"}
WIDE = 400
"""Cells in which nothing is cut."""


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[MixedSite]:
    async with mixed_site(tmp_path) as running:
        yield running


def all_known(state: FleetState) -> bool:
    return all(robot.pose and robot.battery and robot.knows_all_graphs() for robot in state.robots.values())


def alone(state: FleetState, name: str) -> FleetState:
    """The same moment of a fleet that has this robot only."""
    commands = tuple(record for record in state.commands if record.command.robot == name)
    return replace(state, robots={name: state.robots[name]}, commands=commands)


def words(table: Table, robot: str) -> list[list[str]]:
    """The text of a robot's rows, whatever the width of the columns."""
    found = [
        row for row in table.rows if row.key == robot or (isinstance(row.key, tuple) and row.key[0] == robot)
    ]
    return ["".join(text for text, _ in row.runs).split() for row in found]


def drives(name: str, state: FleetState) -> bool:
    return state.robots[name].orders.current is not None


def told_of(state: FleetState, name: str) -> list[Reason]:
    """Reasons of a robot that name no other: who is in whose way has nothing to do with kinds."""
    return [one for one in reasons(state, state.robots[name]) if not one.name.startswith("waiting behind")]


async def busy(it: Console) -> FleetState:
    """Each robot has an order of two stops."""
    await it.until(all_known)
    for name in KINDS:
        await it.press("o")
        await it.type("Consum")
        await it.press("enter")
        await it.type("Store")
        await it.press("enter")
        await it.until(partial(drives, name))
        await it.press("right_square_bracket")
    return it.store.state


async def test_every_robot_reads_as_in_a_fleet_of_its_own_and_tells_what_its_kind_has(
    site: MixedSite,
) -> None:
    async with console(site.config) as it:
        state = await busy(it)
        for name in KINDS:
            by_itself = alone(state, name)
            assert words(fleet_table(state, name, WIDE), name) == words(
                fleet_table(by_itself, name, WIDE), name
            )
            for all_robots in (True, False):
                mixed, own = (queue_table(one, name, all_robots, WIDE) for one in (state, by_itself))
                assert words(mixed, name) == words(own, name) and words(own, name)
            # A robot in the way explains what alone nothing did.
            assert all(one in told_of(by_itself, name) for one in told_of(state, name))
            assert [one for one in conditions(state, {}) if one.source == name] == [
                one for one in conditions(by_itself, {}) if one.source == name
            ]
            (told,) = [one for one in report(state)["robots"] if one["name"] == name]
            assert told == report(by_itself)["robots"][0]
        told = {one["name"]: one for one in report(state)["robots"]}
        assert "cargo" not in told[NAV2] or told[NAV2]["cargo"] is None
        for name in KINDS:
            title = "".join(text for text, _ in queue_table(state, name, False, WIDE).title)
            assert title.startswith(f"Queue {name}")
        rows = {name: " ".join(words(fleet_table(state, name, WIDE), name)[0]) for name in KINDS}
        for name in (OH, MOVE_BASE):
            assert "stop 1 of" not in rows[name] and "m, " not in rows[name]
        for name in (MOVE_BASE, NAV2):
            assert "▪" not in rows[name] and "contact" not in rows[name]


async def test_one_pause_reaches_all_over_both_bridges(site: MixedSite) -> None:
    async with console(site.config) as it:
        await busy(it)
        await it.press("P")
        await it.shows("pause all: 4 confirmed", "message")
    ros1, ros2, _ = site.servers
    assert "/robot_0/Application_layout/Pause" in [service for service, _ in ros1.bridge.services.calls]
    assert [one["topic"] for one in ros1.bridge.received if one["op"] == "publish"][
        -1
    ] == "/robot_1/move_base/cancel"
    assert any(service.startswith("/robot_2/follow_waypoints/") for service, _ in ros2.bridge.services.calls)


async def test_all_are_on_one_map_and_in_one_queue(site: MixedSite) -> None:
    async with console(site.config) as it:
        state = await busy(it)
        assert {robot.floor for robot in state.robots.values()} == {"floor_0"}
        await it.press("*")
        for name in KINDS:
            await it.shows(name, "queue")
        labels = {
            frozenset(robot_map.labels.values())
            for robot in state.robots.values()
            for robot_map in robot.maps.values()
        }
        assert len(labels) == 1
