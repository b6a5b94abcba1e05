"""The activity of a simulated robot, in one word."""

from msgspec.structs import replace

from fleet_tui.model.commands import PauseRobot
from fleet_tui.model.fleet import FleetState, with_robot
from fleet_tui.model.history.facts import Activity
from fleet_tui.situation.activity import activities, activity
from tests.support.fleets import R0
from tests.support.planted_fleet import Planted
from tests.support.situations import behind_another, driving


def does(planted: Planted) -> Activity:
    return activity(planted.state, planted.robot)


def test_without_orders_it_is_idle() -> None:
    planted = Planted().run(5)
    planted.world.robots[R0].pose = planted.world.robots[R0].pose
    assert does(planted) in (Activity.IDLE, Activity.CHARGING)


def test_with_an_order_it_drives() -> None:
    assert does(driving()) is Activity.DRIVING


def test_a_pause_counts_more_than_its_order() -> None:
    assert does(driving().command(PauseRobot(R0)).run(5)) is Activity.PAUSED


def test_contact_with_an_obstacle_blocks_it() -> None:
    assert does(driving("obstacle:robot_0").run(15)) is Activity.BLOCKED


def test_stuck_is_blocked_once_it_is_an_alarm() -> None:
    planted = driving(then="stuck:robot_0").run(10)
    assert does(planted) is Activity.WAITING
    assert does(planted.run(60)) is Activity.BLOCKED


def test_behind_another_robot_it_waits() -> None:
    assert does(behind_another().run(10)) is Activity.WAITING


def test_at_a_stop_of_its_order_it_loads() -> None:
    planted = driving()
    assert planted.run(200, lambda: does(planted) is Activity.LOADING)
    assert does(planted) is Activity.LOADING


def test_silence_is_offline() -> None:
    planted = driving()
    planted.deaf = True
    assert does(planted.run(10)) is Activity.OFFLINE


def test_the_activities_of_all_are_those_of_each() -> None:
    for planted in (driving(), driving(then="stuck:robot_0").run(70), behind_another().run(10)):
        state = planted.state
        assert activities(state, state.robots.values()) == {
            robot.name: activity(state, robot) for robot in state.robots.values()
        }


def told(state: FleetState) -> dict[str, Activity]:
    return activities(state, state.robots.values())


def test_nothing_is_told_of_a_robot_whose_pose_is_old_while_others_arrive() -> None:
    planted = driving()
    robot = planted.robot
    assert robot.pose is not None
    late = replace(robot, pose=replace(robot.pose, at=planted.state.now - 60.0))
    assert R0 not in told(with_robot(planted.state, late))
    silent = replace(late, last_received=planted.state.now - 60.0)
    assert told(with_robot(planted.state, silent))[R0] is Activity.OFFLINE
