"""Tests of features/doctor/broker_facts: `fleet-tui doctor` on a real broker."""

import asyncio
import json
from pathlib import Path

from tests.support.broker import BrokerAccess, broker_in, free_port
from tests.support.cli import run
from tests.support.vda_broker import SpokenFor
from tests.support.vda_fleet import config_text


async def examined(folder: Path, url: str) -> tuple[int, dict[str, str]]:
    (folder / "config.toml").write_text(config_text(url))
    done = await run(folder, "doctor", "--json", "--timeout", "8")
    report = json.loads(done.out)
    found = {f"{one['subject']} {one['check']}": one["verdict"] for one in report["findings"]}
    return done.code, found


async def test_a_vehicle_that_speaks_is_found_well(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        asking = asyncio.ensure_future(examined(tmp_path, broker.url))
        while not asking.done():
            vehicle.say()
            await asyncio.sleep(0.1)
        code, found = await asking
        assert vehicle.told == []
    assert found["broker mqtt"] == found["broker read access"] == found["agv state"] == "ok", found
    assert found["agv connection"] == "ok" and found["agv clock"] == "warn" and code == 0, found


async def test_a_broker_that_refuses_or_is_not_there(tmp_path: Path) -> None:
    with broker_in(tmp_path, BrokerAccess(refused="+/+/KIT/0001/state")) as broker:
        code, found = await examined(tmp_path, broker.url)
    assert code == 1 and found["broker read access"] == "fail" and found["agv connection"] == "fail"
    code, found = await examined(tmp_path, f"mqtt://127.0.0.1:{free_port()}")
    assert code == 3 and found["broker tcp"] == "fail"
