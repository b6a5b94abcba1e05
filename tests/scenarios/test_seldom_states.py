"""Vehicles that send a state each 30 s, as the standard allows: commands of the shell wait for it, or ask."""

import asyncio
from pathlib import Path
from typing import Any

from tests.support.broker import RealBroker, broker_in
from tests.support.cli import Ended, run
from tests.support.vda_broker import SpokenFor
from tests.support.vda_fleet import config_text
from tests.support.vda_hall import hall_graph
from tests.support.vda_messages import BASE, message, node

ORDER = ("order", "agv", "Rack")


def give(folder: Path, broker: RealBroker, *words: str, role: str = "master") -> "asyncio.Task[Ended]":
    hall_graph(folder)
    text = config_text(broker.url, role).replace('name = "hall"', 'name = "hall"\ngraph = "hall.lif.json"')
    (folder / "config.toml").write_text(text)
    return asyncio.ensure_future(run(folder, *words))


def types(message: dict[str, Any]) -> list[str]:
    return [one["actionType"] for one in message["actions"]]


async def test_an_order_asks_for_the_state_that_it_needs(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        given = give(tmp_path, broker, *ORDER)
        assert types(await vehicle.next("instantActions")) == ["stateRequest"]
        vehicle.say()
        order = await vehicle.next("order")
        vehicle.say(orderId=order["orderId"], nodeStates=[node("n1", 2)])
        done = await given
    assert done.code == 0, done


async def test_a_vehicle_that_knows_no_request_is_waited_for_as_long_as_the_timeout_says(
    tmp_path: Path,
) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        given = give(tmp_path, broker, "clear", "agv", "--timeout", "40")
        await vehicle.next("instantActions")
        await asyncio.sleep(7)  # longer than robots of a bridge are waited for
        vehicle.say(orderId="o", nodeStates=[node("a", 2)])
        done = await given
    assert done.code == 1 and "drives order o of another master control" in done.err, done


async def test_without_a_state_until_then_it_says_so_and_sends_nothing(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        done = await give(tmp_path, broker, *ORDER, "--timeout", "2")
        assert vehicle.peer.told_on("uagv/v2/KIT/0001/order") == []
    assert done.code == 1 and "agv has sent no state yet: it sends one every 30 s" in done.err, done


async def test_who_says_yes_to_all_still_waits_for_no_longer_than_the_timeout(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        done = await give(tmp_path, broker, *ORDER, "--timeout", "2", "--yes")
        assert vehicle.peer.told_on("uagv/v2/KIT/0001/order") == []
    assert done.code == 1 and "not sent (agv: state missing)" in done.err, done


async def test_an_order_that_still_waits_at_the_end_of_the_timeout_is_never_sent_and_told_so(
    tmp_path: Path,
) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        offers = {"agvActions": [{"actionType": "stopCharging", "actionScopes": ["INSTANT"]}]}
        vehicle.peer.publish(f"{BASE}/factsheet", message(protocolFeatures=offers), retain=True)
        given = give(tmp_path, broker, *ORDER, "--timeout", "3", "--yes")
        while not any("stopCharging" in types(one) for one in vehicle.actions):
            vehicle.say(batteryState={"batteryCharge": 50.0, "charging": True})
            await asyncio.sleep(0.1)
        done = await given
        assert vehicle.peer.told_on(f"{BASE}/order") == []
    assert done.code == 1 and "not sent" in done.err and "for the end of its charge" in done.err, done
    assert "may still be carried out" not in done.err


async def test_who_may_only_watch_asks_for_nothing(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        done = await give(tmp_path, broker, *ORDER, "--timeout", "2", role="watch")
        assert vehicle.told == []
    assert done.code == 1, done


async def test_a_vehicle_that_is_gone_is_not_waited_for_and_its_broken_connection_is_the_reason(
    tmp_path: Path,
) -> None:
    with broker_in(tmp_path) as broker:
        SpokenFor(broker).peer.drop()
        done = await give(tmp_path, broker, *ORDER, "--timeout", "600")
    assert done.code == 1 and "agv is offline (connection broken)" in done.err, done
