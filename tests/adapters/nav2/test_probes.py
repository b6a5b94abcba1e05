"""Probes of robots with Nav2: its servers, its lifecycle, its bridge."""

import pytest

from fleet_tui.adapters.nav2.probes import SERVERS, judge_bridge, judge_lifecycle
from fleet_tui.adapters.probes import ActionProbe, LifecycleProbe, ServiceProbe
from fleet_tui.model.navigation import DOWN, Servers
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


ALL = dict.fromkeys(SERVERS, "active")


@pytest.mark.parametrize(
    ("answer", "states", "servers"),
    [
        ({"success": True}, {}, Servers(True)),
        ({"success": False}, {}, Servers(False)),
        ({"success": False}, dict.fromkeys(SERVERS, "inactive"), Servers(False)),
        ({"success": False}, {"controller_server": DOWN}, Servers(False, "controller_server", DOWN)),
        (
            {"success": False},
            {"controller_server": "unconfigured", "planner_server": DOWN},
            Servers(False, "planner_server", DOWN),
        ),
        (
            "no reply within 2 s",
            {"controller_server": "active", "planner_server": "activating", "bt_navigator": "inactive"},
            Servers(False, "planner_server", "activating"),
        ),
        ("no reply within 2 s", ALL, Servers(True)),
        (None, {}, Servers(False)),
        ({"success": 1}, {}, Servers(False)),
    ],
)
def test_servers_by_the_word_of_their_manager_and_their_own(
    answer: object, states: dict[str, str], servers: Servers
) -> None:
    assert judge_lifecycle(answer, states) == servers


def test_only_what_the_site_has_is_looked_at() -> None:
    probes = list(adapter().probes("tb2"))
    servers = [one.action for one in probes if isinstance(one, ActionProbe)]
    assert servers == ["/tb2/navigate_to_pose", "/tb2/follow_waypoints"]
    (lifecycle,) = [one for one in probes if isinstance(one, LifecycleProbe)]
    assert lifecycle.nodes["bt_navigator"] == "/tb2/bt_navigator/get_state"
    without = list(adapter(actions={"follow_waypoints": ""}, services={"is_active": ""}).probes("tb2"))
    assert [one.action for one in without if isinstance(one, ActionProbe)] == ["/tb2/navigate_to_pose"]
    assert not [one for one in without if isinstance(one, LifecycleProbe)]


def test_the_route_server_is_looked_at_where_it_is_named() -> None:
    def of_graphs(**services: str) -> list[ServiceProbe]:
        probes = adapter(services=services).probes("tb2")
        return [one for one in probes if isinstance(one, ServiceProbe) and one.keys == ("graph_load",)]

    (probe,) = of_graphs()
    assert probe.service == "/tb2/route_server/set_route_graph"
    assert (probe.type, probe.lost) == ("nav2_msgs/SetRouteGraph", "sending of graphs")
    assert of_graphs(graph_load="") == []
