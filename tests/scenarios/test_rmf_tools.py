"""Tools for fleets of Open-RMF over a real loopback bridge: discovery, doctor, recording."""

import asyncio
import json
import re
import time
from pathlib import Path

from fleet_tui.cli.session import opened
from fleet_tui.config.schema import Link
from fleet_tui.config.start import initial_state
from fleet_tui.features.doctor.run import doctor
from fleet_tui.links.discovery.site import start_discovery
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.commands import PauseRobot
from fleet_tui.model.order import OrderState
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.play.cursor import RecordingCursor
from fleet_tui.records.recording.recorder import Recorder
from fleet_tui.simulator.rmf.faults import FAULTS
from tests.support.links import finished
from tests.support.rmf_site import FIRST, SECOND, Hospital, hospital, rmf_ready, to
from tests.support.watched_store import WatchedStore

WITHIN = 20.0
"""Seconds that doctor may take."""


async def findings(site: Hospital) -> tuple[int, dict[str, str]]:
    """The exit code of doctor, and what it measured by subject and check."""
    said: list[str] = []
    code = await asyncio.to_thread(doctor, site.config, WITHIN, True, said.append)
    checks = json.loads(said[-1])["findings"]
    return code, {f"{one['subject']} {one['check']}": f"{one['verdict']} {one['measured']}" for one in checks}


async def test_discovery_names_the_robots_of_all_fleets_and_the_levels() -> None:
    async with hospital(robots=4, floors=3) as site:
        found = await asyncio.wrap_future(start_discovery(Link(site.server.url)))
    assert [robot.name for robot in found.config.robots] == [
        *("carrier/robot_1", "carrier/robot_3", "tiny/robot_0", "tiny/robot_2")
    ]
    assert [floor.name for floor in found.config.floors] == ["floor_0", "floor_1", "floor_2"]
    assert 'kind = "rmf"' in found.text


async def test_doctor_finds_nothing_wrong_with_a_hospital_that_works() -> None:
    async with hospital() as site:
        code, checks = await findings(site)
    assert (code, {text.split()[0] for text in checks.values()}) == (0, {"ok"})
    assert "old, on floor_0" in checks[f"{SECOND} location"]
    assert "all vertices reachable" in checks["floor_0 graph"] and "all valid" in checks["floor_0 labels"]
    assert "all on free ground" in checks["floor_0 vertices"]


async def test_doctor_names_a_lost_robot_and_the_missing_packages() -> None:
    async with hospital() as site:
        site.fleet.robots[FIRST].silence = 1e9
        site.fleet._seen[FIRST] -= 60.0
        _, lost = await findings(site)
        site.server.bridge.services.unsourced |= {"rmf_task_msgs", "rmf_fleet_msgs"}
        code, lacking = await findings(site)
    assert re.fullmatch(r"fail 6\d s old, while its fleet adapter goes on", lost[f"{FIRST} location"])
    assert code == 1 and "the bridge lacks rmf_" in lacking["rosbridge messages"]


async def test_a_recording_plays_tasks_as_they_were(tmp_path: Path) -> None:
    path = tmp_path / "shift.jsonl.gz"
    async with hospital() as site:
        store = WatchedStore(initial_state(site.config, time.monotonic()))
        recorder = Recorder(path, site.config, store, Origin("ana", "here:1", "r"))
        with opened(FleetLink(site.config, store, recorder), site.config) as link:
            await store.until(rmf_ready)
            order = await finished(link, store, to("Store", "Base"))
            await store.until(lambda state: state.robots[FIRST].orders.current)
            FAULTS["lanes"][1](site.server, FIRST)
            await store.until(lambda state: any(one.closed for one in state.facilities.values()))
            await finished(link, store, PauseRobot(FIRST))
        recorder.close()
        last = store.state
    cursor = RecordingCursor(open_recording(path))
    while cursor.take():
        pass
    robot, lived = cursor.state.robots[FIRST], last.robots[FIRST]
    assert robot.orders == lived.orders and robot.orders.open[0].id == order.order_id
    assert robot.orders.open[0].state is OrderState.PAUSED
    assert robot.goals == lived.goals and robot.member == lived.member
    assert cursor.state.facilities == last.facilities and last.facilities
