"""`fleet-tui order`, `cancel`, `clear`, `pause`, `resume`: what reaches the wire, what is said, the end."""

import asyncio
import json
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from fleet_tui.links.rosbridge import calls
from fleet_tui.links.rosbridge import probes as pulse
from fleet_tui.simulator.calls import Call
from fleet_tui.simulator.frames import Frame, Payload
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import Ended, asked, audited, config_file, run, started
from tests.support.polling import HANGS

STAGES = ("checked", "sent", "accepted", "confirmed")
ORDER = ("order", "robot_0", "Base", "Consumidores")


def carried_out(server: RosbridgeServer, service: str, answers: bool = False) -> asyncio.Event:
    """Told when a service was called; its answer is lost on the way, or not."""
    called = asyncio.Event()

    def deliver(call: Call, frame: Frame) -> None:
        called.set()
        if answers:
            call.reply(frame)

    server.bridge.services.deliveries[service] = deliver
    return called


async def test_an_order_is_done_when_it_is_in_the_queue(server: RosbridgeServer, folder: Path) -> None:
    done = await run(folder, *ORDER)
    said = "robot_0 order Base -> Consumidores: confirmed (seen in the queue as order 1)\n"
    assert done == Ended(0, said, "")
    assert asked(server) == ["robot_0 Execute_order"]
    assert audited(folder) == [f"robot_0 order {word}" for word in (*STAGES, "console closed")]


async def test_a_b_c_is_two_orders_one_after_the_other(server: RosbridgeServer, folder: Path) -> None:
    done = await run(folder, "order", "1", "Base", "id=19", "base", "--json")
    first, second = (json.loads(line) for line in done.out.splitlines())
    assert done.code == 0 and (first["order_id"], second["order_id"]) == ("1", "2")
    assert first["command"] == "order robot_1 Base Consumidores" and first["done"] is True
    assert (second["outcome"], second["robot"], second["version"]) == ("confirmed", "robot_1", 2)
    assert [(order.start, order.end) for order in server.world.robots["robot_1"].orders] == [(0, 19), (19, 0)]


async def test_labels_with_spaces(server: RosbridgeServer, folder: Path) -> None:
    labels = "/robot_0/floor_0/labeled_vertices"
    named = Payload({"vertices": [{"label": "Dock # 7", "vertex_id": 19}, {"label": "Base", "vertex_id": 0}]})
    server.bridge.topics[labels] = Topic(
        labels, server.bridge.services.types[labels], lambda _: named, latched=True
    )
    done = await run(folder, "order", "robot_0", "Base", "Dock # 7")
    assert done.code == 0 and "Base -> Dock # 7: confirmed" in done.out
    done = await run(folder, "run", "-", stdin='robot_0 Dock # 7 > Base\norder robot_0 Base "Dock # 7"\n')
    assert (done.code, done.out.count("confirmed"), len(server.bridge.services.calls)) == (0, 2, 3)


async def test_cargo_on_board_needs_only_a_destination(server: RosbridgeServer, folder: Path) -> None:
    server.world.robots["robot_0"].cargo = True
    done = await run(folder, "order", "robot_0", "Consumidores")
    assert done.code == 0 and asked(server) == ["robot_0 Execute_order_with_cargo"]


async def test_cancel_and_clear(server: RosbridgeServer, folder: Path) -> None:
    robot = server.world.robots["robot_0"]
    for number in (7, 8, 9):
        robot.take(0, 1, number)
    done = await run(folder, "cancel", "robot_0", "2")
    assert done == Ended(0, "robot_0 cancel order 2: confirmed (no longer in the queue)\n", "")
    assert [order.id for order in robot.orders] == [1, 3]
    done = await run(folder, "clear", "robot_0")
    assert done.code == 1 and len(robot.orders) == 2
    assert "not sent (robot_0 would lose 2 orders: use --yes to send anyway)" in done.err
    done = await run(folder, "clear", "robot_0", "--yes")
    assert done.code == 0 and not robot.orders
    for words in (("cancel", "robot_0", "2"), ("clear", "robot_0", "--yes"), ("cancel", "robot_0", "0")):
        assert (await run(folder, *words)).code == 1
    assert asked(server) == ["robot_0 Cancel_order", "robot_0 Clear_orders"]


