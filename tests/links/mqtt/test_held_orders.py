"""An order that waits for a state is sent as meant, or never."""

import asyncio
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, closing
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from fleet_tui.commands.checks import problems
from fleet_tui.config.load import from_text
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.links.queue_file import QueueFile, WaitingOrder
from fleet_tui.model.commands import RESTARTED, CancelOrder, ClearOrders, PauseRobot, PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.link import CommandPath
from fleet_tui.model.order import Stop, at_vertices
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.commands import StartCharging
from fleet_tui.model.vehicles.vehicle import Vehicle
from fleet_tui.orders.local_queue import all_orders, hold_all
from fleet_tui.text.language import Message
from tests.support.broker import RealBroker, broker_in
from tests.support.links import finished, linked
from tests.support.nav2_site import keeping, record_of
from tests.support.polling import until
from tests.support.vda_broker import SpokenFor, console_on
from tests.support.vda_fleet import ONE, config_text
from tests.support.vda_messages import BASE, error, message, node, position
from tests.support.watched_store import WatchedStore

ORDER = PlaceOrder("agv", (Stop(pose=Pose(5.0, 2.0)),))
CHARGING = {"batteryCharge": 50.0, "charging": True}
OFFERS = message(
    protocolFeatures={"agvActions": [{"actionType": "stopCharging", "actionScopes": ["INSTANT"]}]}
)


class HeldOrderSite(NamedTuple):
    vehicle: SpokenFor
    link: FleetLink
    store: WatchedStore


@pytest.fixture
def broker(tmp_path: Path) -> Iterator[RealBroker]:
    with broker_in(tmp_path) as running:
        yield running


@pytest.fixture
async def site(broker: RealBroker) -> AsyncIterator[HeldOrderSite]:
    """A vehicle that is connected, and has sent no state."""
    vehicle = SpokenFor(broker)
    async with console_on(broker) as (link, store):
        await store.until(lambda state: state.robots["agv"].connection)
        yield HeldOrderSite(vehicle, link, store)


@pytest.fixture(params=["first state", "end of charge"])
async def holding(request: pytest.FixtureRequest, site: HeldOrderSite) -> HeldOrderSite:
    """A vehicle whose next order waits here."""
    if request.param == "end of charge":
        await charging(site.store, site.vehicle)
    return site


def orders(vehicle: SpokenFor) -> list[bytes]:
    return vehicle.peer.told_on(f"{BASE}/order")


async def charging(store: WatchedStore, vehicle: SpokenFor) -> None:
    vehicle.peer.publish(f"{BASE}/factsheet", OFFERS, retain=True)
    await store.until(lambda state: state.robots["agv"].features)
    vehicle.say(batteryState=CHARGING)
    await store.until(lambda state: state.robots["agv"].vehicle)


def vehicle_of(state: FleetState) -> Vehicle:
    known = state.robots["agv"].vehicle
    assert known is not None
    return known.value


def charge_of(percent: float) -> Any:
    def is_there(state: FleetState) -> bool:
        battery = state.robots["agv"].battery
        return battery is not None and battery.value == percent

    return is_there


async def test_an_order_waits_for_the_first_state_which_it_asks_for_and_begins_there(
    site: HeldOrderSite,
) -> None:
    vehicle, link, store = site
    waiting = asyncio.ensure_future(finished(link, store, ORDER))
    asked = await vehicle.next("instantActions")
    assert [one["actionType"] for one in asked["actions"]] == ["stateRequest"]
    assert orders(vehicle) == []
    vehicle.say(agvPosition=position(3.0, 4.0), lastNodeId="")
    order = await vehicle.next("order")
    assert [one["nodePosition"]["x"] for one in order["nodes"]] == [3.0, 5.0]
    vehicle.say(orderId=order["orderId"], nodeStates=[node("goal_0", 2)])
    assert (await waiting).stage is Stage.CONFIRMED


async def test_an_order_that_got_no_state_in_time_is_never_sent(site: HeldOrderSite) -> None:
    vehicle, link, store = site
    record = await finished(link, store, ORDER)
    assert record.stage is Stage.NOT_SENT
    assert record.detail == "no state from agv within 5 s: repeat the order once it has sent one"
    vehicle.say(batteryState={"batteryCharge": 11.0, "charging": False})
    await store.until(charge_of(11.0))
    vehicle.say(batteryState={"batteryCharge": 12.0, "charging": False})
    await store.until(charge_of(12.0))
    assert orders(vehicle) == []


