"""Simulated vehicles as a separate process: on a broker of their own until it is stopped."""

import asyncio
import json
import random
import time
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from itertools import count
from typing import Any, cast

import paho.mqtt.client as mqtt
from paho.mqtt.enums import CallbackAPIVersion

from fleet_tui.simulator.faults import parse_faults_of
from fleet_tui.simulator.faults.plays import Faults
from fleet_tui.simulator.run import serve_until_stopped
from fleet_tui.simulator.vda5050.broker import broker, free_port, has_broker
from fleet_tui.simulator.vda5050.faults import FAULTS
from fleet_tui.simulator.vda5050.vehicle import SimVehicle
from fleet_tui.simulator.warehouse import build_building

STEP = 0.05
IN_MIXED = ("agv_0", "agv_1")
"""The vehicles beside a mixed fleet."""


STATE_EVERY = 1.0
"""Seconds between two states without news: a vehicle may take 30."""


VERSION = "2.0.0"
MANUFACTURER = "fleet-tui"


class VehicleClient:
    """The connection of one vehicle. Messages arrive on a thread of paho's: `take` keeps them for `step`."""

    def __init__(self, vehicle: SimVehicle, port: int) -> None:
        self.vehicle = vehicle
        self._base = f"uagv/v2/{MANUFACTURER}/{vehicle.name}"
        self._numbers = count()
        self._waiting: list[tuple[str, bytes]] = []
        self._stated_at = self._shown_at = 0.0
        self._client = mqtt.Client(CallbackAPIVersion.VERSION2, clean_session=True)
        will = self._text({"connectionState": "CONNECTIONBROKEN"})
        self._client.will_set(f"{self._base}/connection", will, 1, True)
        self._client.on_message = lambda _client, _data, message: self._waiting.append(
            (message.topic, bytes(message.payload))
        )
        self._client.on_connect = lambda *_: self._announce()
        self._client.connect("127.0.0.1", port, keepalive=15)
        self._client.loop_start()

    def _announce(self) -> None:
        self._client.subscribe([(f"{self._base}/order", 0), (f"{self._base}/instantActions", 0)])
        self._publish("connection", {"connectionState": "ONLINE"}, 1, True)
        self._publish("factsheet", factsheet(), 0, True)

    def _text(self, fields: Mapping[str, Any]) -> str:
        now = time.time()
        stamp = time.strftime("%Y-%m-%dT%H:%M:%S", time.gmtime(now)) + f".{int(now % 1 * 1000):03}Z"
        return json.dumps({**header(self.vehicle, next(self._numbers), stamp), **fields})

    def _publish(self, name: str, fields: Mapping[str, Any], qos: int = 0, retain: bool = False) -> None:
        self._client.publish(f"{self._base}/{name}", self._text(fields), qos, retain)

    def step(self, dt: float, now: float, visualization_every: float) -> None:
        """Take what arrived, drive on, and tell it; `now` is monotonic."""
        waiting, self._waiting = self._waiting, []
        for topic, payload in waiting:
            self._take(topic, payload)
        self.vehicle.step(dt)
        if self.vehicle.silent:
            return
        if self.vehicle.is_news or now - self._stated_at >= STATE_EVERY:
            self.vehicle.is_news = False
            self._stated_at = now
            self._publish("state", state(self.vehicle))
        if now - self._shown_at >= visualization_every:
            self._shown_at = now
            self._publish("visualization", {"agvPosition": position(self.vehicle)})

    def _take(self, topic: str, payload: bytes) -> None:
        try:
            message = json.loads(payload)
            if topic.endswith("/order"):
                self.vehicle.take_order(message)
            else:
                actions: Sequence[Mapping[str, Any]] = message.get("actions") or message["instantActions"]
                for action in actions:
                    self.vehicle.take_action(action)
        except (ValueError, KeyError, TypeError, AttributeError):
            return  # as a vehicle that can't read it

    def close(self) -> None:
        self._publish("connection", {"connectionState": "OFFLINE"}, 1, True)
        self._client.disconnect()
        self._client.loop_stop()


