"""`fleet-tui run`: a file of commands, one after the other."""

import json
from pathlib import Path

import pytest

from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import asked, audited, config_file, run

TWICE = "# the same order twice\n\n  robot_0 Base > Consumidores\nrobot_0 Base > Consumidores\n"


async def test_two_same_orders_are_two_orders(server: RosbridgeServer, folder: Path) -> None:
    (folder / "batch").write_text(TWICE)
    done = await run(folder, "run", "batch")
    assert (done.code, done.err) == (0, "")
    assert "(seen in the queue as order 1)" in done.out and "(seen in the queue as order 2)" in done.out
    assert len(server.bridge.services.calls) == len(server.world.robots["robot_0"].orders) == 2
    assert audited(folder).count("robot_0 order confirmed") == 2


async def test_every_command_of_the_language_from_standard_input(
    server: RosbridgeServer, folder: Path
) -> None:
    lines = "robot_0 Base > Consumidores > Base\ncancel robot_0 2\nclear 0\nPAUSE ALL\nresume robot_1\n"
    done = await run(folder, "run", "-", "--json", "--yes", stdin=lines)
    said = [json.loads(line) for line in done.out.splitlines()]
    assert done.code == 0 and all(one["done"] for one in said) and len(said) == 7
    assert [name for name in asked(server) if "robot_0" in name] == [
        *("robot_0 Execute_order", "robot_0 Execute_order"),
        *("robot_0 Cancel_order", "robot_0 Clear_orders", "robot_0 Pause"),
    ]
    paused = {name: robot.paused for name, robot in server.world.robots.items()}
    assert paused == {"robot_0": True, "robot_1": False}


async def test_each_line_is_summed_up_once(server: RosbridgeServer, folder: Path) -> None:
    lines = "robot_0 Base > Consumidores > Base\npause all\nrobot_0 Base > Consumidores > Base\n"
    done = await run(folder, "run", "-", "--yes", "--keep-going", stdin=lines)
    assert (done.out + done.err).count("pause all: 2 confirmed") == 1


async def test_a_dry_run_sends_nothing(server: RosbridgeServer, folder: Path) -> None:
    (folder / "batch").write_text(TWICE + "clear robot_1\n")
    done = await run(folder, "run", "batch", "--dry-run")
    assert done.out == "robot_0 order Base -> Consumidores: would be sent\n" * 2
    assert (done.code, done.err) == (1, "robot_1 clear all orders: not sent (robot_1 has no orders)\n")
    assert not server.bridge.services.calls and not audited(folder)


async def test_nothing_is_sent_where_a_line_is_not_understood(server: RosbridgeServer, folder: Path) -> None:
    done = await run(folder, "run", "-", "--keep-going", stdin=TWICE + "robt_0 A > B\ncancel 1\n")
    first, second, third, _ = done.err.splitlines()
    assert done.code == 2 and first == "fleet-tui: nothing sent"
    assert second.startswith("line 5: unknown robot") and third.startswith("line 6: usage: cancel ROBOT ID")
    assert not server.bridge.services.calls


@pytest.mark.parametrize(("option", "calls"), [((), 1), (("--keep-going",), 3)])
async def test_the_first_failure_ends_it_unless_told_otherwise(
    server: RosbridgeServer, folder: Path, option: tuple[str, ...], calls: int
) -> None:
    play(server, [("refuse", "robot_0")])
    done = await run(folder, "run", "-", *option, stdin=TWICE + "pause robot_1")
    assert done.code == 1 and "refused (REJECTED" in done.err and len(server.bridge.services.calls) == calls
    assert ("stopped at line 3, 2 lines not sent" in done.err) is not bool(option)


async def test_files_that_are_none(folder: Path) -> None:
    (folder / "picture").write_bytes(b"\xff\xfe")
    for name, why in (("absent", "No such file"), (".", "Is a directory"), ("picture", "not UTF-8 text")):
        done = await run(folder, "run", name)
        assert done.code == 2 and f"{name}: " in done.err and why in done.err
    assert (await run(folder, "run", "-", stdin="# nothing\n")).code == 0


async def test_no_link_is_3(folder: Path) -> None:
    config_file(folder, "ws://127.0.0.1:9")
    done = await run(folder, "run", "-", "--timeout", "0.5", stdin=TWICE)
    assert done.code == 3 and "connection refused" in done.err


async def test_a_disarmed_console_sends_a_file_of_pauses_and_no_other(
    server: RosbridgeServer, folder: Path
) -> None:
    config = folder / "config.toml"
    config.write_text(config.read_text() + "[operator]\narmed = false\n")
    for lines in ("pause robot_0\nresume robot_0\n", "clear 0\n"):
        refused = await run(folder, "run", "-", "--yes", stdin=lines)
        assert refused.code == 1 and "nothing sent: this console is not armed" in refused.err
    assert not server.bridge.services.calls
    done = await run(folder, "run", "-", "--yes", stdin="# end of the shift\npause robot_0\npause 1\n")
    assert done.code == 0 and len(asked(server)) == 2
    assert all(robot.paused for robot in server.world.robots.values())
