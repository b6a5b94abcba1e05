"""Topics of robots that navigate: one map or one for each floor, and what is said only at times."""

from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.navigating.fleet import body_topics, plan_topic
from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.senses.camera import NAME
from tests.support.navigating import robot


def test_one_floor_has_one_map_and_several_have_each_theirs_and_robots_say_where_they_are() -> None:
    one = [topic.name for topic in MoveBaseFleet(2, 1).topics(1.0, ROS1)]
    assert one[:2] == ["/map", "/map_metadata"] and "/robot_0/floor" not in one
    fleet = Nav2Fleet(2, 2)
    several = list(fleet.topics(1.0, ROS2))[:4]
    names = ["/floor_0/map", "/floor_1/map", "/robot_0/floor", "/robot_1/floor"]
    assert [one.name for one in several] == names and all(one.latched for one in several)
    assert several[2].type == "std_msgs/msg/String"
    assert several[2].payload(0.0).msg == {"data": fleet.robots["robot_0"].floor.name}
    assert several[0].payload(0.0) is several[0].payload(9.0), "it is encoded once"


def test_odometry_ends_with_the_wheels_and_a_plan_with_the_way() -> None:
    it = robot()
    wheels, laser, camera, battery = body_topics(it, ROS1)
    plan = plan_topic(it, ROS1, "plan")
    assert (wheels.name, battery.name, plan.name) == (
        "/robot_0/odom",
        "/robot_0/battery_state",
        "/robot_0/plan",
    )
    assert wheels.due is not None and plan.due is not None and wheels.fast and battery.due is None
    assert laser.name == "/robot_0/scan" and laser.fast
    assert camera.name == f"/robot_0/{NAME}" and not camera.fast
    assert wheels.due() and not plan.due()
    it.odometry, it.way = False, [(1.0, 2.0)]
    assert not wheels.due() and plan.due()
    assert wheels.payload(5.0).msg["header"]["frame_id"] == "robot_0/odom"