async def test_pause_and_resume_one_or_all(server: RosbridgeServer, folder: Path) -> None:
    done = await run(folder, "pause", "--all")
    assert done.code == 0 and done.out.count("pause: confirmed by the robot\n") == 2
    assert sorted(asked(server)) == ["robot_0 Pause", "robot_1 Pause"]
    assert done.out.endswith("\npause all: 2 confirmed\n") and "pause all summary" in audited(folder)
    done = await run(folder, "resume", "robot_1")
    assert done == Ended(0, "robot_1 resume: confirmed by the robot\n", "")
    assert (await run(folder, "resume", "--all")).code == 0
    assert not any(robot.paused for robot in server.world.robots.values())
    assert "robot_1 pause confirmed" in audited(folder)


async def test_a_pause_waits_for_neither_rosapi_nor_the_robots(server: RosbridgeServer, folder: Path) -> None:
    server.bridge.services.silent_services.update(pulse.EVERY_QUESTION)
    server.bridge.muted.update(server.bridge.topics)
    done = await run(folder, "pause", "--all", "--timeout", "3")
    assert sorted(asked(server)) == ["robot_0 Pause", "robot_1 Pause"]
    assert done.code == 1 and done.err.count("not confirmed (accepted; no message on the pause topic)") == 2


async def test_a_dead_bridge_holds_up_no_pause_on_another(server: RosbridgeServer, folder: Path) -> None:
    config = (folder / "config.toml").read_text()
    config = config.replace('name = "robot_0"', 'name = "robot_0"\nlink = "dead"')
    (folder / "config.toml").write_text(config + '[links.dead]\nurl = "ws://127.0.0.1:9"\n')
    done = await run(folder, "pause", "--all")
    assert done.code == 1 and "robot_1 pause: confirmed" in done.out
    assert "robot_0 pause: not sent (no link" in done.err and "connection refused" in done.err
    steps = audited(folder)
    assert steps.index("robot_1 pause accepted") < steps.index("robot_0 pause checked")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("order", "robt_0", "Base", "Consumidores"), "unknown robot 'robt_0', did you mean robot_0?"),
        (("order", "robot_0", "Base", "Consumidor"), "did you mean Consumidores?"),
        (("order", "robot_0", "1", "999"), "robot_0 has no vertex 999"),
        (("cancel", "robot_0", "x"), "'x' is not an order id"),
        (("pause", "robot_7"), "did you mean robot_1?"),
        (("pause",), "missing robot: give its name, or --all"),
        (("resume", "robot_0", "--all"), "give the robot's name or --all, not both"),
        (("order", "robot_0"), "Missing argument"),
    ],
)
async def test_usage_is_2_with_the_nearest_name(
    server: RosbridgeServer, folder: Path, words: tuple[str, ...], said: str
) -> None:
    done = await run(folder, *words)
    assert done.code == 2 and said in done.err and not done.out and "Traceback" not in done.err
    assert not server.bridge.services.calls


@pytest.mark.parametrize("words", [ORDER, ("pause", "--all"), ("clear", "robot_0"), ("resume", "robot_0")])
async def test_no_link_is_3_with_its_reason(tmp_path: Path, words: tuple[str, ...]) -> None:
    config_file(tmp_path, "ws://127.0.0.1:9")
    done = await run(tmp_path, *words, "--timeout", "0.5")
    assert done.code == 3 and "not sent" in done.err and "connection refused" in done.err
    as_json = await run(tmp_path, *words, "--timeout", "0.1", "--json")
    said = json.loads(as_json.out)
    assert as_json.code == 3 and (said["outcome"], said["done"]) == ("not sent", False)


