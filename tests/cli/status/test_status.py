"""`fleet-tui status`: what it prints, its exit code, and what it does without a screen."""

import asyncio
import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.cli.status.report import attention, changes, report
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import config_file, run, started
from tests.support.fleets import LINK, T0, fleet, link_up, reduced, tick
from tests.support.polling import HANGS


async def test_all_well_is_0_and_the_whole_fleet(server: RosbridgeServer, tmp_path: Path) -> None:
    config_file(tmp_path, server.url, 2, 2)
    done = await run(tmp_path, "status")
    assert (done.code, done.err) == (0, "")
    assert server.url in done.out and "all well" in done.out
    assert "robot_0" in done.out and "robot_1" in done.out
    assert not server.bridge.services.calls


async def test_json_says_the_same_with_a_version(server: RosbridgeServer, tmp_path: Path) -> None:
    server.world.robots["robot_0"].take(0, 1, 7)
    config_file(tmp_path, server.url, 2, 2)
    done = await run(tmp_path, "status", "--json")
    report = json.loads(done.out)
    assert (done.code, report["version"], report["attention"]) == (0, 2, [])
    assert [link["state"] for link in report["links"]] == ["up"]
    first = report["robots"][0]
    assert first["online"] and first["never_came"] == [] and first["floor"] == "floor_0"
    assert [(order["start"], order["end"], order["status"]) for order in first["orders"]] == [("0", "1", "W")]
    assert first["orders"][0]["start_label"] == "Base"


@pytest.mark.parametrize("option", ["--json", "--oneline", "--debug"])
async def test_what_needs_attention_is_1_and_named(
    server: RosbridgeServer, tmp_path: Path, option: str
) -> None:
    server.world.robots["robot_1"].battery = 5.0
    config_file(tmp_path, server.url, 2, 2)
    done = await run(tmp_path, "status", option)
    assert done.code == 1
    assert "robot_1: battery" in done.out


async def test_what_never_came_is_named(server: RosbridgeServer, tmp_path: Path) -> None:
    server.bridge.muted.update(["/robot_0/queue", "/robot_0/paused"])
    config_file(tmp_path, server.url, 1)
    done = await run(tmp_path, "status", "--timeout", "4")
    assert done.code == 1
    assert "robot_0: queue missing" in done.out
    assert "queue missing" in done.out and "idle" not in done.out
    robot = json.loads((await run(tmp_path, "status", "--json", "--timeout", "1")).out)["robots"][0]
    assert (robot["paused"], robot["orders"]) == (None, None)


async def test_no_link_is_3_with_its_reason_within_the_timeout(tmp_path: Path) -> None:
    config_file(tmp_path, "ws://127.0.0.1:9")
    done = await run(tmp_path, "status", "--timeout", "0.5")
    assert done.code == 3
    assert "no link" in done.out and "connection refused" in done.out


async def test_commands_that_nothing_vouches_for_need_attention(
    server: RosbridgeServer, tmp_path: Path
) -> None:
    play(server, [("lost-master", "robot_0")])
    config_file(tmp_path, server.url)
    done = await run(tmp_path, "status")
    assert done.code == 1 and "all well" not in done.out
    assert "rosbridge: commands not tried yet: no node answers: start rosapi" in done.out
    (link,) = json.loads((await run(tmp_path, "status", "--json")).out)["links"]
    assert link["commands"] == "untried"


async def test_a_site_without_rosapi_is_well(server: RosbridgeServer, tmp_path: Path) -> None:
    play(server, [("dead-rosapi", "robot_0")])
    config_file(tmp_path, server.url)
    done = await run(tmp_path, "status")
    assert done.code == 0 and "all well" in done.out


async def test_who_may_only_read_is_told_of_a_site_without_rosapi_that_no_command_was_tried(
    server: RosbridgeServer, tmp_path: Path
) -> None:
    play(server, [("dead-rosapi", "robot_0")])
    path = config_file(tmp_path, server.url)
    path.write_text(f"{path.read_text()}\n[operator]\nread_only = true\n")
    done = await run(tmp_path, "status")
    assert done.code == 0 and "all well" not in done.out
    assert "commands not tried yet: rosapi does not answer" in done.out
    asked = {one["service"] for one in server.bridge.received if one["op"] == "call_service"}
    assert all(service.startswith("/rosapi/") for service in asked)


async def test_one_line_fits_a_status_bar(server: RosbridgeServer, tmp_path: Path) -> None:
    config_file(tmp_path, server.url, 2, 2)
    done = await run(tmp_path, "status", "--oneline")
    assert done.out == "2/2 online\n"
    config_file(tmp_path, "ws://127.0.0.1:9/" + "x" * 200)
    (line,) = (await run(tmp_path, "status", "--oneline", "--timeout", "0.3")).out.splitlines()
    assert len(line) < 80 and "no link" in line


