"""Poses and goals by keyboard, on simulated robots with Nav2."""

import math

import pytest

from fleet_tui.model.commands import Stage
from fleet_tui.model.kind import SCAN
from fleet_tui.model.set_up.commands import SetPose
from fleet_tui.model.set_up.streams import Beams
from fleet_tui.simulator.kinds import play
from fleet_tui.ui.controllers import comparison
from tests.support.console_pilot import Console, console
from tests.support.nav2_site import Site, placed


async def test_a_mislocalised_robot_is_put_right_by_keys_alone(
    site: Site, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(comparison, "GIVEN_UP", 60.0)  # a busy machine may take long to the next scan
    robot = site.navigation().robot
    play(site.server, [("mislocalised", "robot_0")])
    async with console(site.config) as it:
        await it.until(lambda state: state.robots["robot_0"].still_for > 3)
        await it.press("I")
        await it.shows("POSE", "map")
        mode, truth = it.app.main.features.set_up.poses.mode, robot.pose
        assert mode is not None
        mode.cursor, mode.yaw = (truth.x, truth.y), truth.yaw  # as arrows do, cell by cell
        await it.press("right", "left", "h", "l", "H", "L")
        await it.shows(" % fit", "map")
        await it.press("enter")
        await it.shows(" % fit", "map")  # by a scan of this moment: that is the one before
        await it.press("y")
        await it.until(lambda state: any(isinstance(one.command, SetPose) for one in state.commands))
        found = await it.until(
            lambda state: [
                one for one in state.commands if isinstance(one.command, SetPose) and one.is_decided
            ]
        )
        assert found.commands[-1].stage is Stage.CONFIRMED
        assert robot.belief.misplaced is None
        assert it.app.main.features.set_up.poses.mode is None
        await it.shows(" % of the scan fits the map, ")
        streams = it.app.main.backend.streams
        it.app.main.tick()
        assert not streams.wants("robot_0", "scan")


def knows_its_laser(it: Console) -> bool:
    """Tell whether the newest scan is placed by the robot's frames."""
    scan = it.app.main.backend.streams.get("robot_0", SCAN)
    return scan is not None and isinstance(scan.value, Beams) and not scan.value.is_sought


async def test_a_pose_snaps_to_the_scan_and_a_goal_does_not(site: Site) -> None:
    robot = site.navigation().robot
    async with console(site.config) as it:
        await it.until(lambda state: state.robots["robot_0"].still_for > 1)
        await it.press("I")
        await it.shows(" s best fit ", "hints")
        await it.until(lambda _: knows_its_laser(it))
        mode, truth = it.app.main.features.set_up.poses.mode, robot.pose
        assert mode is not None
        mode.cursor, mode.yaw = (truth.x + 1.0, truth.y), truth.yaw + 2.0
        await it.press("s")
        await it.shows(" degrees from the cursor", "message")
        assert math.dist(mode.cursor, (truth.x, truth.y)) < 0.2
        await it.press("escape", "G")
        await it.shows("GOAL", "map")
        await it.press("s")
        await it.shows("only a pose of a robot", "message")
        assert " best fit " not in it.pane("hints")


async def test_a_goal_is_an_order_to_a_pose(site: Site) -> None:
    async with console(site.config) as it:
        await it.press("G")
        await it.shows("GOAL", "map")
        mode = it.app.main.features.set_up.poses.mode
        assert mode is not None
        mode.cursor, mode.yaw = (8.0, 0.0), math.pi / 2
        await it.press("enter")
        await it.shows("go to (8.00, 0.00) 90")
        await it.press("n")
        await it.hides("go to (8.00, 0.00) 90")
        await it.press("enter")
        await it.shows("go to (8.00, 0.00) 90")
        await it.press("y")
        await it.until(placed)


async def test_arrows_move_and_escape_leaves(site: Site) -> None:
    async with console(site.config) as it:
        await it.press("I")
        mode = it.app.main.features.set_up.poses.mode
        assert mode is not None
        before = mode.cursor
        await it.press("right", "up")
        assert mode.cursor != before
        await it.press("p", "escape")
        assert it.app.main.features.set_up.poses.mode is None


async def test_the_scan_shows_how_well_a_pose_fits(site: Site) -> None:
    play(site.server, [("mislocalised", "robot_0")])
    robot = site.navigation().robot
    async with console(site.config) as it:
        await it.until(lambda state: state.robots["robot_0"].still_for > 1)
        await it.press("w")
        await it.shows("1. not localised")
        await it.press("escape", "u")
        await it.shows("of 720 beams")
        await it.press("I")
        mode = it.app.main.features.set_up.poses.mode
        assert mode is not None
        mode.cursor, mode.yaw = (robot.pose.x, robot.pose.y), robot.pose.yaw
        await it.shows(" m, 100 % fit")
        streams = it.app.main.backend.streams
        assert streams.wants("robot_0", "scan")
        await it.press("escape", "u")
        it.app.main.tick()
        assert not streams.wants("robot_0", "scan")


async def test_streams_go_along_with_the_selected_robot(site: Site) -> None:
    async with console(site.config) as it:
        await it.press("u", "U", "]")
        it.app.main.tick()
        streams = it.app.main.backend.streams
        assert {robot for robot in ("robot_0", "robot_1") if streams.wants(robot, "scan")} == {"robot_1"}
        assert streams.wants("robot_1", "path")


async def test_a_robot_that_drives_is_told_to_be_paused_before_its_pose_is_chosen(site: Site) -> None:
    async with console(site.config) as it:
        await it.press("G")
        await it.shows("GOAL", "map")
        await it.press(*["L"] * 6, "enter", "y")
        await it.until(lambda state: state.robots["robot_0"].orders.current is not None)
        await it.press("I")
        await it.shows("pause it first")
