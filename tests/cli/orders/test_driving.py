"""`order --until-done`: it waits until the order was driven, or was not."""

from pathlib import Path

from fleet_tui.simulator.graph_files import write_graphs
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


async def test_an_order_that_failed_without_a_reason_has_that_of_the_log(
    nav2: RosbridgeServer, tmp_path: Path
) -> None:
    play(nav2, [("silent-aborts", "robot_0")])
    (file,) = write_graphs(tmp_path / "routes.geojson", 1)
    site = f'url = "{nav2.url}"\n[profile]\nkind = "nav2"\n[[floors]]\nname = "floor_0"\ngraph = "{file}"\n'
    (tmp_path / "config.toml").write_text(f'[rosbridge]\n{site}[[robots]]\nname = "robot_0"\n')
    failed = await run(tmp_path, "order", "robot_0", "id=8", "--until-done")
    said = "Timed out while waiting for action server to acknowledge goal request for follow_path"
    assert failed.code == 1 and f"not done (failed: {said})" in failed.err
