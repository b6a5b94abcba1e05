"""Topics on change: each place once, the newest for late subscribers, and what waits while unheard."""

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.move_base.navigation import MoveBaseWorld, SimMoveBase
from fleet_tui.simulator.navigating.news import News
from fleet_tui.simulator.ros.dialect import ROS1

PLACE = "/robot_0/amcl_pose"


def made() -> tuple[MoveBaseWorld, News[SimMoveBase]]:
    world = MoveBaseWorld(1, 1, seed=1, quiet=True)
    return world, News(world)


def taken(news: News[SimMoveBase]) -> list[tuple[str, Payload]]:
    return list(news.take(ROS1))


def test_a_place_is_told_at_first_and_then_on_change() -> None:
    world, news = made()
    assert [name for name, _ in taken(news)] == [PLACE] and taken(news) == []
    robot = world.robots["robot_0"]
    robot.pose = Pose(robot.pose.x + 5.0, robot.pose.y)
    ((_, payload),) = taken(news)
    assert payload.msg["pose"]["pose"]["position"]["x"] == robot.pose.x
    assert payload.msg["header"]["seq"] == 2


def test_a_late_subscriber_gets_the_newest_unless_the_robot_is_silent_or_its_node_gone() -> None:
    world, news = made()
    topic, gone = (
        news.topic("robot_0", "amcl_pose", ""),
        news.topic("robot_0", "amcl_pose", "", alive=lambda: False),
    )
    assert topic.history is not None and gone.history is not None and topic.latched
    assert list(topic.history()) == []
    ((_, payload),) = taken(news)
    assert list(topic.history()) == [payload] and list(gone.history()) == []
    world.robots["robot_0"].silence = 1.0
    assert list(topic.history()) == []


def test_of_a_robot_that_is_not_heard_the_newest_waits() -> None:
    world, news = made()
    robot = world.robots["robot_0"]
    taken(news)
    robot.silence = 9.0
    for x in (5.0, 10.0):
        robot.pose = Pose(x, robot.pose.y)
        assert taken(news) == []
    robot.silence = 0.0
    ((_, payload),) = taken(news)
    assert payload.msg["pose"]["pose"]["position"]["x"] == 10.0 and taken(news) == []