@pytest.mark.parametrize(
    ("command", "end"),
    [
        (PauseRobot("agv"), (Stage.NOT_SENT, "another command came before its first state")),
        (ClearOrders("agv"), (Stage.CANCELLED, "by this console before it was sent")),
    ],
)
async def test_a_pause_or_a_clear_ends_an_order_that_waits_for_the_first_state(
    site: HeldOrderSite, command: PauseRobot | ClearOrders, end: tuple[Stage, str]
) -> None:
    vehicle, link, store = site
    order = link.submit(ORDER)
    await vehicle.next("instantActions")
    link.submit(command)
    await store.until(lambda state: record_of(state, order).is_decided)
    record = record_of(store.state, order)
    assert (record.stage, record.detail) == end
    await vehicle.next("instantActions", 2)
    vehicle.say(batteryState={"batteryCharge": 11.0, "charging": False})
    await store.until(charge_of(11.0))
    assert orders(vehicle) == []


@pytest.mark.parametrize(
    ("shown", "reason"),
    [
        ({"safetyState": {"eStop": "MANUAL", "fieldViolation": False}}, "agv is stopped: e-stop (manual)"),
        ({"errors": [error("FATAL", "motorError")]}, "agv reports fatal motorError"),
        ({"operatingMode": "MANUAL"}, "agv is in mode manual: it takes no orders"),
        ({"paused": True}, "agv is paused"),
    ],
)
async def test_what_would_have_been_asked_about_keeps_a_waiting_order_here(
    holding: HeldOrderSite, shown: dict[str, Any], reason: str
) -> None:
    vehicle, link, store = holding
    waiting = asyncio.ensure_future(finished(link, store, ORDER))
    await vehicle.next("instantActions")
    vehicle.say(**shown)
    record = await waiting
    assert (record.stage, record.detail) == (Stage.NOT_SENT, reason)
    assert orders(vehicle) == []


async def test_an_order_of_another_master_in_the_awaited_state_keeps_ours_here(
    holding: HeldOrderSite,
) -> None:
    vehicle, link, store = holding
    waiting = asyncio.ensure_future(finished(link, store, ORDER))
    await vehicle.next("instantActions")
    vehicle.say(orderId="theirs", nodeStates=[node("n9", 2)])
    record = await waiting
    assert (record.stage, record.detail) == (
        Stage.NOT_SENT,
        "agv drives order theirs of another master control",
    )
    assert orders(vehicle) == []


async def test_a_first_state_that_shows_a_charge_ends_that_before_the_order(site: HeldOrderSite) -> None:
    vehicle, link, store = site
    vehicle.peer.publish(f"{BASE}/factsheet", OFFERS, retain=True)
    await store.until(lambda state: state.robots["agv"].features)
    link.submit(ORDER)
    vehicle.say(batteryState=CHARGING)
    action = await vehicle.next("instantActions")
    assert [one["actionType"] for one in action["actions"]] == ["stopCharging"]
    assert orders(vehicle) == []
    vehicle.say()
    await vehicle.next("order")


async def test_an_order_of_the_queue_that_is_cancelled_while_its_vehicle_ends_its_charge_is_not_sent(
    broker: RealBroker, tmp_path: Path
) -> None:
    vehicle = SpokenFor(broker)
    async with queueing(broker.url, keeping(tmp_path)) as (link, store):
        await store.until(lambda state: state.links["broker"].command_path is CommandPath.ALIVE)
        await charging(store, vehicle)
        link.submit(ORDER)
        queued = link.submit(ORDER)
        await store.until(lambda state: record_of(state, queued).stage is Stage.WAITING)
        await vehicle.next("instantActions")
        vehicle.say()
        first = (await vehicle.next("order"))["orderId"]
        vehicle.say(orderId=first, nodeStates=[node("goal_0", 2)], batteryState=CHARGING)
        await store.until(lambda state: state.robots["agv"].orders.open)
        vehicle.say(orderId=first, batteryState=CHARGING)
        await vehicle.next("instantActions", 2)
        id_ = record_of(store.state, queued).order_id
        assert id_ is not None
        link.submit(CancelOrder("agv", id_))
        await store.until(lambda state: record_of(state, queued).stage is Stage.CANCELLED)
        vehicle.say(orderId=first, batteryState={"batteryCharge": 77.0, "charging": False})
        await store.until(charge_of(77.0))
        vehicle.say(orderId=first, batteryState={"batteryCharge": 78.0, "charging": False})
        await store.until(charge_of(78.0))
        assert len(orders(vehicle)) == 1


def queueing(url: str, queue: QueueFile) -> Any:
    return linked(from_text(config_text(url)), queue=queue)


