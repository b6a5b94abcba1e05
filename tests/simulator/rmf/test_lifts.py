"""Simulated lifts and doors follow robots."""

from fleet_tui.simulator.rmf.fleet import RmfFleet
from fleet_tui.simulator.rmf.lifts import CLOSED, OPEN
from fleet_tui.simulator.rmf.tasks import SimTask


def test_the_lift_goes_where_a_robot_rides() -> None:
    world = RmfFleet(1, 2, seed=1, quiet=True)
    robot = next(iter(world.robots.values()))
    robot.assign(SimTask("a", ("Kitchen",)))
    seen = set()
    for _ in range(400):
        world.step(0.5)
        seen.add((world.lift.session, world.lift.destination))
    assert ("tiny/robot_0", "floor_1") in seen and world.lift.floor == "floor_1"
    assert robot.body.floor.name == "floor_1"


def test_a_door_opens_for_a_robot_nearby_and_closes_behind_it() -> None:
    world = RmfFleet(1, 1, seed=1, quiet=True)
    (robot,), door = world.robots.values(), world.doors[0]
    door.spot = robot.body.pose.x, robot.body.pose.y
    world.step(0.1)
    assert door.mode == OPEN
    door.spot = 99.0, 99.0
    world.step(10.0)
    assert door.mode == CLOSED
