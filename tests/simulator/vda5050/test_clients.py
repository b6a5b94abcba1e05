"""A vehicle on a broker."""

import json
from pathlib import Path

from fleet_tui.simulator.vda5050.serving import VehicleClient
from fleet_tui.simulator.vda5050.vehicle import SimVehicle
from tests.support.broker import broker_in
from tests.support.mqtt_peer import Peer
from tests.support.polling import eventually

BASE = "uagv/v2/fleet-tui/robot_0"


def test_it_announces_itself_tells_its_state_and_takes_any_message(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        peer = Peer(broker.port, "uagv/#")
        vehicle = SimVehicle("robot_0", (0.0, 0.0), "hall", "a")
        client = VehicleClient(vehicle, broker.port)
        eventually(lambda: peer.told_on(f"{BASE}/factsheet"))
        client.step(0.05, 10.0, 0.2)
        eventually(lambda: peer.told_on(f"{BASE}/state") and peer.told_on(f"{BASE}/visualization"))
        for payload in (b"no json", b"[]", b'{"nodes": 1}', b'{"orderId": 1, "nodes": [1]}'):
            peer.publish(f"{BASE}/order", payload)
        actions = {"actions": [{"actionType": "startPause", "actionId": "x"}]}
        peer.publish(f"{BASE}/instantActions", json.dumps(actions).encode())

        def is_paused() -> bool:
            client.step(0.05, 10.1, 0.2)
            return vehicle.paused

        eventually(is_paused)
        client.close()
        eventually(lambda: len(peer.told_on(f"{BASE}/connection")) == 2)
        words = [json.loads(text)["connectionState"] for text in peer.told_on(f"{BASE}/connection")]
        assert words == ["ONLINE", "OFFLINE"]
        peer.close()
