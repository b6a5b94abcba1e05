"""Outcomes of sent commands: each end is reported, also an end caused by another client."""

import pytest

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.simulator.faults import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fault_report import report
from tests.support.fleets import place_order
from tests.support.invariants import linked
from tests.support.links import finished, ready
from tests.support.proxied_link import Holds, Stopwatch, usual
from tests.support.shown_text import shown

ORDER = place_order("robot_0", 19, 0)


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
