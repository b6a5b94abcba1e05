"""Probes of each kind: asked only of robots that are there, and each answer gets its verdict."""

from dataclasses import replace
from typing import Any

import pytest

from fleet_tui.features.doctor.managed_nodes import inactive_findings
from fleet_tui.features.doctor.probing import bridge_probes, probe_findings
from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict
from fleet_tui.model.navigation import Servers
from fleet_tui.robots.probes import ActionProbe, BridgeProbe, Diagnosis, LifecycleProbe, MessageProbe, Probe
from tests.support.bridge_facts import mute, well, with_rosapi, with_topics
from tests.support.fleets import R0, T0, battery
from tests.support.watched_store import config_of

ACTION = ActionProbe("navigation", "/robot_0/go", "start Nav2")
QUERY = LifecycleProbe(
    "life",
    "/robot_0/is_active",
    "std_srvs/Trigger",
    {"controller": "/robot_0/controller/get_state"},
    "lifecycle_msgs/GetState",
    frozenset({"controller"}),
    lambda answer, states: Servers(answer == {"success": True}, *next(iter(states.items()), ("", ""))),
    "name it",
)
HEARD = MessageProbe(
    "charge", "battery", lambda count, event: Diagnosis("warn", f"{count} {event is not None}")
)
BRIDGE = BridgeProbe("bridge", lambda ros, distro: Diagnosis("ok", f"{ros} {distro}"))


class Probed:
    """An adapter, but for its probes."""

    def __init__(self, adapter: object, *probes: Probe) -> None:
        self._adapter, self._probes = adapter, probes

    def probes(self, _robot: str) -> tuple[Probe, ...]:
        return self._probes

    def __getattr__(self, name: str) -> Any:
        return getattr(self._adapter, name)


def probed(*probes: Probe, robots: int = 1, **rosapi: Any) -> BridgeFacts:
    facts = with_rosapi(well(config_of("ws://site:9090", robots)), **rosapi)
    adapters: Any = {name: Probed(adapter, *probes) for name, adapter in facts.adapters.items()}
    return replace(facts, adapters=adapters)


def judged(facts: BridgeFacts) -> Finding:
    (found,) = probe_findings(R0, facts)
    return found


@pytest.mark.parametrize(
    ("actions", "verdict", "words"),
    [
        (("/robot_0/go",), Verdict.OK, "/robot_0/go available"),
        (("/robot_0/goo",), Verdict.FAIL, "did you mean /robot_0/goo? Otherwise start Nav2"),
        (("/dock",), Verdict.FAIL, "start Nav2"),
        ((), Verdict.SKIPPED, "unknown without a list"),
    ],
)
def test_an_action_server(actions: tuple[str, ...], verdict: Verdict, words: str) -> None:
    found = judged(probed(ACTION, actions=actions))
    assert found.verdict is verdict and words in f"{found.measured} {found.remedy}"


@pytest.mark.parametrize(
    ("services", "verdict", "words"),
    [
        ({}, Verdict.WARN, "is not on the bridge"),
        ({QUERY.service: "x/Y"}, Verdict.WARN, "has type x/Y, not std_srvs/Trigger: not called"),
        ({QUERY.service: None}, Verdict.SKIPPED, "out of time"),
    ],
)
def test_a_service_that_was_not_called(services: dict[str, str | None], verdict: Verdict, words: str) -> None:
    found = judged(probed(QUERY, services=services))
    assert found.verdict is verdict and words in found.measured
    assert found.out_of_time is ("out of time" in words)


def test_servers_that_are_active_are_told_with_the_other_checks() -> None:
    found = judged(replace(probed(QUERY), answers={QUERY.service: {"success": True}}))
    assert (found.verdict, found.measured) == (Verdict.OK, "Nav2 is active")
    assert judged(probed(QUERY, problem="gone")).verdict is Verdict.SKIPPED


def test_servers_that_are_not_active_are_a_cause_before_all_else() -> None:
    facts = replace(probed(QUERY), answers={QUERY.service: {"success": False}})
    assert list(probe_findings(R0, facts)) == []
    (found,) = inactive_findings(facts)
    assert (found.verdict, found.measured) == (Verdict.FAIL, "Nav2 inactive: controller down")
    assert found.remedy == "Start controller again, then all of Nav2: see its log"


def test_messages_are_judged_while_the_robot_is_heard_and_they_can_be_read() -> None:
    facts = with_topics(probed(HEARD), ("/battery",), event=battery(T0))
    assert judged(facts).measured == "50 True"
    assert judged(mute(facts, "/battery")).measured == "0 True"
    assert list(probe_findings(R0, with_topics(facts, ("/battery",), faults=1, event=None))) == []
    assert list(probe_findings(R0, mute(facts, ""))) == []


def test_a_bridge_is_judged_once_for_all_its_robots_of_a_kind() -> None:
    (found,) = bridge_probes(probed(BRIDGE, robots=3, distro="noetic"))
    assert (found.subject, found.measured) == ("rosbridge", "1 noetic")
    assert list(bridge_probes(probed(BRIDGE, problem="gone"))) == []
    assert list(probe_findings(R0, probed(BRIDGE))) == []
