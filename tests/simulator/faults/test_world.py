"""Faults on request: they are named right, and the simulator does what they say."""

import json

import pytest

from fleet_tui.simulator.faults import FAULTS, parse_faults
from fleet_tui.simulator.faults.plays import FLAT
from fleet_tui.simulator.faults.world import FOREIGN, FOREIGN_PAUSE, JUMP
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.oh_ressources.messages import topics_of
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.errors import ConfigError

NAMES = ["robot_0", "robot_1"]
ORDER = "/robot_0/Application_layout/Execute_order"


def test_a_fault_is_every_robots_or_one_robots() -> None:
    assert parse_faults("", NAMES) == []
    assert parse_faults("stuck, late:robot_1", NAMES) == [
        ("stuck", "robot_0"),
        ("stuck", "robot_1"),
        ("late", "robot_1"),
    ]


def test_every_wrong_name_is_answered_with_the_nearest() -> None:
    with pytest.raises(ConfigError) as raised:
        parse_faults("obstcle,stuck:robt_1,refuse", NAMES)
    assert raised.value.problems == [
        "--fault obstcle: unknown fault, did you mean obstacle?",
        "--fault stuck:robt_1: unknown robot, did you mean robot_1?",
    ]
    for name in ("zzz", "list"):
        with pytest.raises(ConfigError, match="unknown fault: refuse, late, "):
            parse_faults(name, NAMES)


def planted(name: str) -> OhFleet:
    """robot_0 with the fault and an order to drive, robot_1 without either."""
    server = RosbridgeServer(OhFleet(2, 1, seed=1, quiet=True))
    play(server, parse_faults(f"{name}:robot_0", server.world.robots))
    args = {"request_id": 1, "initial_point": 19, "end_point": 0}
    if name != "silent":
        server.bridge.services.answer({"service": ORDER, "args": args})
    return server.world


@pytest.mark.parametrize("name", ["obstacle", "stuck", "paused"])
def test_a_robot_that_is_held_stays_where_it_is(name: str) -> None:
    world = planted(name)
    robot = world.robots["robot_0"]
    at = robot.pose.x, robot.pose.y
    world.step(120)
    assert (robot.pose.x, robot.pose.y) == at
    assert robot.orders
    assert robot.obstacle == pytest.approx(120 if name == "obstacle" else 0.0, abs=0.1)
    assert robot.current_order_id == (1 if name == "stuck" else -1)


def test_a_pause_ends_with_a_resume() -> None:
    world = planted("paused")
    world.answer("/robot_0/Application_layout/Resume", {})
    world.step(200)
    assert not world.robots["robot_0"].orders


def test_the_other_faults_of_a_robot() -> None:
    world = planted("battery")
    world.step(5)
    assert world.robots["robot_0"].battery <= FLAT < world.robots["robot_1"].battery
    world = planted("silent")
    world.step(3600)
    assert world.robots["robot_0"].silence > 0.0
    world = planted("restart")
    world.step(1)
    assert world.robots["robot_0"].last_order_id == 1
    world.robots["robot_0"].paused = True
    world.step(2)
    robot = world.robots["robot_0"]
    assert (robot.orders, robot.last_order_id, robot.paused) == ([], 0, False)


def statuses(world: OhFleet) -> list[str]:
    """The status of each order in the report of robot_0's queue."""
    (queue,) = (topic for topic in topics_of(world, 0.0) if topic.name == "/robot_0/queue")
    return [order["status"] for order in json.loads(queue.payload(0.0).json)["orders"]]


def test_another_console_cancels_each_order() -> None:
    world = planted("foreign-cancel")
    world.step(FOREIGN - 0.2)
    assert statuses(world) == ["W"]
    world.step(0.3)
    assert statuses(world) == ["C"]
    world.robots["robot_0"].take(0, 19, request_id=2)
    world.step(0.5)
    assert statuses(world) == ["W"]  # of the second: the first was reported once as cancelled
    assert world.robots["robot_0"].last_order_id == 2
    world.step(FOREIGN)
    assert statuses(world) == ["C"]


def test_another_console_pauses_once_for_a_while() -> None:
    world = planted("foreign-pause")
    seen = []
    for _ in range(15):
        world.step(1.0)
        seen.append(world.robots["robot_0"].paused)
    assert seen.count(True) == round(FOREIGN_PAUSE)
    assert seen.index(True) in (2, 3)


def test_another_console_is_as_slow_in_a_fast_world() -> None:
    server = RosbridgeServer(OhFleet(1, 1, seed=1, quiet=True), speed=10.0)
    play(server, parse_faults("foreign-cancel", server.world.robots))
    server.world.robots["robot_0"].take(19, 0, request_id=1)
    server.world.step(10 * FOREIGN - 1.0)
    assert statuses(server.world) == ["W"]
    server.world.step(2.0)
    assert statuses(server.world) == ["C"]


def test_a_lost_robot_jumps_to_and_fro_and_gets_nowhere() -> None:
    world = planted("jumping")
    robot = world.robots["robot_0"]
    seen = []
    for _ in range(20):
        world.step(0.5)
        seen.append(robot.pose.x)
    assert max(seen) - min(seen) == pytest.approx(JUMP)
    assert len({round(x, 6) for x in seen}) == 2


def test_every_fault_says_what_it_does() -> None:
    assert all(text for text, _ in FAULTS.values())
