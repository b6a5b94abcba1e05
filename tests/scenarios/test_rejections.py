"""Vehicles that share no code with the console reject what they can not do, each in its own words."""

import asyncio
import json
import time
from collections.abc import Callable
from contextlib import AbstractAsyncContextManager
from pathlib import Path

import pytest

from fleet_tui.links.transports.loop import network_loop
from fleet_tui.model.commands import PauseRobot, PlaceOrder, Stage
from fleet_tui.model.events import CommandIssued
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop, at_vertices
from tests.support.broker import RealBroker, broker_in
from tests.support.links import finished
from tests.support.mqtt_peer import Peer
from tests.support.polling import eventually
from tests.support.vda_broker import console_on
from tests.support.vda_hall import hall_graph
from tests.support.vda_messages import message
from tests.support.vda_vehicles import npm_vehicle, sdk_vehicle

Vehicle = Callable[[RealBroker], AbstractAsyncContextManager[None]]
DOCK = PlaceOrder("agv", at_vertices("n2"))
FREE = PlaceOrder("agv", (Stop(pose=Pose(5.0, 0.0)),))
REJECTIONS: dict[str, tuple[Vehicle, PlaceOrder, str]] = {
    "sdk, begins elsewhere": (
        lambda broker: sdk_vehicle(broker, x=0.3),
        DOCK,
        "orderError: first node 'n0' is not trivially reachable",
    ),
    "sdk, unknown map": (
        lambda broker: sdk_vehicle(broker, map_known="other"),
        FREE,
        "mapError: maps not available on the vehicle: hall",
    ),
    "lib 2.0, begins elsewhere": (
        lambda broker: npm_vehicle(broker, "2.0.0", x=0.3, tolerance=0.1),
        DOCK,
        "noRouteError: first node of new order not within deviation range",
    ),
    "lib 1.1, charging": (
        lambda broker: npm_vehicle(broker, "1.1.0", charging=True),
        FREE,
        "orderError: order is not executable while charging",
    ),
}


def charges(state: FleetState) -> bool:
    vehicle = state.robots["agv"].vehicle
    return vehicle is not None and vehicle.value.charging is True


@pytest.mark.parametrize("name", REJECTIONS)
async def test_an_order_is_rejected_in_the_words_of_the_vehicle(tmp_path: Path, name: str) -> None:
    make, command, words = REJECTIONS[name]
    graph = hall_graph(tmp_path)
    with broker_in(tmp_path) as broker:
        async with console_on(broker) as (link, store), make(broker):
            link.post(graph)
            await store.until(
                lambda state: (
                    state.robots["agv"].pose
                    and state.robots["agv"].vehicle
                    and state.robots["agv"].maps["hall"].graph
                )
            )
            if "charging" in name:
                await store.until(charges)
            for _ in range(2):  # the rejection of the first one is still among the errors
                record = await finished(link, store, command)
                assert (record.stage, record.detail) == (Stage.REFUSED, words)
            assert not store.state.robots["agv"].orders.open


def foreign_order() -> bytes:
    """An order of another master control, over 20 m."""
    places = [{"x": 0.0, "y": 0.0, "mapId": "hall"}, {"x": 20.0, "y": 0.0, "mapId": "hall"}]
    nodes = [
        {"nodeId": f"f{n}", "sequenceId": 2 * n, "released": True, "actions": [], "nodePosition": place}
        for n, place in enumerate(places)
    ]
    edge = {"edgeId": "f", "sequenceId": 1, "released": True, "actions": []}
    edges = [{**edge, "startNodeId": "f0", "endNodeId": "f1"}]
    return message(orderId="theirs", orderUpdateId=0, nodes=nodes, edges=edges)


MASTERS: dict[str, tuple[Vehicle, str]] = {
    "sdk": (sdk_vehicle, "orderError: vehicle is still executing an order or waiting for an update"),
    "lib": (
        lambda broker: npm_vehicle(broker, "2.0.0"),
        "orderUpdateError: stitching order base not extending active order base",
    ),
}


@pytest.mark.parametrize("name", MASTERS)
async def test_of_two_masters_at_one_moment_the_second_is_rejected(tmp_path: Path, name: str) -> None:
    make, words = MASTERS[name]
    with broker_in(tmp_path) as broker:
        other = Peer(broker.port, "uagv/v2/KIT/0001/state")
        async with console_on(broker) as (link, store), make(broker):
            await store.until(lambda state: state.robots["agv"].pose and state.robots["agv"].vehicle)

            async def overtaken() -> None:
                """Order before this console has read anything of the other order: its loop is in here."""
                other.publish("uagv/v2/KIT/0001/order", foreign_order())
                eventually(lambda: any(json.loads(one.payload)["orderId"] == "theirs" for one in other.told))
                now = time.monotonic()
                store.apply(CommandIssued(1, FREE, now, time.time()))
                link.links["broker"].submit_now(1, FREE, now)

            await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(overtaken(), network_loop()))
            await store.until(lambda state: state.commands and state.commands[-1].is_decided)
            record = store.state.commands[-1]
            assert (record.stage, record.detail) == (Stage.REFUSED, words)
            await store.until(lambda state: state.robots["agv"].orders.open)
            assert [order.id for order in store.state.robots["agv"].orders.open] == ["theirs"]
        other.close()


async def test_instant_actions_in_the_wrong_field_are_rejected_and_told(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        async with console_on(broker) as (link, store), npm_vehicle(broker, "2.0.0"):
            await store.until(lambda state: state.robots["agv"].vehicle)
            record = await finished(link, store, PauseRobot("agv"))
            assert record.stage is Stage.REFUSED and "validationError" in record.detail
