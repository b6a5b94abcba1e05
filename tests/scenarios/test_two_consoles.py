"""Two consoles command the same robot: each command ends once in each, and both show the same robot."""

import time
from collections.abc import AsyncIterator
from contextlib import ExitStack, asynccontextmanager
from pathlib import Path

import pytest

from fleet_tui.commands.rivals import rivals_text
from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, CommandRecord, PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.elsewhere import watched_commands
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import Audit
from fleet_tui.simulator import robot
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.fleets import place_order
from tests.support.ordering import place
from tests.support.scenario import R0, calls, ended, patient, requests, stages
from tests.support.watched_store import WatchedStore

SENT = [Stage.CHECKED, Stage.SENT]
BASE, CONSUMIDORES = 0, 19


class Other:
    """The other console, without a screen."""

    def __init__(self, link: FleetLink, store: WatchedStore) -> None:
        self.link, self.store = link, store

    async def ended(self, count: int = 1) -> CommandRecord:
        def holds(state: FleetState) -> bool:
            return len(state.commands) == count and all(record.is_decided for record in state.commands)

        return (await self.store.until(holds)).commands[-1]


@asynccontextmanager
async def other_console(url: str) -> AsyncIterator[Other]:
    config = patient(url)
    store = WatchedStore(initial_state(config, time.monotonic()))
    link = FleetLink(config, store)
    link.open()
    await store.until(lambda state: state.robots[R0].queue)
    yield Other(link, store)
    link.close()


async def test_the_same_order_from_both_is_two_orders(server: RosbridgeServer) -> None:
    async with console(patient(server.url)) as it, other_console(server.url) as other:
        other.link.submit(place_order(R0, BASE, CONSUMIDORES))
        await place(it)
        for record in (await ended(it), await other.ended()):
            assert stages(record) == [*SENT, Stage.ACCEPTED, Stage.CONFIRMED]
        assert calls(server) == ["Execute_order", "Execute_order"]
        assert len(set(requests(server))) == 2
        await it.until(lambda state: len(state.robots[R0].orders.orders) == 2)
        await it.shows("queued", "queue")
        assert it.pane("queue").count("Base -> Consumidores") == 2


async def test_an_order_of_the_other_one_is_shown_and_can_be_cancelled(server: RosbridgeServer) -> None:
    async with console(patient(server.url)) as it, other_console(server.url) as other:
        other.link.submit(place_order(R0, BASE, CONSUMIDORES))
        await other.ended()
        await it.shows("Base -> Consumidores", "queue")
        await it.press("x", "y")
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.ACCEPTED, Stage.CONFIRMED]
        await it.shows("cancel order 1: confirmed (no longer in the queue)", "message")
        # All that the other console sees of it is that the order is gone.
        await other.store.until(lambda state: state.commands[0].stage is Stage.LEFT)
        assert other.store.state.commands[0].detail.startswith("order 1: not by this console, ")


@pytest.mark.parametrize("removal", [CancelOrder(R0, "1"), ClearOrders(R0)])
async def test_an_order_that_another_console_of_this_machine_removed_is_told_with_its_author(
    server: RosbridgeServer, tmp_path: Path, removal: Command
) -> None:
    """Its audit log is the evidence; the robot only shows that the order is gone."""
    async with other_console(server.url) as ana, other_console(server.url) as ben:
        audit = Audit(audit_file(tmp_path / FILE_NAME), Origin("ben", "host:2", "run2"))
        ben.store.watchers.append(audit.watch)
        with watched_commands(tmp_path, ana.store, ana.link.post, "host:1"):
            ana.link.submit(place_order(R0, BASE, CONSUMIDORES))
            await ana.ended()
            ben.link.submit(removal)
            await ben.ended()
            ended = await ana.store.until(lambda state: not state.commands[0].has_open_order)
        record = ended.commands[0]
        verb = "cancelled" if isinstance(removal, CancelOrder) else "cleared"
        assert (record.stage, record.detail) == (
            Stage.CANCELLED_ELSEWHERE,
            f"order 1: {verb} by ben at host:2",
        )
        ben.store.watchers.clear()
        assert audit.close(ben.store.state) == 0


async def test_two_who_command_a_robot_at_once_see_who_else_did_without_a_desk(
    server: RosbridgeServer, tmp_path: Path
) -> None:
    """The audit log of their machine tells it, to both."""
    async with other_console(server.url) as ana, other_console(server.url) as ben:
        audits = []
        with ExitStack() as watched:
            for one, name, console in ((ana, "ana", "host:1"), (ben, "ben", "host:2")):
                audit = Audit(audit_file(tmp_path / FILE_NAME), Origin(name, console, f"run of {name}"))
                one.store.watchers.append(audit.watch)
                audits.append((audit, one))
                watched.enter_context(watched_commands(tmp_path, one.store, one.link.post, console))
            ana.link.submit(place_order(R0, BASE, CONSUMIDORES))
            ben.link.submit(PauseRobot(R0))
            state = await ana.store.until(lambda state: rivals_text(state, R0))
            assert rivals_text(state, R0) == "ben at host:2: pause"
            state = await ben.store.until(lambda state: rivals_text(state, R0))
            assert rivals_text(state, R0) == "ana at host:1: order"
        for audit, one in audits:
            one.store.watchers.clear()
            assert audit.close(one.store.state) == 0


async def test_both_cancel_the_same_order(server: RosbridgeServer) -> None:
    """Only one can; the other is told so in the robot's own words."""
    async with console(patient(server.url)) as it, other_console(server.url) as other:
        await place(it)
        await ended(it)
        await it.shows("Base -> Consumidores", "queue")
        await it.press("x")
        await it.shows("Cancel order 1 of robot_0?")
        server.bridge.muted.add(f"/{R0}/queue")  # else a slow hand hears of it before it answers
        other.link.submit(CancelOrder(R0, "1"))
        await it.until(lambda _: len(server.bridge.services.calls) == 2)
        await it.press("y")
        record = await ended(it, 2)
        server.bridge.muted.clear()
        first = await other.ended()
        assert stages(first) == [*SENT, Stage.ACCEPTED, Stage.CONFIRMED]
        assert stages(record) == [*SENT, Stage.REFUSED]
        await it.shows("cancel order 1: refused (REJECTED: no order 1)", "message")
        await it.shows("no orders", "queue")


async def test_one_clears_while_the_other_orders(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(robot, "LOADING", 600.0)  # with cargo on board an order is another question
    async with console(patient(server.url)) as it, other_console(server.url) as other:
        for count in (1, 2):
            await place(it)
            await ended(it, count)
        other.link.submit(ClearOrders(R0))
        assert stages(await other.ended()) == [*SENT, Stage.ACCEPTED, Stage.CONFIRMED]
        await it.shows("no orders", "queue")
        await place(it)
        assert (await ended(it, 3)).order_id == "3"
        assert len(calls(server)) == 4


async def test_a_pause_from_the_other_one_is_named_as_such(server: RosbridgeServer) -> None:
    async with console(patient(server.url)) as it, other_console(server.url) as other:
        other.link.submit(PauseRobot(R0))
        assert stages(await other.ended()) == [*SENT, Stage.ACCEPTED, Stage.CONFIRMED]
        await it.shows("paused", "fleet")
        await it.press("w")
        await it.shows("not sent by this console")
        await it.press("r")
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.ACCEPTED, Stage.CONFIRMED]
        await it.shows("▶ 1. no orders")
        await it.hides("paused", "fleet")
        assert calls(server) == ["Pause", "Resume"]
