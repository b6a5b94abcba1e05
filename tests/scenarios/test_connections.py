"""What a broker keeps of vehicles, against what they do: `fleet-tui status` on a real broker."""

import asyncio
import json
from pathlib import Path
from typing import Any

from tests.support.broker import RealBroker, broker_in
from tests.support.cli import run
from tests.support.mqtt_peer import Peer
from tests.support.vda_fleet import config_text
from tests.support.vda_messages import BASE, message, state

BROKEN = message(connectionState="CONNECTIONBROKEN")


async def asked(folder: Path, broker: RealBroker) -> tuple[int, dict[str, Any]]:
    (folder / "config.toml").write_text(config_text(broker.url))
    done = await run(folder, "status", "--json")
    return done.code, json.loads(done.out)


async def test_a_vehicle_of_which_the_broker_keeps_the_last_will_is_an_alarm_of_the_first_status(
    tmp_path: Path,
) -> None:
    with broker_in(tmp_path) as broker:
        Peer(broker.port).publish(f"{BASE}/connection", BROKEN, retain=True, qos=1)
        code, found = await asked(tmp_path, broker)
    assert code == 1 and found["attention"] == ["agv: offline (connection broken)"]
    assert [alarm["kind"] for alarm in found["alarms"]] == ["offline"]


async def test_a_live_vehicle_beside_its_stale_last_will_is_online_in_status(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = Peer(broker.port)
        vehicle.publish(f"{BASE}/connection", BROKEN, retain=True, qos=1)
        asking = asyncio.ensure_future(asked(tmp_path, broker))
        while not asking.done():
            vehicle.publish(f"{BASE}/state", state())
            await asyncio.sleep(1.0)
        code, found = await asking
    assert found["robots"][0]["online"] and found["alarms"] == [] and code == 0
