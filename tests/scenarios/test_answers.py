"""A robot that refuses, answers late, twice, never or under another call's id: each command ends once."""

import pytest

from fleet_tui.model.commands import Stage
from fleet_tui.simulator.faults import wire
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.ordering import place
from tests.support.scenario import NO_ANSWER_AFTER, R0, calls, ended, hasty, patient, plant, requests, stages

SENT = [Stage.CHECKED, Stage.SENT]


async def test_refused(server: RosbridgeServer) -> None:
    plant(server, "refuse")
    async with console(patient(server.url)) as it:
        await place(it)
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.REFUSED]
        assert record.detail == "REJECTED: the simulator was asked to refuse"
        await it.shows(
            "Base -> Consumidores: refused (REJECTED: the simulator was asked to refuse)", "message"
        )
        await it.shows("no orders", "queue")
        assert calls(server) == ["Execute_order"]


async def test_late_and_seen_before(server: RosbridgeServer) -> None:
    """The queue shows the order while its answer is on the way: that ends it, the answer adds nothing."""
    plant(server, "late")
    async with console(hasty(server.url)) as it:
        await place(it)
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.NO_ANSWER, Stage.CONFIRMED]
        await it.shows("Base -> Consumidores: confirmed (seen in the queue as order 1)", "message")
        later = record.at + 4 * NO_ANSWER_AFTER
        assert (await it.until(lambda state: state.now > later)).commands == (record,)
        await it.hides("no answer")
        assert calls(server) == ["Execute_order"]


async def test_late_and_refused(server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch) -> None:
    """After its deadline an answer is still the robot's word."""
    monkeypatch.setattr(wire, "LATE", 2 * NO_ANSWER_AFTER)
    plant(server, "refuse,late")
    async with console(hasty(server.url)) as it:
        await place(it)
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.NO_ANSWER, Stage.REFUSED]
        await it.shows("refused (REJECTED: the simulator was asked to refuse)", "message")
        await it.hides("no answer")
        assert calls(server) == ["Execute_order"]


async def test_twice(server: RosbridgeServer) -> None:
    plant(server, "twice")
    async with console(patient(server.url)) as it:
        await place(it)
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.ACCEPTED, Stage.CONFIRMED]
        # The answers to the pause come behind both answers to the order.
        await it.press("p")
        pause = await ended(it, 2)
        assert stages(pause) == [*SENT, Stage.ACCEPTED, Stage.CONFIRMED]
        assert it.store.state.commands[0] == record
        await it.shows("pause: confirmed by the robot", "message")
        assert calls(server) == ["Execute_order", "Pause"]
        assert len(server.world.robots[R0].orders) == 1


async def test_never(server: RosbridgeServer) -> None:
    plant(server, "never")
    async with console(hasty(server.url, 1.5)) as it:
        await place(it)
        await it.shows("Base -> Consumidores: no answer", "message")
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.NO_ANSWER, Stage.NOT_CONFIRMED]
        assert record.detail.endswith("order not in the queue")
        await it.shows("Base -> Consumidores: not confirmed (no answer: ", "message")
        await it.press("p")
        pause = await ended(it, 2)
        assert stages(pause) == [*SENT, Stage.NO_ANSWER, Stage.NOT_CONFIRMED]
        # On the screen a robot is only paused where it is.
        assert pause.detail.endswith("the robot reported no pause")
        assert calls(server) == ["Execute_order", "Pause"]


@pytest.mark.parametrize("key", ["order", "p"])
async def test_wrong_ids(server: RosbridgeServer, key: str) -> None:
    """An answer to nobody is no answer; what the robot then does is seen all the same."""
    plant(server, "wrong-id")
    async with console(hasty(server.url)) as it:
        await (place(it) if key == "order" else it.press(key))
        record = await ended(it)
        assert stages(record) == [*SENT, Stage.NO_ANSWER, Stage.CONFIRMED]
        await it.shows("confirmed ", "message")
        assert len(calls(server)) == 1


async def test_three_orders_with_an_answer_each_way(server: RosbridgeServer) -> None:
    """The same order three times is three orders: each record finds its own, under its own id."""
    plant(server, "wrong-id")
    async with console(hasty(server.url)) as it:
        for count in (1, 2, 3):
            await place(it)
            await ended(it, count)
        records = it.store.state.commands
        assert [record.order_id for record in records] == ["1", "2", "3"]
        assert len(set(requests(server))) == 3
        await it.shows("queued", "queue")
