"""The command line on a simulated Nav2 fleet."""

import json
from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.records import Keyframe
from fleet_tui.simulator.nav2.faults import FAULTS
from fleet_tui.simulator.nav2.navigation import TO_POSE
from fleet_tui.simulator.ros.goals import EXECUTING, SUCCEEDED
from tests.support.cli import audited, run
from tests.support.nav2_site import Site, nav2_site

FAR = (35.0, 20.0)


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[Site]:
    """Two robots with Nav2, and a configuration for them in a file."""
    async with nav2_site(tmp_path, rate=20.0) as running:
        (floor,) = running.config.floors
        text = (
            f'[rosbridge]\nurl = "{running.server.url}"\n'
            "[alarms]\nno_answer_after = 1.0\nnot_confirmed_after = 4.0\n"
            f'[profile]\nkind = "nav2"\n[[floors]]\nname = "floor_0"\ngraph = "{floor.graph}"\n'
            '[[robots]]\nname = "robot_0"\n[[robots]]\nname = "robot_1"\n'
        )
        (tmp_path / "config.toml").write_text(text)
        running.fleet.robots["robot_1"].percent = 0.01
        yield running


async def test_status_tells_what_such_robots_have_and_nothing_else(site: Site, tmp_path: Path) -> None:
    site.server.speed = 1.0
    site.navigation().give(*FAR)
    done = await run(tmp_path, "status", "--json")
    report = json.loads(done.out)
    first, second = report["robots"]
    assert first["online"] and first["floor"] == "floor_0" and first["never_came"] == []
    assert 0.0 < first["battery_percent"] <= 100.0
    assert not {"cargo", "obstacle", "obstacle_s"} & set(first)
    (order,) = first["orders"]
    assert first["not_ours"] == [order["id"]] and order["status"] == "executing"
    assert first["held"] is None and first["kept_here"] == []
    assert second["orders"] is None and second["not_ours"] == []
    assert done.code == 0, report["attention"]


async def test_the_table_of_the_fleet(site: Site, tmp_path: Path) -> None:
    done = await run(tmp_path, "status")
    assert (done.code, done.err) == (0, ""), done.out
    assert "robot_1" in done.out and "cargo" not in done.out.lower() and "missing" not in done.out


@pytest.mark.parametrize("may_only_read", [False, True])
@pytest.mark.parametrize(
    ("fault", "text"),
    [
        ("inactive", "robot_0: Nav2 inactive: paused or not started"),
        ("node-down", "robot_0: Nav2 inactive: controller_server down"),
        ("bring-up", "robot_0: Nav2 inactive: no pose yet: set one"),
    ],
)
async def test_status_names_a_navigation_that_is_not_active(
    site: Site, tmp_path: Path, fault: str, text: str, may_only_read: bool
) -> None:
    if may_only_read:
        with (tmp_path / "config.toml").open("a") as config:
            config.write("[operator]\nread_only = true\n")
    site.server.speed = 1.0
    FAULTS[fault][1](site.server, "robot_0")
    done = await run(tmp_path, "status")
    assert done.code == 1 and text in done.out, done.out
    questions = {name.rpartition("/")[2] for name, _ in site.server.bridge.services.calls}
    assert questions <= (set() if may_only_read else {"is_active", "get_state"})


async def test_an_order_until_it_is_driven(site: Site, tmp_path: Path) -> None:
    done = await run(tmp_path, "order", "robot_0", "Receiving", "Base", "--until-done")
    assert (done.code, done.err) == (0, "")
    assert "robot_0 order Receiving -> Base: done" in done.out
    stages = ("checked", "sent", "accepted", "confirmed", "done")
    assert audited(tmp_path) == [f"robot_0 order {stage}" for stage in stages]
    shown = await run(tmp_path, "audit", "--robot", "robot_0")
    assert shown.code == 0 and "Receiving -> Base" in shown.out


async def test_an_order_goes_on_when_the_command_line_has_ended(site: Site, tmp_path: Path) -> None:
    done = await run(tmp_path, "order", "robot_0", "Receiving")
    assert done.code == 0 and "confirmed (seen in the queue as order " in done.out
    (goal,) = site.navigation().servers[TO_POSE].goals.values()
    assert goal.status in (EXECUTING, SUCCEEDED)


async def test_without_a_console_no_second_order_waits(site: Site, tmp_path: Path) -> None:
    site.server.speed = 1.0
    site.navigation().give(*FAR)
    done = await run(tmp_path, "order", "robot_0", "Receiving")
    assert done.code == 1 and "robot_0 has an order and has no queue" in done.err
    assert len(site.navigation().received) == 1


async def test_cancel_by_the_id_that_status_tells(site: Site, tmp_path: Path) -> None:
    site.server.speed = 1.0
    goal = site.navigation().give(*FAR)
    assert goal is not None
    done = await run(tmp_path, "cancel", "robot_0", goal.id.hex()[:8])
    assert done.code == 0 and "confirmed (no longer in the queue)" in done.out
    assert not site.navigation().servers[TO_POSE].running
    done = await run(tmp_path, "cancel", "robot_0", "k9")
    assert done.code == 2 and len(site.cancels()) == 1


async def test_pause_stops_all_and_says_that_nothing_is_kept(site: Site, tmp_path: Path) -> None:
    site.server.speed = 1.0
    for robot in site.fleet.robots:
        site.navigation(robot).give(*FAR)
    done = await run(tmp_path, "pause", "--all")
    assert done.code == 0, done.err
    assert not any(robot.driving for robot in site.fleet.robots.values())


async def test_a_recording_can_be_opened_anywhere(site: Site, tmp_path: Path) -> None:
    site.navigation().give(*FAR)
    done = await run(tmp_path, "record", "x.jsonl.gz", "--for", "3s")
    assert done.code == 0, done.err
    recording = open_recording(tmp_path / "x.jsonl.gz")
    keyframes = [one for one in recording.records() if isinstance(one, Keyframe)]
    assert keyframes and set(keyframes[0].fleet_state().robots) == {"robot_0", "robot_1"}
