"""`order --until-done`: it waits until the order was driven, or was not."""

from pathlib import Path

from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import asked, run


async def test_it_waits_until_it_is_driven(server: RosbridgeServer, folder: Path) -> None:
    robot = server.world.robots["robot_0"]
    robot.cargo = True

    def hurry(_dt: float) -> None:
        for _ in range(9 * bool(robot.orders)):
            robot.step()

    server.world.troubles.append(hurry)
    done = await run(folder, "order", "robot_0", "Consumidores", "--until-done")
    assert done.code == 0 and "done (order 1: driven to the end)" in done.out and not robot.orders
    assert robot.vertex == 19 and asked(server) == ["robot_0 Execute_order_with_cargo"]


async def test_a_robot_that_starts_anew_did_not_drive_it(server: RosbridgeServer, folder: Path) -> None:
    play(server, [("restart", "robot_0")])
    done = await run(folder, "order", "robot_0", "Base", "Consumidores", "--until-done")
    assert (
        done.code == 1
        and "not done (lost: order 1: the robot restarted: its order ids started over)" in done.err
    )
    assert asked(server) == ["robot_0 Execute_order"]


async def test_when_the_time_is_up_it_says_where_the_order_is(server: RosbridgeServer, folder: Path) -> None:
    words = ("order", "robot_0", "Base", "Consumidores", "--until-done", "--timeout", "2")
    done = await run(folder, *words)
    assert done.code == 1 and "not done (order 1 is in process, not done within" in done.err
