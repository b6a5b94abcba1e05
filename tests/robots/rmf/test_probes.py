"""Checks of fleets of Open-RMF."""

from fleet_tui.robots.probes import ListenerProbe
from fleet_tui.robots.rmf.probes import judge_bridge, probes
from tests.support.rmf import adapter


def test_open_rmf_needs_ros_2() -> None:
    assert judge_bridge(1, "noetic").level == "fail"
    assert (judge_bridge(2, "jazzy").level, judge_bridge(2, "jazzy").measured) == ("ok", "jazzy")


def test_a_node_must_take_requests_if_there_is_a_topic_for_them() -> None:
    listeners = [one for one in probes(adapter().names) if isinstance(one, ListenerProbe)]
    assert [one.topic for one in listeners] == ["/task_api_requests"]
    without = probes(adapter(topics={"requests": ""}).names)
    assert not [one for one in without if isinstance(one, ListenerProbe)]