async def test_warnings_hold_it_back_unless_yes(server: RosbridgeServer, folder: Path) -> None:
    server.world.robots["robot_0"].paused = True
    done = await run(folder, *ORDER)
    assert done.code == 1 and "not sent (robot_0 is paused: use --yes to send anyway)" in done.err
    assert not server.bridge.services.calls
    assert (await run(folder, *ORDER, "--yes")).code == 0
    same = await run(folder, "order", "robot_0", "Base", "Base", "--yes")
    assert same.code == 1 and "From and To are the same place: Base" in same.err
    assert len(server.bridge.services.calls) == 1


async def test_what_never_came_is_a_warning(server: RosbridgeServer, folder: Path) -> None:
    server.bridge.muted.add("/robot_0/cargo")
    done = await run(folder, *ORDER, "--timeout", "1")
    assert done.code == 1 and "robot_0: cargo missing: use --yes to send anyway" in done.err
    server.bridge.muted.add("/robot_0/floor_0/labeled_vertices")
    server.bridge.muted.add("/robot_0/floor_0/graph")
    done = await run(folder, *ORDER, "--timeout", "1")
    assert done.code == 1 and "cargo, graph of floor_0 missing" in done.err
    assert not server.bridge.services.calls


@pytest.mark.parametrize(
    ("setting", "said"),
    [("read_only = true", "read-only: operator.read_only"), ("armed = false", "not armed: operator.armed")],
)
async def test_the_config_may_forbid_it(
    server: RosbridgeServer, folder: Path, setting: str, said: str
) -> None:
    with (folder / "config.toml").open("a") as file:
        file.write(f"[operator]\n{setting}\n")
    for words in (ORDER, ("resume", "--all"), ("clear", "robot_0")):
        done = await run(folder, *words)
        assert done.code == 1 and said in done.err
    done = await run(folder, "run", "config.toml")
    assert done.code == 1 and said in done.err
    paused = await run(folder, "pause", "--all")
    # As in the console: not being armed holds back no pause, being read-only everything.
    if "armed" in setting:
        assert (paused.code, len(server.bridge.services.calls)) == (0, 2)
    else:
        assert (
            paused.code == 1
            and "not sent (this console is read-only)" in paused.err
            and not server.bridge.services.calls
        )
        assert audited(folder)[-2:] == ["robot_1 pause not sent", "pause all summary"]


@pytest.mark.parametrize(
    ("fault", "code", "said"),
    [
        ("refuse", 1, "refused (REJECTED: the simulator was asked to refuse)"),
        ("never", 1, "not confirmed (no answer: "),
        ("late", 0, "confirmed (seen in the queue as order 1)"),
        ("twice", 0, "confirmed (seen in the queue as order 1)"),
        ("wrong-id", 0, "confirmed (seen in the queue as order 1)"),
        ("drop", 0, "confirmed (seen in the queue as order 1)"),
    ],
)
async def test_what_a_robot_can_do_wrong(
    server: RosbridgeServer, folder: Path, fault: str, code: int, said: str
) -> None:
    play(server, [(fault, "robot_0")])
    done = await run(folder, *ORDER)
    assert done.code == code and said in (done.err if code else done.out)
    assert asked(server) == ["robot_0 Execute_order"]


async def test_a_chain_stops_where_it_goes_wrong(server: RosbridgeServer, folder: Path) -> None:
    play(server, [("refuse", "robot_0")])
    done = await run(folder, "order", "robot_0", "Base", "Consumidores", "Base")
    assert done.code == 1 and "not sent (the previous command failed)" in done.err
    assert len(server.bridge.services.calls) == 1


async def test_time_that_is_up_leaves_the_outcome_unknown(server: RosbridgeServer, folder: Path) -> None:
    config = (folder / "config.toml").read_text().replace("= 1.0", "= 50.0")
    (folder / "config.toml").write_text(config)
    play(server, [("never", "robot_0")])
    done = await run(folder, *ORDER, "--timeout", "2")
    assert done.code == 1 and "outcome unknown (last stage sent; no further report within 2 s" in done.err


