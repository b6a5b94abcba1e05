"""Orders to robots with Nav2 that must not leave: what was given at the same moment, and what overtook it."""

import asyncio
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.start import initial_state
from fleet_tui.links.queue_file import WaitingOrder
from fleet_tui.links.rosbridge import goal_channel
from fleet_tui.links.waiting_orders import WaitingOrders
from fleet_tui.model.commands import RESTARTED, ClearOrders, Command, PauseRobot, Stage
from fleet_tui.model.events import CommandIssued
from fleet_tui.orders.local_queue import waiting
from fleet_tui.state.store import Store
from tests.support.fleets import R0
from tests.support.links import finished, linked
from tests.support.nav2_site import Site, keeping, nav2_ready, reached
from tests.support.queue_files import kept


@pytest.fixture
def slow(monkeypatch: pytest.MonkeyPatch) -> asyncio.Event:
    """The connections on which goals are given open when this is set."""
    opens = asyncio.Event()
    opened = goal_channel.GoalChannel.open

    async def late(channel: goal_channel.GoalChannel) -> None:
        await opened(channel)
        await opens.wait()

    monkeypatch.setattr(goal_channel.GoalChannel, "open", late)
    return opens


async def test_of_two_orders_given_at_once_the_second_waits_for_the_first(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        first, second = link.submit(site.to("Receiving")), link.submit(site.to("Base"))
        looked = await reached(store, second, *set(Stage) - {Stage.CHECKED})
        assert looked.stage is Stage.WAITING
        await reached(store, first, Stage.DONE)
        await reached(store, second, Stage.DONE)


@pytest.mark.parametrize(
    ("overtaking", "detail"),
    [
        (PauseRobot(R0), "robot paused before it was sent"),
        (ClearOrders(R0), "robot's orders cleared before it was sent"),
    ],
)
async def test_what_overtakes_an_order_that_has_not_left_keeps_it_from_leaving(
    site: Site, slow: asyncio.Event, overtaking: Command, detail: str
) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        order = link.submit(site.to("Receiving"))
        await reached(store, link.submit(overtaking), Stage.ACCEPTED, Stage.CONFIRMED)
        slow.set()
        ended = await reached(store, order, Stage.NOT_SENT, Stage.SENT, Stage.CONFIRMED)
        assert (ended.stage, ended.detail) == (Stage.NOT_SENT, detail)
        assert not site.navigation().received


async def test_who_begins_to_keep_orders_later_takes_up_what_the_one_before_left(
    site: Site, tmp_path: Path
) -> None:
    theirs = keeping(tmp_path, "bea")
    assert theirs.claim()
    theirs.save([WaitingOrder(site.server.url, R0, site.to("Base").stops, 1.7e9)])
    async with linked(site.config, queue=keeping(tmp_path)) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Consumidores"))
        theirs.close()
        await reached(store, link.submit(site.to("Receiving")), Stage.WAITING)
        state = await store.until(lambda state: state.robots[R0].held == RESTARTED)
        assert len(waiting(state, state.robots[R0])) == 2
        await store.until(lambda _: len(kept(tmp_path)) == 2)


async def test_what_waits_for_a_robot_that_keeps_its_own_queue_now_stays_in_the_file(
    site: Site, tmp_path: Path
) -> None:
    file = keeping(tmp_path)
    before = [WaitingOrder(site.server.url, R0, site.to("Base").stops, 1.7e9)]
    assert file.claim()
    file.save(before)
    state = initial_state(site.config, 0.0)
    changed = replace(state.robots[R0], kind=replace(state.robots[R0].kind, keeps_goals=False))
    store = Store(replace(state, robots={**state.robots, R0: changed}))
    orders = WaitingOrders(file, store, store.apply, lambda *_: None, lambda _: None, lambda: 1)
    orders.load()
    orders.tick(0.1)
    assert not store.state.commands and file.load() == before


async def test_an_order_given_just_before_the_console_ends_is_kept(site: Site, tmp_path: Path) -> None:
    file = keeping(tmp_path)
    store = Store(initial_state(site.config, 0.0))
    orders = WaitingOrders(file, store, store.apply, lambda *_: None, lambda _: None, lambda: 1)
    orders.load()
    for id_ in (1, 2):
        store.apply(CommandIssued(id_, site.to("Base"), float(id_), 1.7e9))
    assert orders.handles(2, site.to("Base"), 2.0)
    orders.close()
    assert file.claim() and [one.robot for one in file.load()] == [R0]
