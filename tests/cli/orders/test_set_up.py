"""`fleet-tui set-pose`, `goto`, `settle`, `mapping`: what reaches the robot, what is said, the exit code."""

from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from fleet_tui.simulator.kinds import play
from tests.support.cli import audited, run
from tests.support.nav2_site import Site, nav2_site

SET = ("set-pose", "robot_0", "1", "-2", "90")


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[Site]:
    async with nav2_site(tmp_path) as running:
        (tmp_path / "config.toml").write_text(
            f"""
            [rosbridge]
            url = "{running.server.url}"
            [profile]
            kind = "nav2"
            [[floors]]
            name = "floor_0"
            graph = "{running.config.floors[0].graph}"
            [[robots]]
            name = "robot_0"
            """
        )
        yield running


async def test_a_mislocalised_robot_is_put_right(site: Site, tmp_path: Path) -> None:
    robot = site.navigation().robot
    play(site.server, [("mislocalised", "robot_0")])
    assert robot.belief.misplaced is not None
    at = robot.pose
    typed = (f"{at.x + 0.1:.2f}", f"{at.y:.2f}", f"{at.yaw * 57.29578:.1f}")
    done = await run(tmp_path, "set-pose", "robot_0", *typed, "--yes")
    while "is driving" in done.err:  # a console that saw the pose before the fault, too, saw it move
        done = await run(tmp_path, "set-pose", "robot_0", *typed, "--yes")
    assert done.code == 0 and "confirmed (reported within 0.1" in done.out
    assert robot.belief.misplaced is None
    assert "robot_0 set pose confirmed" in audited(tmp_path)


async def test_a_pose_is_not_sent_without_a_yes(site: Site, tmp_path: Path) -> None:
    done = await run(tmp_path, *SET)
    assert done.code == 1 and "from its present pose: use --yes to send anyway" in done.err
    assert site.navigation().robot.belief.misplaced is None


async def test_a_driving_robot_is_paused_first(site: Site, tmp_path: Path) -> None:
    site.server.speed = 1.0
    site.navigation().give(30.0, 0.0)
    done = await run(tmp_path, *SET, "--yes")
    assert done.code == 1 and done.err.endswith("pause it first)\n")


async def test_a_goal_is_an_order_on_free_ground(site: Site, tmp_path: Path) -> None:
    blocked = await run(tmp_path, "goto", "robot_0", "-1.4", "-2.4")
    assert blocked.code == 1 and "is occupied on the map" in blocked.err
    done = await run(tmp_path, "goto", "robot_0", "8", "0", "-90")
    assert done.code == 0 and "robot_0 go to (8.0, 0.0): confirmed" in done.out


async def test_what_does_not_exist_is_refused(site: Site, tmp_path: Path) -> None:
    done = await run(tmp_path, "mapping", "robot_0", "on", "--yes")
    assert done.code == 0 and "accepted, but no topic shows it" in done.out
    del site.server.bridge.services.offered["/robot_0/request_nomotion_update"]
    done = await run(tmp_path, "settle", "robot_0")
    assert done.code == 1 and "request_nomotion_update does not exist" in done.err
    assert (await run(tmp_path, "set-pose", "robot_0", "1", "x", "0", "--yes")).code == 2


async def test_an_empty_key_is_named(tmp_path: Path) -> None:
    (tmp_path / "config.toml").write_text(
        '[rosbridge]\nurl = "ws://127.0.0.1:1"\n[[floors]]\nname = "hall"\n[[robots]]\nname = "robot_0"\n'
    )
    done = await run(tmp_path, *SET, "--yes")
    assert done.code == 3  # it is named by the kind, before and with a link


async def test_a_map_is_saved_on_the_robot_after_a_yes(site: Site, tmp_path: Path) -> None:
    asked = await run(tmp_path, "store-map", "robot_0", "hall")
    assert asked.code == 1 and "one of that name on the robot is replaced" in asked.err
    done = await run(tmp_path, "store-map", "robot_0", "hall", "--yes")
    assert done.code == 0 and "robot_0 store map hall: accepted, but no topic shows it" in done.out
    ((service, args),) = [one for one in site.server.bridge.services.calls if "save" in one[0]]
    assert (service, args["map_url"]) == ("/robot_0/map_saver/save_map", "hall")
    assert "robot_0 store map hall accepted" in audited(tmp_path)
    bad = await run(tmp_path, "store-map", "robot_0", "$(reboot)", "--yes")
    assert bad.code == 2 and "letters, digits" in bad.err
    site.server.bridge.services.answers[service] = lambda _: {"result": False}
    failed = await run(tmp_path, "store-map", "robot_0", "hall", "--yes")
    assert failed.code == 1 and "refused (result False)" in failed.err