@pytest.mark.parametrize(
    ("number", "code"),
    [
        (signal.SIGINT, 130),
        pytest.param(signal.SIGTERM, 143, marks=pytest.mark.nightly),
        pytest.param(signal.SIGHUP, 129, marks=pytest.mark.nightly),
    ],
)
async def test_ended_from_outside_it_says_what_is_not_known(
    server: RosbridgeServer, folder: Path, number: signal.Signals, code: int
) -> None:
    called = carried_out(server, "/robot_0/Application_layout/Execute_order")
    process = await started(folder, *ORDER)
    await asyncio.wait_for(called.wait(), HANGS)
    process.send_signal(number)
    _, err = await asyncio.wait_for(process.communicate(), HANGS)
    assert process.returncode == code
    assert (
        b"outcome unknown" in err
        and b"may still be carried out; check with fleet-tui status and fleet-tui audit" in err
    )
    assert b"Traceback" not in err
    assert audited(folder)[-1] == "robot_0 order console closed"


async def test_ctrl_c_before_anything_was_sent(server: RosbridgeServer, folder: Path) -> None:
    server.bridge.muted.add("/robot_0/queue")
    connected = carried_out(server, calls.TIME, answers=True)
    process = await started(folder, *ORDER)
    await asyncio.wait_for(connected.wait(), HANGS)
    process.send_signal(signal.SIGINT)
    _, err = await asyncio.wait_for(process.communicate(), HANGS)
    assert (process.returncode, b"nothing else sent" in err) == (130, True), err
    assert not server.bridge.services.calls


def test_no_screen_is_imported(tmp_path: Path) -> None:
    config_file(tmp_path, "ws://127.0.0.1:9")
    code = (
        "import sys; from fleet_tui.__main__ import main\n"
        "sys.argv = ['fleet-tui', *sys.argv[1:]]\n"
        "try: main()\nexcept SystemExit: pass\n"
        "print([name for name in sys.modules if name.split('.')[0] in ('textual', 'rich', 'PIL')])"
    )
    for words in (["pause", "--all"], list(ORDER), ["run", "config.toml", "--dry-run"]):
        done = subprocess.run(
            [sys.executable, "-c", code, *words, "--timeout", "0.2"],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=True,
        )
        assert done.stdout.splitlines()[-1] == "[]"


async def test_a_service_of_another_type_is_not_called_by_a_fresh_process(
    server: RosbridgeServer, folder: Path
) -> None:
    """`resume` waits for no report, and so it is there before rosapi has told any type."""
    service = "/robot_0/Application_layout/Resume"
    server.bridge.services.offered[service] = replace(
        server.bridge.services.offered[service], name="nav2_msgs/srv/ManageLifecycleNodes"
    )
    done = await run(folder, "resume", "robot_0")
    assert done.code == 1 and "has type nav2_msgs/srv/ManageLifecycleNodes, not std_srvs/Trigger" in done.err
    assert not server.bridge.services.calls
    chain = await run(folder, "order", "robot_0", "Base", "Consumidores", "Base")
    assert chain.code == 0
    assert [args["end_point"] for _, args in server.bridge.services.calls] == [19, 0]


async def test_a_pause_by_a_service_of_another_type_never_leaves_a_fresh_process(
    server: RosbridgeServer, folder: Path
) -> None:
    service = "/robot_0/Application_layout/Pause"
    server.bridge.services.offered[service] = replace(
        server.bridge.services.offered[service], name="nav2_msgs/srv/ManageLifecycleNodes"
    )
    done = await run(folder, "pause", "robot_0")
    assert done.code == 1 and "has type nav2_msgs/srv/ManageLifecycleNodes, not std_srvs/Trigger" in done.err
    assert not server.bridge.services.calls