def vehicles_of(names: Sequence[str], floors: int, seed: int, faults: str) -> list[SimVehicle]:
    """Return vehicles on the floors in turn, each at a labelled place. Raises ConfigError for a fault."""
    building, chance = build_building(floors), random.Random(seed)
    made = {}
    for n, name in enumerate(names):
        floor = building.floors[n % floors]
        vertex = floor.graph.vertices[chance.choice(sorted(floor.labels))]
        made[name] = SimVehicle(name, (vertex.x, vertex.y), floor.name, str(vertex.id))
    known = cast("Mapping[str, Faults]", dict.fromkeys(names, FAULTS))
    for fault, name in parse_faults_of(faults, known):
        FAULTS[fault][1](made[name])
    return list(made.values())


def serve(
    vehicles: Sequence[SimVehicle],
    port: int,
    rate: float,
    announce: Callable[[Sequence[str]], None],
    stop_with_stdin: bool = False,
    speed: float = 1.0,
) -> None:
    """Serve vehicles until stopped: `rate` visualizations a second, port 0: a free one. Raises FleetError,
    and SystemExit(130) on Ctrl-C."""
    vehicles_served = served(vehicles, port or free_port(), rate, speed)
    if asyncio.run(serve_until_stopped([], announce, stop_with_stdin, vehicles_served)):
        raise SystemExit(130)


@asynccontextmanager
async def served(vehicles: Sequence[SimVehicle], port: int, rate: float, speed: float) -> AsyncIterator[str]:
    """Serve vehicles on a broker of their own, and yield its address. Raises FleetError."""
    async with broker(port):
        clients = [VehicleClient(vehicle, port) for vehicle in vehicles]
        stepping = asyncio.ensure_future(_step(clients, rate, speed))
        try:
            yield f"mqtt://127.0.0.1:{port}"
        finally:
            stepping.cancel()
            for client in clients:
                client.close()


def vehicles_beside(
    floors: int, seed: int, rate: float, speed: float
) -> AbstractAsyncContextManager[str] | None:
    """Return the vehicles of a mixed fleet, on any free port; None where no broker is installed."""
    if not has_broker():
        return None
    return served(vehicles_of(IN_MIXED, floors, seed, ""), free_port(), rate, speed)


async def _step(clients: Sequence[VehicleClient], rate: float, speed: float) -> None:
    last: Any = time.monotonic()
    while True:
        await asyncio.sleep(STEP)
        now = time.monotonic()
        for client in clients:
            client.step((now - last) * speed, now, 1.0 / rate)
        last = now


def header(vehicle: SimVehicle, number: int, stamp: str) -> dict[str, Any]:
    whose = {"manufacturer": MANUFACTURER, "serialNumber": vehicle.name}
    return {"headerId": number, "timestamp": stamp, "version": VERSION, **whose}


def position(vehicle: SimVehicle) -> Mapping[str, Any]:
    return {
        "x": round(vehicle.x, 3),
        "y": round(vehicle.y, 3),
        "theta": round(vehicle.theta, 4),
        "mapId": vehicle.map_id,
        "positionInitialized": vehicle.localised,
    }


def state(vehicle: SimVehicle) -> dict[str, Any]:
    """Return the whole state, without its header."""
    nodes = [
        {key: node[key] for key in ("nodeId", "sequenceId", "released", "nodePosition") if key in node}
        for node in vehicle.nodes
    ]
    return {
        "orderId": vehicle.order_id,
        "orderUpdateId": vehicle.update_id,
        "lastNodeId": vehicle.last_node,
        "lastNodeSequenceId": vehicle.last_sequence,
        "driving": vehicle.driving,
        "paused": vehicle.paused,
        "operatingMode": vehicle.mode,
        "nodeStates": nodes,
        "edgeStates": [],
        "agvPosition": position(vehicle),
        "actionStates": vehicle.actions,
        "batteryState": {"batteryCharge": round(vehicle.battery, 1), "charging": vehicle.charging},
        "errors": vehicle.errors,
        "information": [],
        "loads": [{"loadType": "EPAL"}] if vehicle.loaded else [],
        "safetyState": {"eStop": vehicle.e_stop, "fieldViolation": vehicle.field},
    }


def factsheet() -> dict[str, Any]:
    return {
        "typeSpecification": {"seriesName": "simulated", "agvKinematic": "DIFF", "agvClass": "CARRIER"},
        "physicalParameters": {"speedMin": 0.1, "speedMax": 1.2, "width": 0.6, "length": 0.9},
        "protocolFeatures": {
            "agvActions": [
                {"actionType": "startCharging", "actionScopes": ["NODE"]},
                {"actionType": "stopCharging", "actionScopes": ["INSTANT"]},
            ]
        },
    }
