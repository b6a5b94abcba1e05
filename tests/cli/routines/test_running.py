"""`fleet-tui routine run`: orders one after the other, one line for each event."""

import json
from pathlib import Path

from fleet_tui.simulator.faults import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import asked, audited, config_file, run
from tests.support.routine_files import hurry, routine


def consoles(folder: Path) -> list[str]:
    """The events of the routine in the audit log."""
    lines = (folder / "fleet-tui" / "audit.jsonl").read_text().splitlines()
    records = [json.loads(line) for line in lines]
    return [f"{one['change']}: {one['words']}" for one in records if one["change"].startswith("routine")]


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