async def test_saved_orders_of_a_vehicle_that_comes_later_are_loaded_once_and_held(
    broker: RealBroker, tmp_path: Path
) -> None:
    with closing(keeping(tmp_path)) as earlier:
        assert earlier.claim()
        earlier.save([WaitingOrder(broker.url, name, ORDER.stops, 1.7e9) for name in ("agv", "late")])
    async with queueing(broker.url, keeping(tmp_path)) as (link, store):
        await store.until(lambda state: state.commands)
        assert [one.command.robot for one in store.state.commands] == ["agv"]
        more = '\n[[robots]]\nname = "late"\nmanufacturer = "KIT"\nserial = "0002"\nlink = "broker"'
        await asyncio.to_thread(link.extend, from_text(config_text(broker.url, robots=ONE + more)))
        state = await store.until(lambda state: state.robots["late"].held)
        assert [one.command.robot for one in state.commands] == ["agv", "late"]
        assert state.commands[-1].stage is Stage.WAITING and state.robots["late"].held == RESTARTED


async def test_a_closed_console_says_so_of_an_order_that_waited(broker: RealBroker) -> None:
    vehicle = SpokenFor(broker)
    async with console_on(broker) as (link, store):
        await charging(store, vehicle)
        order = link.submit(ORDER)
        await vehicle.next("instantActions")
    await until(lambda: record_of(store.state, order).is_decided)
    assert record_of(store.state, order).detail == "console closed after the command to stop charging"
    assert orders(vehicle) == []


async def test_an_order_that_waits_for_the_end_of_a_charge_may_be_cleared(site: HeldOrderSite) -> None:
    vehicle, link, store = site
    await charging(store, vehicle)
    order = link.submit(ORDER)
    await vehicle.next("instantActions")
    assert problems(store.state, Request((ClearOrders("agv"),)), Permissions()) == []
    link.submit(ClearOrders("agv"))
    await store.until(lambda state: record_of(state, order).is_decided)
    assert record_of(store.state, order).stage is Stage.CANCELLED
    vehicle.say()
    await store.until(charge_of(80.5))
    assert orders(vehicle) == []
    (problem,) = problems(store.state, Request((ClearOrders("agv"),)), Permissions())
    assert problem.blocks, "nothing is on its way any more"


async def test_no_order_waits_for_a_state_without_a_link(broker: RealBroker, site: HeldOrderSite) -> None:
    vehicle, link, store = site
    broker.kill()
    await store.until(lambda state: state.links["broker"].command_path is CommandPath.DEAD)
    record = await finished(link, store, ORDER)
    assert (record.stage, record.detail) == (Stage.NOT_SENT, "no link")
    assert orders(vehicle) == []


async def test_an_order_that_waits_is_in_the_queue_of_this_console_and_is_cancelled_there(
    holding: HeldOrderSite,
) -> None:
    vehicle, link, store = holding
    order = link.submit(ORDER)
    asked = await vehicle.next("instantActions")
    assert record_of(store.state, order).stage is Stage.WAITING
    (waiting,) = all_orders(store.state, store.state.robots["agv"])
    record = await finished(link, store, CancelOrder("agv", waiting.id))
    assert (record.stage, record.detail) == (Stage.CONFIRMED, "was waiting here")
    assert record_of(store.state, order).stage is Stage.CANCELLED
    vehicle.say()
    await store.until(charge_of(80.5))
    assert orders(vehicle) == [] and [asked] == vehicle.actions, "no cancelOrder for it, either"


async def test_disarming_ends_an_order_that_waits(site: HeldOrderSite) -> None:
    vehicle, link, store = site
    await charging(store, vehicle)
    order = link.submit(ORDER)
    await vehicle.next("instantActions")
    for hold in hold_all(store.state, Message("this console is not armed")):
        link.post(hold)
    vehicle.say()
    await store.until(lambda state: record_of(state, order).is_decided)
    record = record_of(store.state, order)
    assert (record.stage, record.detail) == (Stage.NOT_SENT, "this console is not armed")
    assert orders(vehicle) == []


async def test_an_accepted_fault_does_not_accept_another_one(site: HeldOrderSite) -> None:
    vehicle, link, store = site
    known = error("FATAL", "motorError")
    await charging(store, vehicle)
    vehicle.say(batteryState=CHARGING, errors=[known])
    await store.until(lambda state: vehicle_of(state).errors)
    waiting = asyncio.ensure_future(finished(link, store, ORDER))
    await vehicle.next("instantActions")
    vehicle.say(errors=[known, error("FATAL", "lidarError")])
    record = await waiting
    assert (record.stage, record.detail) == (Stage.NOT_SENT, "agv reports fatal lidarError")
    waiting = asyncio.ensure_future(finished(link, store, ORDER))
    order = await vehicle.next("order")
    vehicle.say(orderId=order["orderId"], nodeStates=[node("goal_0", 2)])
    assert (await waiting).stage is Stage.CONFIRMED


