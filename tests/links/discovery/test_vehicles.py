"""From the address of a broker to a configuration."""

import asyncio
from collections.abc import Sequence
from pathlib import Path

import pytest

from fleet_tui.config.check import checked
from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.site import DiscoveredSite, start_discovery
from fleet_tui.links.discovery.vehicles import MOST_FLOORS, MOST_VEHICLES, watch_vehicles, with_vehicles
from fleet_tui.robots.discovery import Discovery
from fleet_tui.robots.vda5050.discovery import SeenVehicle
from fleet_tui.text.errors import FleetError, LinkError
from tests.support.broker import BrokerAccess, broker_in, free_port
from tests.support.mqtt_peer import Peer
from tests.support.polling import until
from tests.support.vda_messages import message, position, state


async def found(url: str, within: float = 10.0, wait: float = 0.0) -> DiscoveredSite:
    return await asyncio.wrap_future(start_discovery(Link(url), within, wait=wait))


async def test_vehicles_are_found_by_their_connections_and_floors_by_their_maps(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        peer = Peer(broker.port)
        for serial in ("0001", "truck_7", "gone [2J"):
            peer.publish(f"uagv/v2/KIT/{serial}/connection", message(connectionState="ONLINE"), True, 1)
        asking = asyncio.ensure_future(found(broker.url))
        while not asking.done():
            peer.publish("uagv/v2/KIT/0001/state", state())
            peer.publish("uagv/v2/KIT/truck_7/visualization", message(agvPosition=position(map_id="Halle 2")))
            await asyncio.sleep(0.1)
        site = await asking
        config = site.config
        assert {one.name: (one.manufacturer, one.serial, one.link) for one in config.robots} == {
            "agv_0001": ("KIT", "0001", "broker"),
            "gone_2J": ("KIT", "gone [2J", "broker"),
            "truck_7": ("KIT", "truck_7", "broker"),
        }
        assert {floor.name: floor.frame for floor in config.floors} == {"floor_0": "Halle 2", "hall": "hall"}
        assert site.summary == "3 robots (vda5050), 2 floors" and not site.choices and not site.warnings
        assert config.bridges["broker"].role == "watch"
        assert "lif.json" in site.text
        peer.close()


async def test_a_broker_without_vehicles_or_without_rights_is_told(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        site = await found(broker.url, 1.0)
        with pytest.raises(FleetError, match="no vehicle found: no message of a vehicle"):
            _ = site.config
    with broker_in(tmp_path, BrokerAccess(refused="#")) as broker, pytest.raises(LinkError, match="refuses"):
        await found(broker.url)
    with pytest.raises(LinkError, match="connection refused"):
        await found(f"mqtt://127.0.0.1:{free_port()}")


async def test_vehicles_come_as_long_as_further_ones_are_found(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        peer = Peer(broker.port)
        asking = asyncio.ensure_future(found(broker.url, 20.0))
        for serial in ("1", "2", "3"):  # none retains its connection
            await asyncio.sleep(1.2)
            assert not asking.done()
            header = message(manufacturer="KIT", serialNumber=serial)
            peer.publish(f"uagv/v2/KIT/{serial}/state", header)
        assert len((await asking).config.robots) == 3


async def test_one_that_is_silent_for_long_is_waited_for_on_request(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        peer = Peer(broker.port)
        peer.publish("uagv/v2/KIT/0001/connection", message(connectionState="ONLINE"), True, 1)
        asking = asyncio.ensure_future(found(broker.url, wait=6.0))
        await asyncio.sleep(4.0)
        peer.publish("uagv/v2/KIT/0002/state", state())
        site = await asking
        assert len(site.config.robots) == 2 and site.listened >= 6.0


async def test_only_what_says_which_vehicle_sent_it_is_one(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        peer = Peer(broker.port)
        for topic, payload in (
            ("home/v2/kitchen/lamp/state", b'{"on": true}'),
            ("a/b/c/d/connection", b""),
            ("a/b/c/e/state", b"[1]"),
            ("uagv/v2/KIT/0001/state", state()),
        ):
            peer.publish(topic, payload, True, 1)
        assert [one.serial for one in (await found(broker.url)).config.robots] == ["0001"]


async def test_later_vehicles_and_maps_are_passed_on_once_they_appear(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        peer, passed = Peer(broker.port), list[Sequence[SeenVehicle]]()
        peer.publish("uagv/v2/KIT/0001/connection", message(connectionState="ONLINE"), True, 1)
        watching = asyncio.ensure_future(watch_vehicles(Link(broker.url), passed.append))
        await until(lambda: len(passed) == 1)
        peer.publish("home/v2/kitchen/lamp/state", b'{"on": true}')
        peer.publish("uagv/v2/KIT/0002/state", state())
        await until(lambda: len(passed) == 2)
        assert passed == [
            [SeenVehicle("KIT", "0001", "2.0.0")],
            [SeenVehicle("KIT", "0001", "2.0.0"), SeenVehicle("KIT", "0002", "2.0.0", ("hall",))],
        ]
        watching.cancel()


def test_further_vehicles_follow_those_of_before_under_names_of_their_own() -> None:
    found = Discovery({"agv_1": []})
    found.vehicles = {"agv_1": ("KIT", "1")}
    before = DiscoveredSite(Link("mqtt://x"), {"vda5050": found}, {}, 1).config
    assert with_vehicles(before, [SeenVehicle("KIT", "1")]) == before
    after = with_vehicles(before, [SeenVehicle("KIT", "1", "", ("hall",)), SeenVehicle("ACME", "1")])
    assert [robot.name for robot in after.robots] == ["agv_1", "ACME_1"]
    assert [floor.frame for floor in after.floors] == ["hall"], "the floor was that of an unknown map"
    more = with_vehicles(after, [SeenVehicle("ACME", "0", "", ("yard", "Halle 2"))])
    assert [robot.name for robot in more.robots] == ["agv_1", "ACME_1", "agv_0"]
    assert [floor.frame for floor in more.floors] == ["hall", "Halle 2", "yard"] and checked(more) == []


def test_a_program_that_makes_up_vehicles_and_maps_fills_no_console() -> None:
    found = Discovery({"agv_1": []})
    found.vehicles = {"agv_1": ("KIT", "1")}
    config = DiscoveredSite(Link("mqtt://x"), {"vda5050": found}, {}, 1).config
    config = with_vehicles(config, [SeenVehicle("x", str(n), "", (f"map{n}",)) for n in range(3000)])
    assert (len(config.robots), len(config.floors)) == (MOST_VEHICLES, MOST_FLOORS) and checked(config) == []
