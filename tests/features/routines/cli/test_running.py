"""`fleet-tui routine run`: orders one after the other, one line for each event."""

import asyncio
import json
import signal
from pathlib import Path

import pytest

from fleet_tui.features.routines.files import read_routine
from fleet_tui.features.routines.lane import Lane, LanePhase
from fleet_tui.features.routines.progress import RoutineProgress, progress_path, save_progress
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import asked, audited, config_file, run, started
from tests.support.polling import until
from tests.support.routine_files import hurry, routine


def consoles(folder: Path) -> list[str]:
    """The events of the routine in the audit log."""
    lines = (folder / "fleet-tui" / "audit.jsonl").read_text().splitlines()
    records = [json.loads(line) for line in lines]
    return [f"{one['change']}: {one['words']}" for one in records if one["change"].startswith("routine")]


def progress(folder: Path) -> str:
    """The saved progress, empty before there is any."""
    return "".join(path.read_text() for path in (folder / "fleet-tui" / "routines").glob("day-*.json"))


@pytest.mark.nightly
async def test_two_robots_drive_to_the_end(server: RosbridgeServer, folder: Path) -> None:
    hurry(server)
    routine(folder, "for robot_0 robot_1\ncarry Base Consumidores\nrun true\nend\n")
    done = await run(folder, "routine", "run", "day")
    assert (done.code, done.err) == (0, "")
    lines = [line.partition(" ")[2] for line in done.out.splitlines()]
    assert lines[0] == "day started: robot_0, robot_1"
    assert [line for line in lines if line.startswith("robot_0")] == [
        "robot_0 line 2: carry Base Consumidores: begun",
        "robot_0 line 2: carry Base Consumidores: done",
        "robot_0 line 3: run true: begun",
        "robot_0 line 3: run true: done",
        "robot_0 done",
    ]
    assert sorted(asked(server)) == ["robot_0 Execute_order", "robot_1 Execute_order"]
    assert audited(folder).count("robot_0 order done") == 1
    assert consoles(folder)[0] == "routine started: day: robot_0, robot_1"
    assert consoles(folder).count("routine done: day robot_0") == 1


async def test_a_failure_is_followed_by_its_part_and_told_by_the_exit_code(
    server: RosbridgeServer, folder: Path
) -> None:
    play(server, [("refuse", "robot_0")])
    routine(folder, "for robot_0\ncarry Base Consumidores\ngo Base\non failure\nrun true\nend\nend\n")
    done = await run(folder, "routine", "run", "day", "--json")
    events = [json.loads(line) for line in done.out.splitlines()]
    assert done.code == 1 and [(one["change"], one["line"]) for one in events] == [
        ("begun", 2),
        ("not done", 2),
        ("on failure", 0),
        ("begun", 5),
        ("done", 5),
        ("failed", 0),
    ]
    assert events[1]["detail"].startswith("refused") and events[0]["version"] == 1
    assert len(asked(server)) == 1


async def test_held_without_a_person_it_ends_and_can_be_resumed(
    server: RosbridgeServer, folder: Path
) -> None:
    hurry(server)
    server.world.robots["robot_0"].paused = True
    routine(folder, "for robot_0\ncarry Base Consumidores\nend\n")
    held = await run(folder, "routine", "run", "day", "--timeout", "0.5")
    assert held.code == 1 and "robot_0 is paused" in held.out and not asked(server)
    assert "day: held; go on with: fleet-tui routine run day --resume" in held.err
    assert (await run(folder, "routine", "list")).out.startswith("day  no time; robot_0; held ")
    server.world.robots["robot_0"].paused = False
    done = await run(folder, "routine", "run", "day", "--resume")
    assert done.code == 0 and len(asked(server)) == 1
    again = await run(folder, "routine", "run", "day", "--resume")
    assert again.code == 1 and "day has nothing to resume" in again.err


async def test_what_does_not_start(server: RosbridgeServer, folder: Path) -> None:
    routine(folder, "for robot_0\ngo Bse\nend\n")
    wrong = await run(folder, "routine", "run", "day")
    assert wrong.code == 1 and wrong.err.endswith("day: not started\n") and "line 2" in wrong.err
    assert (await run(folder, "routine", "run", "absent")).code == 2
    assert (await run(folder, "routine", "run", "day", "--skip")).code == 2
    config = folder / "config.toml"
    config.write_text(config.read_text() + "[operator]\narmed = false\n")
    off = await run(folder, "routine", "run", "day")
    assert off.code == 1 and "day: not started: this console is not armed" in off.err
    config_file(folder, "ws://127.0.0.1:9")
    assert (await run(folder, "routine", "run", "day")).code == 3
    assert not asked(server)


async def test_ctrl_c_leaves_the_order_and_a_resume_follows_it(server: RosbridgeServer, folder: Path) -> None:
    routine(folder, "for robot_0\ncarry Base Consumidores\nrun true\nend\n")
    process = await started(folder, "routine", "run", "day")
    await until(lambda: '"order_id":"1"' in progress(folder))
    process.send_signal(signal.SIGINT)
    _, err = await process.communicate()
    assert process.returncode == 130 and b"robot_0: order 1 goes on, nothing follows" in err
    resumed = asyncio.create_task(run(folder, "routine", "run", "day", "--resume"))
    await until(lambda: "routine resumed: day robot_0" in consoles(folder))
    hurry(server)
    done = await resumed
    assert done.code == 0 and len(asked(server)) == 1
    assert [line.partition(" ")[2] for line in done.out.splitlines()][1:3] == [
        "robot_0 resumed",
        "robot_0 line 2: carry Base Consumidores: done",
    ]


async def test_an_order_of_unknown_outcome_is_skipped_or_given_again(
    server: RosbridgeServer, folder: Path
) -> None:
    hurry(server)
    routine(folder, "for robot_0\ncarry Base Consumidores\nend\n")
    file = read_routine(folder / "routines", "day")
    lane = Lane("robot_0", phase=LanePhase.ORDERED, order_id="77")
    left = RoutineProgress(file.digest, (lane,), 0.0, 0.0)
    path = progress_path(folder / "fleet-tui" / "routines", file.path)
    for options, orders in ((["--skip"], 0), ([], 1)):
        save_progress(path, left)
        done = await run(folder, "routine", "run", "day", "--resume", *options)
        assert "order 77 left the queue while no console followed it" in done.out
        assert done.code == 0 and len(asked(server)) == orders
