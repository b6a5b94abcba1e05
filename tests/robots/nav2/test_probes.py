"""Probes of robots with Nav2: its servers, its lifecycle, its bridge."""

import json

import pytest

from fleet_tui.config.fleet import adapters_of
from fleet_tui.model.navigation import DOWN, MUTE, Servers
from fleet_tui.model.ros_logs import Health, PartDiagnosis
from fleet_tui.robots.nav2.probes import SERVERS, judge_bridge, judge_lifecycle
from fleet_tui.robots.probes import ActionProbe, LifecycleProbe, ServiceProbe
from fleet_tui.robots.ros.logs import diagnoses
from tests.support.fleets import R0, recording
from tests.support.nav2_adapter import adapter
from tests.support.nav2_recordings import recorded_config


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


@pytest.mark.parametrize(
    ("message", "level", "is_active"),
    [
        ("Nav2 is active", Health.OK, True),
        ("Nav2 is inactive", Health.ERROR, False),
        ("Managed nodes are active", Health.OK, True),
        ("Managed nodes are active", Health.STALE, False),
        ("Managed nodes are inactive", Health.OK, False),
        ("Managed nodes are unconfigured", Health.OK, False),
        ("Managed nodes have been shut down", Health.WARN, False),
        ("An error has occurred during a node state transition", Health.ERROR, False),
        ("", Health.OK, False),
    ],
)
def test_servers_by_what_their_manager_publishes(message: str, level: Health, is_active: bool) -> None:
    diagnosis = PartDiagnosis(0.0, "lifecycle_manager_navigation: Nav2 Health", level, message)
    assert judge_lifecycle(diagnosis, {}) == Servers(is_active)


def lifecycle_of(robot: str) -> LifecycleProbe:
    (found,) = [one for one in adapter().probes(robot) if isinstance(one, LifecycleProbe)]
    return found


def test_a_manager_is_known_by_its_full_name_and_by_its_own_only_where_it_has_no_namesake() -> None:
    health = {
        name: PartDiagnosis(0.0, name, Health.OK, "Managed nodes are active")
        for name in (
            "lifecycle_manager_navigation: Nav2 Health",
            "lifecycle_manager_localization: Nav2 Health",
            "/tb2/lifecycle_manager_navigation: Nav2 Health",
        )
    }
    first, second = lifecycle_of("tb2"), lifecycle_of("tb3")
    unnamed, _, named = health.values()
    assert first.diagnosis(health, [first.service, second.service]) is named
    assert second.diagnosis(health, [first.service, second.service]) is None
    assert second.diagnosis(health, [second.service]) is unnamed
    assert second.diagnosis(health, []) is unnamed
    assert second.diagnosis({}, [second.service]) is None


def test_a_recorded_manager_that_waits_for_a_dead_node_calls_itself_active() -> None:
    (probe,) = [
        one for one in adapters_of(recorded_config())[R0].probes(R0) if isinstance(one, LifecycleProbe)
    ]
    frames = [json.loads(line["text"]) for line in recording("nav2-diagnostics-inactive.jsonl.gz")]
    health = {
        part.name: part
        for frame in frames
        if frame["op"] == "publish"
        for part in diagnoses(frame["msg"], 0.0)
    }
    diagnosis = probe.diagnosis(health, [probe.service])
    assert probe.judge(diagnosis, {}) == Servers(True)
    assert probe.judge(MUTE, {"controller_server": DOWN}) == Servers(False, "controller_server", DOWN)


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
