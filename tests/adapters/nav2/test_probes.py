"""Probes of robots with Nav2: its servers, its lifecycle, its bridge."""

import pytest

from fleet_tui.adapters.nav2.probes import judge_bridge, judge_lifecycle
from fleet_tui.adapters.probes import ActionProbe, QueryProbe, ServiceProbe
from tests.support.nav2_adapter import adapter


@pytest.mark.parametrize(
    ("ros", "distro", "level", "detail"),
    [
        (1, "noetic", "fail", "ROS 1 bridge"),
        (2, "humble", "warn", "a goal blocks its connection"),
        (2, "jazzy", "ok", "jazzy"),
        (2, "", "ok", "not reported by the bridge"),
    ],
)
def test_a_bridge_by_its_distribution(ros: int, distro: str, level: str, detail: str) -> None:
    found = judge_bridge(ros, distro)
    assert (found.level, bool(found.remedy)) == (level, level != "ok") and detail in found.measured


@pytest.mark.parametrize(
    ("answer", "level", "detail"),
    [
        ({"success": True}, "ok", "Nav2 is active"),
        ({"success": False}, "fail", "rejects every goal"),
        ("no such node", "fail", "no status from the lifecycle manager: no such node"),
        (None, "fail", "no status from the lifecycle manager"),
        ({"success": 1}, "fail", "no status from the lifecycle manager"),
    ],
)
def test_a_lifecycle_manager_by_its_answer(answer: object, level: str, detail: str) -> None:
    found = judge_lifecycle(answer)
    assert found.level == level and detail in found.measured


def test_only_what_the_site_has_is_looked_at() -> None:
    probes = list(adapter().probes("tb2"))
    servers = [one.action for one in probes if isinstance(one, ActionProbe)]
    assert servers == ["/tb2/navigate_to_pose", "/tb2/follow_waypoints"]
    without = list(adapter(actions={"follow_waypoints": ""}, services={"is_active": ""}).probes("tb2"))
    assert [one.action for one in without if isinstance(one, ActionProbe)] == ["/tb2/navigate_to_pose"]
    assert not [one for one in without if isinstance(one, QueryProbe)]


def test_the_route_server_is_looked_at_where_it_is_named() -> None:
    def of_graphs(**services: str) -> list[ServiceProbe]:
        probes = adapter(services=services).probes("tb2")
        return [one for one in probes if isinstance(one, ServiceProbe) and one.keys == ("graph_load",)]

    (probe,) = of_graphs()
    assert probe.service == "/tb2/route_server/set_route_graph"
    assert (probe.type, probe.lost) == ("nav2_msgs/SetRouteGraph", "sending of graphs")
    assert of_graphs(graph_load="") == []
