"""Vehicles that share no code with the console, over a real broker: watched, paused, driven, cancelled."""

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.commands.routes.charging import order_to_charger
from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.site import start_discovery
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.commands import ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot, Stage
from fleet_tui.model.events import FloorGraphLoaded
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, Role, RouteGraph
from fleet_tui.model.order import Stop, at_vertices
from fleet_tui.situation.battery.charging import charging_reported
from tests.support.broker import RealBroker, broker_in
from tests.support.links import finished, linked
from tests.support.mqtt_peer import Peer
from tests.support.polling import until
from tests.support.vda_broker import console_on
from tests.support.vda_hall import hall_graph
from tests.support.vda_messages import message
from tests.support.vda_vehicles import npm_vehicle, sdk_vehicle
from tests.support.watched_store import WatchedStore

Vehicle = Callable[[RealBroker], AbstractAsyncContextManager[None]]
OLD_FIELD = 'instant_actions = "instantActions"'
VEHICLES: dict[str, tuple[Vehicle, str]] = {
    "vda5050-sdk, 2.1": (sdk_vehicle, ""),
    "vda-5050-lib, 2.0": (lambda broker: npm_vehicle(broker, "2.0.0"), OLD_FIELD),
    "vda-5050-lib, 1.1": (lambda broker: npm_vehicle(broker, "1.1.0"), ""),
}
FAR = PlaceOrder("agv", (Stop(pose=Pose(20.0, 0.0)), Stop(pose=Pose(20.0, 5.0))))
NEAR = PlaceOrder("agv", (Stop(pose=Pose(1.0, 0.0)),))


def seen(state: FleetState) -> bool:
    agv = state.robots["agv"]
    return agv.pose is not None and agv.battery is not None and agv.vehicle is not None


@asynccontextmanager
async def site(
    folder: Path, name: str, role: str = "master"
) -> AsyncIterator[tuple[FleetLink, WatchedStore, AbstractAsyncContextManager[None]]]:
    make, settings = VEHICLES[name]
    with broker_in(folder) as broker:
        async with console_on(broker, role, settings) as (link, store):
            yield link, store, make(broker)


async def outcome(link: FleetLink, store: WatchedStore, command: Command) -> Stage:
    return (await finished(link, store, command)).stage


@pytest.mark.parametrize("name", VEHICLES)
async def test_it_is_paused_driven_cancelled_and_driven_to_its_end(tmp_path: Path, name: str) -> None:
    async with site(tmp_path, name) as (link, store, vehicle), vehicle:
        await store.until(seen)
        assert store.state.robots["agv"].floor == "hall"
        assert await outcome(link, store, PauseRobot("agv")) is Stage.CONFIRMED
        assert store.state.is_paused(store.state.robots["agv"])
        assert await outcome(link, store, ResumeRobot("agv")) is Stage.CONFIRMED
        refused = await finished(link, store, ClearOrders("agv"))
        assert refused.stage is Stage.REFUSED and "noOrderToCancel" in refused.detail
        assert await outcome(link, store, FAR) is Stage.CONFIRMED
        assert [order.stops for order in store.state.robots["agv"].orders.open] == [FAR.stops]
        assert await outcome(link, store, ClearOrders("agv")) is Stage.CONFIRMED
        await store.until(lambda state: any(one.stage is Stage.CANCELLED for one in state.commands))
        here = store.state.robots["agv"].pose
        assert here is not None
        near = PlaceOrder("agv", (Stop(pose=Pose(here.value.x + 1.0, here.value.y)),))
        assert await outcome(link, store, near) is Stage.CONFIRMED
        await store.until(lambda state: any(one.stage is Stage.DONE for one in state.commands))
        assert store.state.robots["agv"].faults == 0 and store.state.robots["agv"].master is None


@pytest.mark.parametrize("name", VEHICLES)
async def test_who_watches_is_refused_and_sees_it_go(tmp_path: Path, name: str) -> None:
    async with site(tmp_path, name, "watch") as (link, store, vehicle):
        async with vehicle:
            await store.until(lambda state: seen(state) and state.is_online(state.robots["agv"]))
            assert await outcome(link, store, PauseRobot("agv")) is Stage.NOT_SENT
            assert await outcome(link, store, NEAR) is Stage.NOT_SENT
        await store.until(lambda state: not state.is_online(state.robots["agv"]))
        connection = store.state.robots["agv"].connection
        assert connection is not None and connection.value.is_gone


