"""Topics on change: each place once, the newest for late subscribers, and what waits while unheard."""

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.ros.dialect import ROS1

PLACE = "/robot_0/amcl_pose"


def made() -> Nav2Fleet:
    return Nav2Fleet(1, 1, seed=1, quiet=True)


def taken(fleet: Nav2Fleet) -> list[tuple[str, Payload]]:
    return list(fleet.news(ROS1))


def test_a_place_is_told_at_first_and_then_on_change() -> None:
    fleet = made()
    assert [name for name, _ in taken(fleet)] == [PLACE] and taken(fleet) == []
    robot = fleet.robots["robot_0"]
    robot.pose = Pose(robot.pose.x + 5.0, robot.pose.y)
    ((_, payload),) = taken(fleet)
    assert payload.msg["pose"]["pose"]["position"]["x"] == robot.pose.x
    assert payload.msg["header"]["seq"] == 2


def test_a_late_subscriber_gets_the_newest_unless_the_robot_is_silent_or_its_node_gone() -> None:
    fleet = made()
    topic, gone = (
        fleet.topic_on_change("robot_0", "amcl_pose", "", ROS1),
        fleet.topic_on_change("robot_0", "amcl_pose", "", ROS1, alive=lambda: False),
    )
    assert topic.history is not None and gone.history is not None and topic.latched
    assert list(topic.history()) == []
    ((_, payload),) = taken(fleet)
    assert list(topic.history()) == [payload] and list(gone.history()) == []
    fleet.robots["robot_0"].silence = 1.0
    assert list(topic.history()) == []


def test_of_a_robot_that_is_not_heard_the_newest_waits() -> None:
    fleet = made()
    robot = fleet.robots["robot_0"]
    taken(fleet)
    robot.silence = 9.0
    for x in (5.0, 10.0):
        robot.pose = Pose(x, robot.pose.y)
        assert taken(fleet) == []
    robot.silence = 0.0
    ((_, payload),) = taken(fleet)
    assert payload.msg["pose"]["pose"]["position"]["x"] == 10.0 and taken(fleet) == []
