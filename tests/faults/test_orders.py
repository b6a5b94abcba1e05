"""Outcomes of sent commands: each end is reported, also an end caused by another client."""

from pathlib import Path

import pytest

from fleet_tui.model.commands import ClearOrders, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order_life import BLIND_AFTER
from fleet_tui.records.audit.elsewhere import watched_commands
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import Audit
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fault_report import report
from tests.support.fleets import place_order
from tests.support.invariants import linked
from tests.support.links import finished, ready
from tests.support.links import linked as plainly_linked
from tests.support.proxied_link import Holds, Stopwatch, lost, through, usual
from tests.support.shown_text import shown

ORDER = place_order("robot_0", 19, 0)
FAR = place_order("robot_0", 0, 19)
"""An order that ends far from where the robot is."""


def stage(wanted: Stage) -> Holds:
    """The newest command stands there."""
    return lambda state: state.commands and state.commands[-1].stage is wanted


def alarms(state: FleetState) -> list[str]:
    """The alarms of commands to robot_0."""
    found = [alarm for alarm in state.alarms if alarm.key == ("robot_0", "command")]
    return [alarm.text for alarm in found if alarm.needs_acknowledgement]


async def test_a_robots_node_restarts_with_open_orders(server: RosbridgeServer) -> None:
    play(server, [("restart", "robot_0")])
    robot = server.world.robots["robot_0"]
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, ORDER)).stage is Stage.CONFIRMED
        await store.until(lambda _: not robot.last_order_id)
        watch = Stopwatch(store)
        noticed = await watch.until(stage(Stage.LOST))
        state = await store.until(alarms)
        assert alarms(state) == [
            "lost: order Consumidores -> Base (order 1: the robot restarted: its order ids started over)"
        ]
        assert (
            "robot_0 order Consumidores -> Base: lost (order 1: the robot restarted: its order ids"
            in shown(state)
        )
    report(
        "a robot's node restarts with open orders",
        "its queue is empty, ids start at 0",
        "lost, an alarm",
        noticed,
        None,
    )


async def test_an_order_is_taken_long_after_it_was_accepted(server: RosbridgeServer) -> None:
    play(server, [("obeys-late", "robot_0")])
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, ORDER)
        assert record.stage is Stage.NOT_CONFIRMED
        await store.until(lambda _: server.world.robots["robot_0"].orders)
        watch = Stopwatch(store)
        noticed = await watch.until(stage(Stage.LATE))
        state = await store.until(
            lambda state: [text for text in alarms(state) if text.startswith("carried")]
        )
        (text,) = alarms(state)
        assert text.startswith("carried out late: order Consumidores -> Base (order 1, ")
        assert "not confirmed" not in shown(state)
        assert len(server.bridge.services.calls) == 1
    seen = "not confirmed; then, in its place, carried out late"
    report("an order is carried out late", "12 s after it was accepted", seen, noticed, None)


async def test_a_node_dies_during_the_call(server: RosbridgeServer) -> None:
    play(server, [("dies", "robot_0")])
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        watch = Stopwatch(store)
        link.submit(ORDER)
        noticed = await watch.until(
            lambda state: state.commands and state.commands[-1].time_of(Stage.UNKNOWN)
        )
        healed = await watch.until(stage(Stage.CONFIRMED))
        stages = [step.stage for step in store.state.commands[-1].steps]
        assert stages == [Stage.CHECKED, Stage.SENT, Stage.UNKNOWN, Stage.CONFIRMED]
        assert not alarms(store.state)
    seen = "outcome unknown; confirmed once the order is seen in the queue"
    report("a node dies during the call", "after it has accepted the order", seen, noticed, healed)


async def test_an_order_whose_handler_throws(server: RosbridgeServer) -> None:
    play(server, [("throws", "robot_0")])
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        watch = Stopwatch(store)
        link.submit(ORDER)
        await store.until(lambda state: state.commands and state.commands[-1].time_of(Stage.UNKNOWN))
        noticed = await watch.until(stage(Stage.NOT_CONFIRMED))
        state = await store.until(alarms)
        assert "no route" in alarms(state)[0] and "order not in the queue" in alarms(state)[0]
    seen = "outcome unknown, then not confirmed, with the text of the exception"
    report("a node raises an exception in the call", "it does not accept the order", seen, noticed, None)


