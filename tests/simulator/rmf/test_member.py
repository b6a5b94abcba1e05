"""A simulated robot drives the places of its tasks."""

from fleet_tui.simulator.rmf.fleet import RmfFleet
from fleet_tui.simulator.rmf.member import CHARGING, PAUSED, SimMember
from fleet_tui.simulator.rmf.tasks import SimTask

ONE = "tiny/robot_0"


def member() -> tuple[RmfFleet, SimMember]:
    world = RmfFleet(1, 1, seed=1, quiet=True)
    return world, world.robots[ONE]


def test_tasks_are_driven_one_after_the_other() -> None:
    world, robot = member()
    first, second = SimTask("a", ("Store", "Base")), SimTask("b", ("Charger",))
    robot.assign(first)
    robot.assign(second)
    world.step(1.0)
    assert (first.status, second.status, robot.active) == ("underway", "queued", first)
    world.step(200.0)
    assert (first.status, second.status, robot.tasks) == ("completed", "completed", [])
    assert robot.mode == CHARGING


def test_an_interrupted_task_stands() -> None:
    world, robot = member()
    task = SimTask("a", ("Store",))
    robot.assign(task)
    world.step(3.0)
    task.interrupt([], 0)
    world.step(0.1)
    at = robot.body.pose
    world.step(20.0)
    assert robot.body.pose == at and robot.mode == PAUSED
    task.resume(["0"], [], 0)
    world.step(200.0)
    assert task.status == "completed"


def test_a_cancelled_task_ends_where_it_is() -> None:
    world, robot = member()
    task = SimTask("a", ("Store",))
    robot.assign(task)
    world.step(3.0)
    robot.cancel_task(task, ["x"], 5)
    assert (task.status, robot.tasks, robot.body.orders) == ("canceled", [], [])
