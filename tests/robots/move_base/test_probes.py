"""Probes of a robot with move_base."""

from fleet_tui.robots.move_base.probes import judge_bridge
from fleet_tui.robots.probes import BridgeProbe, MessageProbe
from tests.support.move_base_adapter import adapter


def test_a_bridge_of_ros_2_is_the_wrong_one() -> None:
    (probe,) = [one for one in adapter().probes("r1") if isinstance(one, BridgeProbe)]
    assert probe.judge(2, "jazzy").level == "fail" and "ROS 2" in probe.judge(2, "jazzy").measured
    assert probe.judge(1, "noetic").level == "ok"
    assert judge_bridge(1, "").measured == "not reported by the bridge"


def test_its_localisation_and_its_battery_are_looked_at_where_it_has_them() -> None:
    def received(**topics: str) -> list[str]:
        return [one.key for one in adapter(topics=topics).probes("r1") if isinstance(one, MessageProbe)]

    assert received() == ["pose", "tf", "battery"]
    assert received(battery="", tf="") == ["pose"]
