"""`fleet-tui routine check`: problems or a timeline, by its exit code."""

import json
from pathlib import Path

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import asked, config_file, run
from tests.support.routine_files import routine


async def test_a_good_one_is_shown_with_its_times(server: RosbridgeServer, folder: Path) -> None:
    routine(folder, "for robot_0 robot_1\ncarry Base Consumidores\nrun true\nend\n")
    done = await run(folder, "routine", "check", "day")
    assert (done.code, done.err) == (0, "") and done.out.startswith("day: no problems; if it started now:")
    assert "robot_1:\n    0:00  line 2    carry Base Consumidores (about " in done.out
    assert "line 3    run true (at most 10 min)" in done.out
    assert not asked(server)


async def test_every_problem_has_its_line(server: RosbridgeServer, folder: Path) -> None:
    routine(folder, "for robot_0\ngo Bse\nrepeat\nrun absent\nend\nend\n")
    done = await run(folder, "routine", "check", "day")
    first, second, third = done.err.splitlines()
    assert done.code == 1 and first == "day, line 2: robot_0 has no place 'Bse', did you mean Base?"
    assert second.startswith("day, line 3: endless repeat") and third.startswith(
        "day, line 4: absent: not found"
    )


async def test_as_json(server: RosbridgeServer, folder: Path) -> None:
    routine(folder, "for robot_0\nwait 5 s\nend\n")
    done = await run(folder, "routine", "check", "day", "--json")
    found = json.loads(done.out)
    assert (found["version"], found["problems"], found["no_link"]) == (1, [], "")
    (entry,) = found["timeline"]
    assert (entry["robot"], entry["line"], entry["seconds"]) == ("robot_0", 2, 5.0)


async def test_without_a_link_places_cannot_be_checked(folder: Path) -> None:
    config_file(folder, "ws://127.0.0.1:9")
    routine(folder, "for robot_0\ngo Base\nend\n")
    done = await run(folder, "routine", "check", "day", "--timeout", "0.5")
    assert done.code == 3 and "day: not checked against the robots: robot_0 is unreachable" in done.err


async def test_what_cannot_be_read_is_2_and_a_mistake_needs_no_link(folder: Path) -> None:
    config_file(folder, "ws://127.0.0.1:9")
    routine(folder, "go Base\n")
    assert (await run(folder, "routine", "check", "dya")).code == 2
    done = await run(folder, "routine", "check", "day")
    assert (done.code, done.err) == (1, "day, line 1: go outside a lane: put it between for ROBOT and end\n")
