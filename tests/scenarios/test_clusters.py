"""Brokers that work as one: the console is at one of them, the vehicle at another."""

import asyncio
import socket
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.config.load import from_text
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from tests.support.broker import RealBroker, broker_in, needs_mosquitto
from tests.support.links import finished, linked
from tests.support.vda_broker import SpokenFor, console_on
from tests.support.vda_fleet import config_text


def bridged(other: RealBroker) -> tuple[str, ...]:
    """The lines of a broker that shares its messages with another one."""
    share = "topic # both 0"
    return ("connection pair", f"address 127.0.0.1:{other.port}", share, "restart_timeout 1")


async def paused(broker: RealBroker, vehicle: SpokenFor) -> None:
    """See a vehicle at this broker, and pause it."""
    async with console_on(broker) as (link, store):
        await store.until(lambda state: state.robots["agv"].connection)
        vehicle.say()
        await store.until(lambda state: state.robots["agv"].vehicle)
        waiting = asyncio.ensure_future(finished(link, store, PauseRobot("agv")))
        await vehicle.next("instantActions")
        vehicle.say(paused=True)
        assert (await waiting).stage is Stage.CONFIRMED
        vehicle.peer.drop()
        await store.until(lambda state: not state.is_online(state.robots["agv"]))


@needs_mosquitto
async def test_a_vehicle_at_another_broker_is_watched_and_paused_and_its_last_will_comes(
    tmp_path: Path,
) -> None:
    with broker_in(tmp_path) as first, broker_in(tmp_path, lines=bridged(first)) as second:
        await paused(first, SpokenFor(second))


async def test_the_loss_of_one_address_of_a_name_leads_to_the_next(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with broker_in(tmp_path) as first, broker_in(tmp_path) as second:
        resolved, usual = [("127.0.0.1", one.port) for one in (first, second)], socket.getaddrinfo

        def addresses(host: Any, *rest: Any, **options: Any) -> Any:
            if host != "brokers.example":
                return usual(host, *rest, **options)
            return [(socket.AF_INET, socket.SOCK_STREAM, 6, "", one) for one in resolved]

        monkeypatch.setattr(socket, "getaddrinfo", addresses)
        vehicle, again = SpokenFor(first), SpokenFor(second)
        async with linked(from_text(config_text("mqtt://brokers.example"))) as (_, store):
            await store.until(lambda state: state.robots["agv"].connection)
            vehicle.say(lastNodeId="at the first")
            await store.until(lambda state: last_node(state) == "at the first")
            first.kill()
            await store.until(lambda state: state.links["broker"].reason)
            await store.until(lambda state: state.links["broker"].command_path is CommandPath.ALIVE)
            again.say(lastNodeId="at the second")
            await store.until(lambda state: last_node(state) == "at the second")
            assert store.state.is_online(store.state.robots["agv"])


def last_node(state: FleetState) -> str:
    agv = state.robots["agv"]
    return agv.vehicle.value.last_node if agv.vehicle else ""
