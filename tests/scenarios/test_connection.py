"""The connection breaks, or the robot starts anew: the queue decides, and nothing is sent twice or late."""

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.ordering import place
from tests.support.scenario import R0, calls, ended, hasty, heard_anew, patient, plant, stages

SENT = [Stage.CHECKED, Stage.SENT]


def is_lost(state: FleetState) -> bool:
    return not any(link.phase.value == "up" for link in state.links.values())


def pose(stage: Stage, state: FleetState) -> bool:
    return bool(state.commands) and state.commands[-1].stage is stage


async def test_carried_out_but_the_answer_was_lost(server: RosbridgeServer) -> None:
    plant(server, "drop")
    async with console(patient(server.url)) as it:
        await place(it)
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.UNKNOWN, Stage.CONFIRMED]
        await it.shows("Base -> Consumidores: confirmed (seen in the queue as order 1)", "message")
        await it.shows("Base -> Consumidores", "queue")
        await heard_anew(it)
        assert calls(server) == ["Execute_order"]
        assert len(server.world.robots[R0].orders) == 1


async def test_neither_carried_out_nor_answered(server: RosbridgeServer) -> None:
    plant(server, "never")
    async with console(hasty(server.url, 1.5)) as it:
        await place(it)
        await it.until(lambda _: server.bridge.services.calls)
        await server.drop_clients()
        await it.shows("outcome unknown", "message")
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.UNKNOWN, Stage.NOT_CONFIRMED]
        assert record.detail.endswith("order not in the queue")
        await it.shows("Base -> Consumidores: not confirmed (outcome unknown", "message")
        await heard_anew(it)
        assert calls(server) == ["Execute_order"]


async def test_a_pause_whose_answer_was_lost(server: RosbridgeServer) -> None:
    plant(server, "drop")
    async with console(patient(server.url)) as it:
        await it.press("p")
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.UNKNOWN, Stage.CONFIRMED]
        await it.shows("paused", "fleet")
        await heard_anew(it)
        assert calls(server) == ["Pause"]


async def test_the_server_comes_back_with_nothing_in_its_memory() -> None:
    """An order was under way when it went down: it is not there, and not sent again."""
    first = RosbridgeServer(OhFleet(robots=1, floors=1, seed=1, quiet=True))
    await first.start()
    plant(first, "never")
    async with console(hasty(first.url, 1.5)) as it:
        await place(it)
        await it.until(lambda _: first.bridge.services.calls)
        await first.stop()
        await it.shows("outcome unknown", "message")
        await it.shows("no link")
        # What is wished for now is not kept for later.
        await place(it)
        await it.shows("not sent: robot_0 is unreachable", "missing")
        await it.press("escape", "r")
        await it.shows("not sent: robot_0 is unreachable", "message")
        assert len(it.store.state.commands) == 1
        second = RosbridgeServer(
            OhFleet(robots=1, floors=1, seed=1, quiet=True), port=int(first.url.rpartition(":")[2])
        )
        await second.start()
        await ended(it)
        record = it.store.state.commands[0]
        assert stages(record) == [*SENT, Stage.UNKNOWN, Stage.NOT_CONFIRMED]
        assert record.detail.endswith("order not in the queue")
        await heard_anew(it)
        await it.shows("no orders", "queue")
        assert calls(first) == ["Execute_order"]
        assert second.bridge.services.calls == []
        await second.stop()


async def test_a_robot_that_starts_anew_counts_from_nothing_again(server: RosbridgeServer) -> None:
    """The ids of before come again: the second order 1 is another one than the first."""
    plant(server, "restart:robot_0")
    async with console(patient(server.url)) as it:
        for count in (1, 2):
            await place(it)
            record = await ended(it, count)
            assert stages(record) == [*SENT, Stage.ACCEPTED, Stage.CONFIRMED]
            assert record.order_id == "1"
            await it.until(lambda state: not state.robots[R0].orders.orders)
        await it.shows("no orders", "queue")
        await it.press("w")
        await it.shows("▶ 1. lost: order")
        assert calls(server) == ["Execute_order", "Execute_order"]
