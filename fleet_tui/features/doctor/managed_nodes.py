"""Findings about the servers that drive robots: whether they are active, and what they wait for. Pure."""

from collections.abc import Iterator

from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict
from fleet_tui.model.link import SERVICES_GLOB
from fleet_tui.robots.probes import LifecycleProbe, lifecycle_label
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.situation.facts import INACTIVE
from fleet_tui.situation.navigation import inactive_cause

PLACES = frozenset({"pose", "tf"})


def lifecycle_finding(robot: str, probe: LifecycleProbe, facts: BridgeFacts) -> Finding:
    """Judge whether the servers of a robot are active; of those that are not, with the cause."""
    rosapi, values = facts.rosapi, {"service": probe.service}

    def finding(verdict: Verdict, measured: str, remedy: str = "", out_of_time: bool = False) -> Finding:
        return Finding(robot, probe.check, verdict, measured, remedy, values, out_of_time)

    if probe.service in facts.barred:
        return finding(Verdict.SKIPPED, f"not in {SERVICES_GLOB}: see above")
    if probe.service not in facts.answers:
        if rosapi.problem:
            return finding(Verdict.SKIPPED, "not checked without rosapi")
        if probe.service not in rosapi.services:
            return finding(Verdict.WARN, f"{probe.service} is not on the bridge", probe.remedy)
        there = rosapi.services[probe.service]
        if there is None or same_type(there, probe.type):
            return finding(Verdict.SKIPPED, "not checked: out of time", "use a longer --timeout", True)
        other = f"{probe.service} has type {there or 'unknown'}, not {probe.type}: not called"
        return finding(Verdict.WARN, other, probe.remedy)
    answer = facts.answers[probe.service]
    if probe.is_active(answer):
        return finding(Verdict.OK, "Nav2 is active")
    states = probe.unlisted(rosapi.services) or {
        node: lifecycle_label(facts.answers[service])
        for node, service in probe.nodes.items()
        if service in facts.answers
    }
    if not states and isinstance(answer, str):
        mute = f"no status from the lifecycle manager: {answer}"
        return finding(Verdict.FAIL, mute, "check that node, or restart it")
    servers = probe.judge(answer, states)
    if servers.is_active:
        mute = "its lifecycle manager does not answer, its nodes are active"
        return finding(Verdict.FAIL, mute, "restart the lifecycle manager")
    received = {one.wanted.key for one in facts.of(robot) if one.count}
    is_counted = "odometry" in received or not facts.adapters[robot].kind.odometry_topic
    cause, remedy = inactive_cause(servers, is_counted, bool(received & PLACES))
    return finding(Verdict.FAIL, f"{INACTIVE.word}: {cause}", remedy)


def active_findings(robot: str, probe: LifecycleProbe, facts: BridgeFacts) -> Iterator[Finding]:
    """Return the finding, unless it is a cause, which is listed before all else."""
    found = lifecycle_finding(robot, probe, facts)
    if found.verdict is not Verdict.FAIL:
        yield found


def inactive_findings(facts: BridgeFacts) -> Iterator[Finding]:
    """Return the findings of all robots whose servers are not active."""
    for robot, adapter in facts.adapters.items():
        for probe in adapter.probes(robot) if facts.of(robot) and facts.knows(robot) else ():
            if isinstance(probe, LifecycleProbe):
                found = lifecycle_finding(robot, probe, facts)
                if found.verdict is Verdict.FAIL:
                    yield found