async def test_another_console_cancels(server: RosbridgeServer) -> None:
    play(server, [("foreign-cancel", "robot_0")])
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, ORDER)).stage is Stage.CONFIRMED
        await store.until(lambda _: not server.world.robots["robot_0"].orders)
        watch = Stopwatch(store)
        noticed = await watch.until(stage(Stage.CANCELLED_ELSEWHERE))
        state = await store.until(alarms)
        assert alarms(state) == [
            "cancelled elsewhere: order Consumidores -> Base (order 1: as reported by the robot)"
        ]
        assert ": cancelled elsewhere" in shown(state)
    seen = "cancelled elsewhere, an alarm"
    report("another console cancels an order", "the robot lists it as cancelled", seen, noticed, None)


async def test_another_console_of_this_machine_clears(server: RosbridgeServer, tmp_path: Path) -> None:
    config = usual(server.url, 2)
    async with linked(config) as (link, store), plainly_linked(config) as (other, other_store):
        await store.until(ready)
        await other_store.until(ready)
        audit = Audit(audit_file(tmp_path / FILE_NAME), Origin("ben", "host:2", "run2"))
        other_store.watchers.append(audit.watch)
        with watched_commands(tmp_path, store, link.post, "host:1"):
            assert (await finished(link, store, ORDER)).stage is Stage.CONFIRMED
            watch = Stopwatch(store)
            assert (await finished(other, other_store, ClearOrders("robot_0"))).stage is Stage.CONFIRMED
            noticed = await watch.until(stage(Stage.CANCELLED_ELSEWHERE))
        other_store.watchers.clear()
        assert audit.close(other_store.state) == 0
        state = await store.until(alarms)
        assert alarms(state) == [
            "cancelled elsewhere: order Consumidores -> Base (order 1: cleared by ben at host:2)"
        ]
    seen = "cancelled elsewhere, with the operator and the console"
    report("another console clears a queue", "its audit log has the command", seen, noticed, None)


async def test_an_order_leaves_the_queue_and_nothing_tells_why(server: RosbridgeServer) -> None:
    robot = server.world.robots["robot_0"]
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, FAR)).stage is Stage.CONFIRMED
        watch = Stopwatch(store)
        robot.drop({order.id for order in robot.orders})
        noticed = await watch.until(stage(Stage.LEFT))
        (text,) = alarms(await store.until(alarms))
        assert text.startswith("left the queue: order Base -> Consumidores (order 1: not by this console, ")
    seen = "left the queue, not by this console; no advice to order again"
    report("an order leaves the queue", "removed by a client without a desk", seen, noticed, None)


async def test_an_order_that_ended_while_the_link_was_away_is_told_later(server: RosbridgeServer) -> None:
    robot = server.world.robots["robot_0"]
    async with through(server) as (proxy, link, store, watch):
        assert (await finished(link, store, FAR)).stage is Stage.CONFIRMED
        (order,) = robot.orders
        await proxy.refuse()
        await store.until(lost("connection refused"))
        robot.drop({order.id})
        away = store.state.now
        await store.until(lambda state: state.now - away > BLIND_AFTER + 1.0)
        await proxy.listen()
        watch.start()
        noticed = await watch.until(stage(Stage.LOST))
        assert alarms(await store.until(alarms))[0].startswith("lost: order Base -> Consumidores (order 1: ")
        order.status = "D"
        robot.ended = [order]
        watch.start()
        healed = await watch.until(stage(Stage.DONE))
        assert store.state.commands[-1].detail == "order 1: as reported by the robot; corrects: lost"
        await store.until(lambda state: not alarms(state))
    seen = "lost; once the robot lists its end done, and the alarm goes"
    report("an order ends while the link is away", "its end is listed later", seen, noticed, healed)


async def test_another_console_pauses(server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "120")  # a narrower one has a sign for the words
    play(server, [("foreign-pause", "robot_0")])
    robot = server.world.robots["robot_0"]
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, ORDER)).stage is Stage.CONFIRMED
        await store.until(lambda _: robot.paused)
        watch = Stopwatch(store)
        noticed = await watch.until(lambda state: "paused (elsewhere)" in shown(state))
        await store.until(lambda _: not robot.paused)
        watch.start()
        healed = await watch.until(lambda state: "paused" not in shown(state))
        assert store.state.commands[-1].has_open_order
    report(
        "another console pauses a robot",
        "the robot reports that it is paused",
        "paused (elsewhere)",
        noticed,
        healed,
    )
