"""Simulated vehicles as a separate process: on a broker of their own until it is stopped."""

import asyncio
import random
import threading
import time
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from typing import Any, cast

from fleet_tui.simulator.faults import Faults, parse_faults_of
from fleet_tui.simulator.run import await_stdin
from fleet_tui.simulator.vda5050.broker import broker, free_port, has_broker
from fleet_tui.simulator.vda5050.clients import VehicleClient
from fleet_tui.simulator.vda5050.faults import FAULTS
from fleet_tui.simulator.vda5050.vehicle import SimVehicle
from fleet_tui.simulator.warehouse import build_building
from fleet_tui.stopping import stopped_by_signal

STEP = 0.05
IN_MIXED = ("agv_0", "agv_1")
"""The vehicles beside a mixed fleet."""


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
    if asyncio.run(_serve(vehicles, port or free_port(), rate, announce, stop_with_stdin, speed)):
        raise SystemExit(130)


async def _serve(
    vehicles: Sequence[SimVehicle],
    port: int,
    rate: float,
    announce: Callable[[Sequence[str]], None],
    stop_with_stdin: bool,
    speed: float,
) -> bool:
    stopped = stopped_by_signal()
    async with served(vehicles, port, rate, speed) as url:
        announce([url])
        if stop_with_stdin:
            threading.Thread(target=await_stdin, args=(stopped,), daemon=True).start()
        return await stopped


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
