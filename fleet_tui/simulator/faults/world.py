"""Faults of robots of the source's stack themselves, and commands of other clients."""

from typing import TYPE_CHECKING

from msgspec import structs

from fleet_tui.simulator.faults.plays import each_step, robot_of
from fleet_tui.simulator.senses.belief import DRIFT

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.robot import SimRobot
    from fleet_tui.simulator.server import RosbridgeServer

LIVES = 2.0  # seconds from the first order until `restart` restarts the node
JUMP = 3.0  # metres by which the pose of `jumping` is off every other second
FOREIGN = 3.0  # seconds after an order at which another console interferes
FOREIGN_PAUSE = 5.0  # seconds for which it pauses


def restart(server: "RosbridgeServer", robot_name: str) -> None:
    """Restart the robot's node a while after its first order."""
    robot: SimRobot = robot_of(server, robot_name)
    age = 0.0

    def step(passed: float) -> None:
        nonlocal age
        age = age + passed if robot.last_order_id else 0.0
        if age > LIVES:
            robot.drop({order.id for order in robot.orders})
            robot.last_order_id = robot.request_id = 0
            robot.paused, age = False, 0.0

    each_step(server, robot_name, step)


def foreign_cancel(server: "RosbridgeServer", robot_name: str) -> None:
    """Cancel each order as another console would: one report lists it as cancelled, the next ones do not list
    it."""
    robot: SimRobot = robot_of(server, robot_name)
    ages = dict[int, float]()

    def step(passed: float) -> None:
        nonlocal ages
        listed = [order for order in robot.ended if ages[order.id] < FOREIGN + server.report_period]
        ages = {order.id: ages.get(order.id, 0.0) + passed for order in (*listed, *robot.orders)}
        cancelled = [order for order in robot.orders if ages[order.id] >= FOREIGN]
        robot.drop({order.id for order in cancelled})
        for order in cancelled:
            order.status = "C"
        robot.ended = listed + cancelled

    each_step(server, robot_name, step)


def foreign_pause(server: "RosbridgeServer", robot_name: str) -> None:
    """Pause and resume the robot once, as another console would."""
    robot, age = robot_of(server, robot_name), 0.0

    def step(passed: float) -> None:
        nonlocal age
        before, age = age, age + (passed if robot.last_order_id else 0.0)
        if before < FOREIGN <= age:
            robot.paused = True
        elif before < FOREIGN + FOREIGN_PAUSE <= age:
            robot.paused = False

    each_step(server, robot_name, step)


def mislocalised(server: "RosbridgeServer", robot_name: str) -> None:
    """Let the robot believe to be elsewhere until its pose is set."""
    robot: SimRobot = robot_of(server, robot_name)
    robot.belief.place(robot.pose.after(DRIFT), robot.pose)


def jumping(server: "RosbridgeServer", robot_name: str) -> None:
    """Let the robot's pose jump. A robot that is not localised does not drive."""
    world, robot, beside = server.world, server.world.robots[robot_name], 0.0
    robot.stuck = True

    def step(_dt: float) -> None:
        nonlocal beside
        wanted = JUMP * (int(world.time) % 2)
        robot.pose = structs.replace(robot.pose, x=robot.pose.x + wanted - beside)
        beside = wanted

    world.troubles.append(step)