async def test_after_a_reconnect_an_order_waits_for_a_state_and_asks_for_it(broker: RealBroker) -> None:
    async with console_on(broker) as (link, store):
        first = SpokenFor(broker)
        first.say()
        await store.until(lambda state: state.robots["agv"].vehicle)
        broker.kill()
        await store.until(lambda state: state.links["broker"].command_path is CommandPath.DEAD)
        broker.start()
        await store.until(lambda state: state.links["broker"].command_path is CommandPath.ALIVE)
        vehicle = SpokenFor(broker)
        waiting = asyncio.ensure_future(finished(link, store, ORDER))
        asked = await vehicle.next("instantActions")
        assert [one["actionType"] for one in asked["actions"]] == ["stateRequest"]
        vehicle.say(agvPosition=position(3.0, 4.0), lastNodeId="")
        order = await vehicle.next("order")
        assert [one["nodePosition"]["x"] for one in order["nodes"]] == [3.0, 5.0]
        vehicle.say(orderId=order["orderId"], nodeStates=[node("goal_0", 2)])
        assert (await waiting).stage is Stage.CONFIRMED


async def test_a_clear_of_orders_that_only_this_console_has_sends_nothing(
    broker: RealBroker, tmp_path: Path
) -> None:
    vehicle = SpokenFor(broker)
    async with queueing(broker.url, keeping(tmp_path)) as (link, store):
        await store.until(lambda state: state.links["broker"].command_path is CommandPath.ALIVE)
        await charging(store, vehicle)
        ids = [link.submit(ORDER), link.submit(ORDER)]
        asked = await vehicle.next("instantActions")
        record = await finished(link, store, ClearOrders("agv"))
        assert (record.stage, record.detail) == (Stage.CONFIRMED, "was waiting here")
        assert [record_of(store.state, one).stage for one in ids] == [Stage.CANCELLED] * 2
        vehicle.say()
        await store.until(charge_of(80.5))
        assert orders(vehicle) == [] and vehicle.actions == [asked]


LEFT = [node("goal_0", 2)]


@asynccontextmanager
async def on_its_way_to_a_charge(
    broker: RealBroker, folder: Path
) -> AsyncIterator[tuple[HeldOrderSite, str, int]]:
    """A vehicle that drives an order, after which it is to charge: with the ids of the order and of that
    command."""
    vehicle = SpokenFor(broker)
    async with queueing(broker.url, keeping(folder)) as (link, store):
        await store.until(lambda state: state.links["broker"].command_path is CommandPath.ALIVE)
        vehicle.say()
        await store.until(lambda state: state.robots["agv"].vehicle)
        _, charge = link.submit_all([ORDER, StartCharging("agv")])
        order = (await vehicle.next("order"))["orderId"]
        vehicle.say(orderId=order, nodeStates=LEFT)
        await store.until(lambda state: state.robots["agv"].orders.open)
        assert record_of(store.state, charge).stage is Stage.WAITING and vehicle.actions == []
        yield HeldOrderSite(vehicle, link, store), order, charge


async def test_a_console_that_opens_again_says_that_its_charge_does_not_follow(
    broker: RealBroker, tmp_path: Path
) -> None:
    async with on_its_way_to_a_charge(broker, tmp_path):
        pass
    async with queueing(broker.url, keeping(tmp_path)) as (_, store):
        state = await store.until(lambda state: state.commands and state.commands[-1].is_decided)
        (charge,) = state.commands
        assert (charge.command, charge.stage, charge.detail) == (
            StartCharging("agv"),
            Stage.NOT_SENT,
            RESTARTED,
        )


async def test_an_order_that_waits_is_kept_with_the_charge_after_it(
    broker: RealBroker, tmp_path: Path
) -> None:
    async with on_its_way_to_a_charge(broker, tmp_path) as ((_, link, store), _, charge):
        link.submit(CancelOrder("agv", record_of(store.state, charge).order_id or ""))
        _, charge = link.submit_all([ORDER, StartCharging("agv")])
        await store.until(lambda state: record_of(state, charge).stage is Stage.WAITING)
    async with queueing(broker.url, keeping(tmp_path)) as (_, store):
        state = await store.until(lambda state: len(state.commands) == 2)
        assert [one.command for one in state.commands] == [ORDER, StartCharging("agv")]
        await store.until(lambda state: state.links["broker"].command_path is CommandPath.ALIVE)
        assert [one.stage for one in store.state.commands] == [Stage.WAITING] * 2
        assert store.state.robots["agv"].held == RESTARTED