async def test_a_robot_that_was_never_seen_is_named_once(server: RosbridgeServer, tmp_path: Path) -> None:
    server.world.robots["robot_1"].silence = float("inf")
    config_file(tmp_path, server.url, 2)
    done = await run(tmp_path, "status", "--timeout", "6")
    assert done.code == 1
    assert [line for line in done.out.splitlines() if line[0] == "!"] == ["! robot_1: never seen"]


async def test_one_line_is_watched_as_one_line(server: RosbridgeServer, tmp_path: Path) -> None:
    config_file(tmp_path, server.url, 1)
    process = await started(tmp_path, "status", "--watch", "--oneline")
    assert process.stdout is not None
    async with asyncio.timeout(HANGS):
        assert await process.stdout.readline() == b"1/1 online\n"
        server.world.robots["robot_0"].battery = 5.0
        assert b"! robot_0: battery" in await process.stdout.readline()
        process.send_signal(signal.SIGINT)
        rest, _ = await process.communicate()
    assert process.returncode == 130
    assert all(b"/1 online" in line for line in rest.splitlines())


async def test_a_locale_without_the_signs_gets_others(
    server: RosbridgeServer, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTHONIOENCODING", "latin-1")
    config_file(tmp_path, server.url, 1)
    process = await started(tmp_path, "status")
    out, err = await asyncio.wait_for(process.communicate(), HANGS)
    assert (process.returncode, err) == (0, b"")
    said = out.decode("latin-1")
    assert "* 0 robot_0" in said and "all well" in said


async def test_watch_says_what_changes_as_json_lines(server: RosbridgeServer, tmp_path: Path) -> None:
    config_file(tmp_path, server.url, 1)
    process = await asyncio.create_subprocess_exec(
        *(sys.executable, "-m", "fleet_tui", "status", "--watch", "--json"),
        cwd=tmp_path,
        env={**os.environ, "XDG_STATE_HOME": str(tmp_path)},
        stdout=asyncio.subprocess.PIPE,
    )
    assert process.stdout is not None
    first = json.loads(await asyncio.wait_for(process.stdout.readline(), HANGS))
    assert first["robots"][0]["battery_percent"] > 20
    server.world.robots["robot_0"].battery = 5.0
    async with asyncio.timeout(HANGS):
        async for line in process.stdout:
            changed = json.loads(line)["changed"]
            if "attention" in changed:
                break
    assert changed["attention"] == ["robot_0: battery 5 %"] or "battery" in changed["attention"][0]
    process.send_signal(signal.SIGINT)
    assert await asyncio.wait_for(process.wait(), HANGS) == 130


def test_a_console_that_is_behind_and_a_bridge_that_is_late_need_attention_at_once() -> None:
    up = reduced(fleet(), link_up(T0), tick(T0))
    assert not any("behind" in line or "late" in line for line in attention(up))
    state = replace(up, behind=2.4)
    assert "console: this console is 2.4 s behind" in attention(state) and report(state)["behind_s"] == 2.4
    state = replace(up, links={LINK: replace(up.links[LINK], late=3.0)})
    assert attention(state)[0].startswith("rosbridge: messages 3.0 s late, 1 robot silent: bridge overloaded")
    assert report(state)["links"][0]["late_s"] == 3.0 and not changes(report(up), report(state)).get("links")


def test_a_link_has_its_site() -> None:
    up = reduced(fleet(), link_up(T0), tick(T0))
    assert report(up)["links"][0]["site"] is None
    state = replace(up, links={LINK: replace(up.links[LINK], site="plant-a")})
    assert report(state)["links"][0]["site"] == "plant-a"


def test_ages_alone_are_no_change() -> None:
    def at(age: float, floor: str = "floor_0") -> dict[str, object]:
        robot = {"name": "robot_0", "floor": floor, "heard_s": age, "pose": {"x_m": 1.0, "age_s": age}}
        return {"time": age, "links": [], "robots": [robot], "alarms": [], "attention": []}

    assert changes(at(1.0), at(2.0)) == {}
    assert changes(at(1.0), at(2.0, "floor_1"))["changed"]["robots"][0]["floor"] == "floor_1"


def test_no_screen_is_imported(tmp_path: Path) -> None:
    config_file(tmp_path, "ws://127.0.0.1:9")
    code = (
        "import sys; from fleet_tui.__main__ import main\n"
        "sys.argv = ['fleet-tui', 'status', '--timeout', '0.2']\n"
        "try: main()\nexcept SystemExit: pass\n"
        "print([name for name in sys.modules if name.split('.')[0] in ('textual', 'rich', 'PIL')])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "[]"
