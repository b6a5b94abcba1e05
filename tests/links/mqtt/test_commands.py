"""Each command ends once, by the states that follow it."""

import asyncio
import json
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.links.mqtt import commands
from fleet_tui.model.commands import (
    ClearOrders,
    Command,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop
from tests.support.broker import RealBroker, broker_in
from tests.support.links import finished
from tests.support.mqtt_peer import Peer
from tests.support.polling import until
from tests.support.vda_broker import SpokenFor, console_on
from tests.support.vda_messages import BASE, error, message, node, position, state
from tests.support.watched_store import WatchedStore

ORDER = PlaceOrder("agv", (Stop(pose=Pose(5.0, 2.0)),))


async def seen(store: WatchedStore, vehicle: SpokenFor) -> None:
    vehicle.say()
    await store.until(lambda state: state.robots["agv"].vehicle)


async def given(link: FleetLink, store: WatchedStore, command: Command, stage: Stage) -> CommandRecord:
    """Give a command, and wait until it has reached a stage."""
    command_id = link.submit(command)
    found = await store.until(
        lambda state: any(one.id == command_id and one.stage is stage for one in state.commands)
    )
    return next(one for one in found.commands if one.id == command_id)


async def test_a_pause_is_confirmed_by_the_vehicle_and_lifted(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker, "pause") as (link, store):
            await seen(store, vehicle)
            waiting = asyncio.ensure_future(finished(link, store, PauseRobot("agv")))
            action = await vehicle.next("instantActions")
            assert (action["version"], action["serialNumber"]) == ("2.0.0", "0001")
            assert action["headerId"] != 1, "an old rejection may name that"
            assert action["actions"][0]["actionType"] == "startPause"
            vehicle.say(paused=True)
            assert (await waiting).stage is Stage.CONFIRMED
            waiting = asyncio.ensure_future(finished(link, store, ResumeRobot("agv")))
            assert (await vehicle.next("instantActions", 2))["headerId"] == action["headerId"] + 1
            vehicle.say(paused=False)
            assert (await waiting).stage is Stage.CONFIRMED
            refused = await finished(link, store, ORDER)
            assert (refused.stage, refused.detail) == (
                Stage.NOT_SENT,
                "links.broker.role is pause: no orders",
            )


async def test_an_order_is_taken_driven_and_done(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await seen(store, vehicle)
            waiting = asyncio.ensure_future(finished(link, store, ORDER))
            order = await vehicle.next("order")
            left = [node("goal_0", 2)]
            vehicle.say(orderId=order["orderId"], nodeStates=left)
            record = await waiting
            assert record.stage is Stage.CONFIRMED and record.name == order["orderId"]
            vehicle.say(orderId=order["orderId"])
            await store.until(lambda state: state.commands[-1].stage is Stage.DONE)
            assert store.state.robots["agv"].master is None


async def test_a_rejected_order_has_the_vehicles_reason(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await seen(store, vehicle)
            waiting = asyncio.ensure_future(finished(link, store, ORDER))
            order = await vehicle.next("order")
            old = error(type_="orderError", orderId="an older one")
            vehicle.say(errors=[old])
            own = error(type_="noRouteError", text="first node too far", orderId=order["orderId"])
            vehicle.say(errors=[old, own])
            record = await waiting
            assert (record.stage, record.detail) == (Stage.REFUSED, "noRouteError: first node too far")


async def test_a_cancellation_that_takes_long_is_no_missing_answer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await seen(store, vehicle)
            waiting = asyncio.ensure_future(finished(link, store, ORDER))
            order = (await vehicle.next("order"))["orderId"]
            left = [node("goal_0", 2)]
            vehicle.say(orderId=order, nodeStates=left)
            await waiting
            waiting = asyncio.ensure_future(finished(link, store, ClearOrders("agv")))
            id_ = (await vehicle.next("instantActions"))["actions"][0]["actionId"]
            action = {"actionId": id_, "actionType": "cancelOrder"}
            for _ in range(3):
                vehicle.say(
                    orderId=order, nodeStates=left, actionStates=[{**action, "actionStatus": "RUNNING"}]
                )
            vehicle.say(orderId=order, actionStates=[{**action, "actionStatus": "FINISHED"}])
            record = await waiting
            assert record.stage is Stage.CONFIRMED
            assert Stage.NO_ANSWER not in [step.stage for step in record.steps]
            await store.until(lambda state: state.commands[0].stage is Stage.CANCELLED)


async def test_silence_is_no_answer_and_a_late_one_counts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await seen(store, vehicle)
            record = await given(link, store, PauseRobot("agv"), Stage.NO_ANSWER)
            hint = 'or it needs instant_actions = "instantActions" in [profile.vda5050]'
            assert record.detail == f"from agv in 5 s, {hint}: may still be carried out"
            vehicle.say(paused=True)
            await store.until(lambda state: state.commands[-1].stage is Stage.CONFIRMED)


@pytest.mark.parametrize(
    ("version", "settings", "command"),
    [
        ("2.0.0", 'instant_actions = "actions"', PauseRobot("agv")),
        ("2.1.0", "", PauseRobot("agv")),
        ("2.0.0", "", ORDER),
    ],
)
async def test_only_where_the_field_of_an_action_is_open_a_missing_answer_names_its_setting(
    tmp_path: Path, version: str, settings: str, command: Command
) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker, settings=settings) as (link, store):
            vehicle.peer.publish(f"{BASE}/state", state(version, agvPosition=position()))
            await store.until(lambda state: state.robots["agv"].pose)
            record = await given(link, store, command, Stage.NO_ANSWER)
            assert record.detail == "from agv in 5 s: may still be carried out"


async def test_a_second_master_is_seen_and_ours_refused(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle, other = SpokenFor(broker), Peer(broker.port)
        async with console_on(broker) as (link, store):
            await seen(store, vehicle)
            other.publish(f"{BASE}/order", message(orderId="theirs", nodes=[], edges=[]))
            await store.until(lambda state: state.robots["agv"].master)
            record = await finished(link, store, ORDER)
            assert record.stage is Stage.NOT_SENT
            assert record.detail.startswith("another master control commands agv (order theirs")
            assert (await given(link, store, PauseRobot("agv"), Stage.SENT)).stage is Stage.SENT
        other.close()


async def test_nothing_leaves_without_a_broker_and_open_commands_end(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await seen(store, vehicle)
            await given(link, store, PauseRobot("agv"), Stage.SENT)
            broker.kill()
            await store.until(lambda state: state.commands[-1].stage is Stage.UNKNOWN)
            record = await finished(link, store, PauseRobot("agv"))
            assert (record.stage, record.detail) == (Stage.NOT_SENT, "no link")
            broker.start()
            again = SpokenFor(broker)
            again.say()
            await store.until(lambda state: state.is_online(state.robots["agv"]))
            assert again.told == []


async def test_a_frozen_broker_holds_orders_back_but_no_pause(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await seen(store, vehicle)
            broker.freeze()
            connection = link.links["broker"]._telemetry.connection  # type: ignore[attr-defined]  # of a broker
            await store.until(lambda _: connection.silence > commands.LONGEST_SILENCE)
            record = await finished(link, store, ORDER)
            assert record.stage is Stage.NOT_SENT and "no reply from the broker for" in record.detail
            await given(link, store, PauseRobot("agv"), Stage.SENT)
            await store.until(lambda state: state.links["broker"].reason == "broker not responding")
            broker.thaw()


class Mute(SpokenFor):
    """A vehicle whose connection topic is not kept, and whose state may be half a minute away."""

    def __init__(self, broker: RealBroker, base: str = BASE) -> None:
        self.base = base
        self.peer = Peer(broker.port, f"{base}/instantActions")

    async def action(self) -> dict[str, Any]:
        topic = f"{self.base}/instantActions"
        await until(lambda: self.peer.told_on(topic))
        found: dict[str, Any] = json.loads(self.peer.told_on(topic)[0])
        return found


async def test_a_pause_goes_out_to_a_vehicle_of_which_nothing_has_arrived_in_both_ways_to_write_it(
    tmp_path: Path,
) -> None:
    with broker_in(tmp_path) as broker:
        old = Mute(broker, BASE.replace("/v2/", "/v1/"))
        new = Mute(broker)
        async with console_on(broker, "pause") as (link, store):
            record = await given(link, store, PauseRobot("agv"), Stage.SENT)
            (first,), (second,) = (await new.action())["actions"], (await old.action())["instantActions"]
            assert first == second and first["actionType"] == "startPause"
            versions = [(await one.action())["version"] for one in (new, old)]
            assert versions == ["2.1.0", "1.1.0"]
            new.peer.publish(f"{BASE}/state", state(paused=True))
            await store.until(lambda now: now.commands[-1].stage is Stage.CONFIRMED)
            assert record.id == store.state.commands[-1].id


async def test_a_pause_goes_out_in_both_ways_to_a_vehicle_whose_version_says_nothing(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            vehicle.peer.publish(f"{BASE}/state", state("latest", agvPosition=position()))
            await store.until(lambda state: state.robots["agv"].pose)
            link.submit(PauseRobot("agv"))
            await vehicle.next("instantActions", 2)
            fields = [{"actions", "instantActions"} & one.keys() for one in vehicle.actions]
            assert fields == [{"actions"}, {"instantActions"}]
            record = await finished(link, store, ORDER)
            assert record.stage is Stage.NOT_SENT
            assert record.detail == "agv reports version 'latest', whose messages are unknown here"


async def test_a_pause_waits_a_moment_for_what_the_broker_has_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(commands, "ADDRESSED_WITHIN", 60.0)
    with broker_in(tmp_path) as broker:
        vehicle = Mute(broker)
        async with console_on(broker, "pause") as (link, _):
            link.submit(PauseRobot("agv"))
            vehicle.peer.publish(f"{BASE}/connection", message(connectionState="ONLINE", version="V2.1.0"))
            action = await vehicle.action()
            assert action["version"] == "V2.1.0" and action["actions"][0]["actionType"] == "startPause"


async def test_only_a_pause_leaves_for_a_vehicle_that_was_never_seen(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        async with console_on(broker, "pause") as (link, store):
            record = await given(link, store, ResumeRobot("agv"), Stage.NOT_SENT)
            assert record.detail == "agv was never seen: its version is unknown"


OFFERS = message(
    protocolFeatures={"agvActions": [{"actionType": "stopCharging", "actionScopes": ["INSTANT"]}]}
)


async def charging(store: WatchedStore, vehicle: SpokenFor) -> None:
    vehicle.peer.publish(f"{BASE}/factsheet", OFFERS, retain=True)
    await store.until(lambda state: state.robots["agv"].features)
    vehicle.say(batteryState={"batteryCharge": 50.0, "charging": True})
    await store.until(lambda state: state.robots["agv"].vehicle)


async def test_a_vehicle_that_charges_is_freed_before_its_order(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await charging(store, vehicle)
            link.submit(ORDER)
            action = await vehicle.next("instantActions")
            assert [one["actionType"] for one in action["actions"]] == ["stopCharging"]
            assert vehicle.peer.told_on(f"{BASE}/order") == []
            vehicle.say()
            order = await vehicle.next("order")
            vehicle.say(orderId=order["orderId"], nodeStates=[node("goal_0", 2)])
            await store.until(lambda state: state.commands[-1].stage is Stage.CONFIRMED)


async def test_one_that_goes_on_charging_gets_no_order(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await charging(store, vehicle)
            record = await finished(link, store, ORDER)
            assert (record.stage, record.detail) == (
                Stage.NOT_SENT,
                "agv is still charging: it did not stop within 5 s",
            )
            vehicle.say()  # too late: nothing is sent later
            await store.until(lambda state: state.robots["agv"].vehicle)
            assert vehicle.peer.told_on(f"{BASE}/order") == []


async def test_an_order_that_waits_for_the_end_of_a_charge_is_not_sent_after_a_pause(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await charging(store, vehicle)
            order = link.submit(ORDER)
            await vehicle.next("instantActions")
            link.submit(PauseRobot("agv"))
            found = await store.until(
                lambda state: any(one.id == order and one.is_decided for one in state.commands)
            )
            record = next(one for one in found.commands if one.id == order)
            assert record.stage is Stage.NOT_SENT
            assert record.detail == "another command came after the command to stop charging"
            vehicle.say(paused=True)
            await store.until(lambda state: state.commands[-1].stage is Stage.CONFIRMED)
            assert vehicle.peer.told_on(f"{BASE}/order") == []


async def test_an_order_that_waits_for_the_end_of_a_charge_ends_with_the_link(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await charging(store, vehicle)
            waiting = asyncio.ensure_future(finished(link, store, ORDER))
            await vehicle.next("instantActions")
            broker.kill()
            record = await waiting
            assert (record.stage, record.detail) == (
                Stage.NOT_SENT,
                "link lost after the command to stop charging",
            )


async def test_a_state_that_says_nothing_of_charging_frees_no_vehicle(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await charging(store, vehicle)
            link.submit(ORDER)
            await vehicle.next("instantActions")
            vehicle.say(batteryState={"batteryCharge": 51.0})
            await store.until(lambda state: (charge := state.robots["agv"].battery) and charge.value == 51.0)
            vehicle.say(batteryState={"batteryCharge": 52.0, "charging": True})
            await store.until(lambda state: (charge := state.robots["agv"].battery) and charge.value == 52.0)
            assert vehicle.peer.told_on(f"{BASE}/order") == []
            vehicle.say()
            await vehicle.next("order")


async def test_why_a_vehicle_goes_on_charging_is_told(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        async with console_on(broker) as (link, store):
            await charging(store, vehicle)
            waiting = asyncio.ensure_future(finished(link, store, ORDER))
            action = (await vehicle.next("instantActions"))["actions"][0]
            failed = {**action, "actionStatus": "FAILED", "resultDescription": "contact welded"}
            vehicle.say(batteryState={"batteryCharge": 50.0, "charging": True}, actionStates=[failed])
            record = await waiting
            assert (record.stage, record.detail) == (Stage.NOT_SENT, "agv is still charging: contact welded")