async def test_it_drives_over_a_graph_of_lif(tmp_path: Path) -> None:
    loaded = hall_graph(tmp_path)
    async with site(tmp_path, "vda-5050-lib, 2.0") as (link, store, vehicle), vehicle:
        link.post(loaded)
        await store.until(lambda state: seen(state) and state.robots["agv"].maps["hall"].graph)
        assert store.state.robots["agv"].name_of("n2") == "Dock"
        assert await outcome(link, store, PlaceOrder("agv", at_vertices("n2"))) is Stage.CONFIRMED
        await store.until(lambda state: state.commands[-1].stage is Stage.DONE)
        agv = store.state.robots["agv"]
        assert agv.vehicle is not None and agv.vehicle.value.last_node == "n2"


@pytest.mark.parametrize(
    "name", [pytest.param("vda-5050-lib, 1.1", marks=pytest.mark.nightly), "vda-5050-lib, 2.0"]
)
async def test_it_charges_at_a_charger_and_is_freed_before_its_next_order(tmp_path: Path, name: str) -> None:
    """vda-5050-lib takes no order while it charges. It sends no factsheet: a test does that for it."""
    make, settings = VEHICLES[name]
    version = "1.1.0" if "1.1" in name else "2.0.0"
    actions = [
        {"actionType": f"{verb}Charging", "actionScopes": ["INSTANT", "NODE"]} for verb in ("start", "stop")
    ]
    with broker_in(tmp_path) as broker:
        sheet = message(version, protocolFeatures={"agvActions": actions})
        Peer(broker.port).publish(f"uagv/v{version[0]}/KIT/0001/factsheet", sheet, retain=True)
        async with console_on(broker, settings=settings) as (link, store), make(broker):
            link.post(with_charger(hall_graph(tmp_path)))
            await store.until(lambda state: seen(state) and state.robots["agv"].features)
            request = order_to_charger(store.state, store.state.robots["agv"])
            assert await outcome(link, store, request.commands[0]) is Stage.CONFIRMED
            await store.until(lambda state: state.commands[-1].stage is Stage.DONE)
            await store.until(lambda state: charging_reported(state, state.robots["agv"]))
            assert await outcome(link, store, PlaceOrder("agv", at_vertices("n1"))) is Stage.CONFIRMED
            await store.until(lambda state: state.commands[-1].stage is Stage.DONE)
            assert not charging_reported(store.state, store.state.robots["agv"])


def with_charger(loaded: FloorGraphLoaded) -> FloorGraphLoaded:
    """The hall with a way there and back, and a charger at its end."""
    graph = loaded.graph
    assert graph is not None
    vertices = {**graph.vertices, "n2": replace(graph.vertices["n2"], role=Role.DOCKING)}
    back = tuple(Edge(f"{edge.id} back", edge.end, edge.start) for edge in graph.edges)
    return replace(loaded, graph=RouteGraph(vertices, (*graph.edges, *back), True))


async def test_an_address_is_enough_to_see_vehicles_of_both_libraries(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        async with sdk_vehicle(broker), npm_vehicle(broker, "2.0.0", "0002"):
            peer = Peer(broker.port, "uagv/+/+/0002/state")
            await until(lambda: peer.told)
            site = await asyncio.wrap_future(start_discovery(Link(broker.url)))
            assert {one.name: one.serial for one in site.config.robots} == {
                "agv_0001": "0001",
                "agv_0002": "0002",
            }
            async with linked(site.config) as (link, store):
                # The events of a message are applied one after the other: its pose comes after the vehicle.
                await store.until(lambda state: all(robot.floor == "hall" for robot in state.robots.values()))
                for name, robot in store.state.robots.items():
                    assert robot.pose is not None and store.state.is_online(robot)
                    assert await outcome(link, store, PauseRobot(name)) is Stage.NOT_SENT
            peer.close()
