"""`order --until-done`: when an order was driven, and when it only looks like it."""

from pathlib import Path

import pytest

from fleet_tui.headless.driving import Drive
from fleet_tui.headless.outcome import DONE, Outcome
from fleet_tui.headless.session import WaitingStore
from fleet_tui.model.commands import Before, CommandRecord, PlaceOrder, Stage, Step
from fleet_tui.model.events import Event, QueueReported
from fleet_tui.model.order import OrderQueue
from fleet_tui.simulator.faults import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.fleets import R0, T0, WALL, fleet, graph, pose, queue, told
from tests.headless.running import asked, run

END = 7  # three metres from where the robot is at first
RECORD = CommandRecord(
    1, PlaceOrder(R0, 0, END), T0, WALL, (Step(Stage.CONFIRMED, T0),), Before(), order_id=5
)
QUEUED = Outcome(R0, "", "", "confirmed", "order 5 is in the queue", DONE, 5)
WAITS, DRIVES = queue(T0, (5, 0, END, "Q")), queue(T0, (5, 0, END, "W"), current=5)
GONE = QueueReported(R0, T0, OrderQueue(5, -1, ()))


@pytest.mark.parametrize(
    ("facts", "outcome", "words"),
    [
        ((DRIVES, pose(T0, 2.0), GONE), "done", "order 5 was driven"),
        ((DRIVES, queue(T0, (5, 0, END, "D"))), "done", "order 5 was driven"),
        ((DRIVES, GONE), "not done", "order 5 left the queue before robot_0 came to 7"),
        ((WAITS, GONE), "not done", "order 5 left the queue before it was begun"),
        ((DRIVES, queue(T0, (5, 0, END, "C"))), "not done", "order 5 was cancelled"),
        ((DRIVES, QueueReported(R0, T0, OrderQueue(0, -1, ()))), "not done", "began to count anew"),
        ((WAITS,), "not done", "order 5 is queued, and was not driven yet when the time was up"),
    ],
)
def test_what_the_queue_and_the_pose_say_of_it(facts: tuple[Event, ...], outcome: str, words: str) -> None:
    store = WaitingStore(told(fleet(), graph(0, 1, 2, END), pose(T0), WAITS))
    drive = Drive(RECORD, QUEUED)
    for fact in facts:
        store.tell(fact)
        found = drive.follow(store, 0.0)
    assert found.outcome == outcome and words in found.words
    assert (found.code == DONE) is (outcome == "done")


async def test_it_waits_until_it_is_driven(server: RosbridgeServer, folder: Path) -> None:
    robot = server.world.robots["robot_0"]
    robot.cargo = True

    def hurry(_dt: float) -> None:
        for _ in range(9 * bool(robot.orders)):
            robot.step()

    server.world.troubles.append(hurry)
    done = await run(folder, "order", "robot_0", "Consumidores", "--until-done")
    assert done.code == 0 and "done (order 1 was driven)" in done.out and not robot.orders
    assert robot.vertex == 19 and asked(server) == ["robot_0 Execute_order_with_cargo"]


async def test_a_robot_that_starts_anew_did_not_drive_it(server: RosbridgeServer, folder: Path) -> None:
    play(server, [("restart", "robot_0")])
    done = await run(folder, "order", "robot_0", "Base", "Consumidores", "--until-done")
    assert done.code == 1 and "order 1 is lost: robot_0 began to count anew" in done.err
    assert asked(server) == ["robot_0 Execute_order"]