async def test_a_charge_by_an_instant_action_begins_once_its_vehicle_has_arrived(
    broker: RealBroker, tmp_path: Path
) -> None:
    async with on_its_way_to_a_charge(broker, tmp_path) as ((vehicle, _, store), order, charge):
        (_, waiting) = all_orders(store.state, store.state.robots["agv"])
        assert waiting.label == "start charging"
        vehicle.say(orderId=order, lastNodeId="goal_0")
        (action,) = (await vehicle.next("instantActions"))["actions"]
        assert action["actionType"] == "startCharging" and action["blockingType"] == "NONE"
        done = {"actionId": action["actionId"], "actionType": "startCharging", "actionStatus": "FINISHED"}
        vehicle.say(orderId=order, lastNodeId="goal_0", batteryState=CHARGING, actionStates=[done])
        await store.until(lambda state: record_of(state, charge).is_decided)
        assert record_of(store.state, charge).stage is Stage.CONFIRMED
        assert [one.stage for one in store.state.commands] == [Stage.DONE, Stage.CONFIRMED]


@pytest.mark.parametrize(
    ("order", "ends"),
    [
        (
            PlaceOrder("agv", at_vertices("nowhere")),
            [
                (Stage.NOT_SENT, "position of node nowhere unknown: no graph of its floor contains it"),
                (Stage.NOT_SENT, "order before it: not sent"),
            ],
        ),
        (
            ORDER,
            [
                (Stage.SENT, ""),
                (Stage.NOT_SENT, "agv has an order and has no queue: order from a console, or wait"),
            ],
        ),
    ],
)
async def test_no_charge_begins_before_the_order_to_it_is_driven(
    site: HeldOrderSite, order: PlaceOrder, ends: list[tuple[Stage, str]]
) -> None:
    vehicle, link, store = site
    vehicle.say()
    await store.until(lambda state: state.robots["agv"].vehicle)
    ids = link.submit_all([order, StartCharging("agv")])
    await store.until(lambda state: record_of(state, ids[1]).is_decided)
    assert [(one.stage, one.detail) for one in (record_of(store.state, id_) for id_ in ids)] == ends
    assert vehicle.actions == []


async def test_a_vehicle_that_can_not_charge_says_why(broker: RealBroker, tmp_path: Path) -> None:
    async with on_its_way_to_a_charge(broker, tmp_path) as ((vehicle, _, store), order, charge):
        vehicle.say(orderId=order, lastNodeId="goal_0")
        (action,) = (await vehicle.next("instantActions"))["actions"]
        failed = {"actionId": action["actionId"], "actionStatus": "FAILED", "resultDescription": "no contact"}
        vehicle.say(orderId=order, lastNodeId="goal_0", actionStates=[failed])
        await store.until(lambda state: record_of(state, charge).is_decided)
        record = record_of(store.state, charge)
        assert (record.stage, record.detail) == (Stage.REFUSED, "no contact")


@pytest.mark.parametrize(
    ("event", "end"),
    [
        ("disarmed", (Stage.NOT_SENT, "this console is not armed")),
        ("failed", (Stage.NOT_SENT, "order {order}: failed")),
        ("cleared", (Stage.CANCELLED, "by this console before it was sent")),
        ("link lost", (Stage.NOT_SENT, "the link was lost")),
    ],
)
async def test_a_charge_does_not_begin_without_its_order_or_after_disarming(
    broker: RealBroker, tmp_path: Path, event: str, end: tuple[Stage, str]
) -> None:
    async with on_its_way_to_a_charge(broker, tmp_path) as ((vehicle, link, store), order, charge):
        match event:
            case "disarmed":
                for hold in hold_all(store.state, Message("this console is not armed")):
                    link.post(hold)
            case "failed":
                vehicle.say(orderId=order, errors=[error("FATAL", orderId=order)])
            case "cleared":
                link.submit(ClearOrders("agv"))
            case _:
                broker.kill()
        await store.until(lambda state: record_of(state, charge).is_decided)
        record, (stage, detail) = record_of(store.state, charge), end
        assert (record.stage, record.detail) == (stage, detail.format(order=order[:8]))
        if event != "link lost":
            vehicle.say(orderId=order, lastNodeId="goal_0", batteryState={"batteryCharge": 11.0})
            await store.until(charge_of(11.0))
            assert "startCharging" not in str(vehicle.actions)
