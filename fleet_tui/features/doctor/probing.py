"""Findings from the probes of each robot's kind. Pure."""

from collections.abc import Iterator
from typing import assert_never

from fleet_tui.features.doctor.managed_nodes import active_findings
from fleet_tui.features.doctor.set_up import listener_finding, service_finding
from fleet_tui.links.discovery.facts import LONG_ENOUGH, BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict, nearest
from fleet_tui.robots.probes import (
    ActionProbe,
    BridgeProbe,
    Diagnosis,
    LifecycleProbe,
    ListenerProbe,
    MessageProbe,
    ServiceProbe,
)

VERDICTS = {"ok": Verdict.OK, "warn": Verdict.WARN, "fail": Verdict.FAIL}


def bridge_probes(facts: BridgeFacts) -> Iterator[Finding]:
    """Judge the bridge once for each kind behind it that has a check for it."""
    if facts.rosapi.problem:
        return
    probes = [probe for robot, adapter in facts.adapters.items() for probe in adapter.probes(robot)]
    for probe in dict.fromkeys(probe for probe in probes if isinstance(probe, BridgeProbe)):
        yield _judged(facts.name, probe.check, probe.judge(facts.rosapi.ros, facts.rosapi.distro))


def probe_findings(robot: str, facts: BridgeFacts) -> Iterator[Finding]:
    """Judge the probes of a robot that is online."""
    if not facts.knows(robot):
        return
    for probe in facts.adapters[robot].probes(robot):
        match probe:
            case ActionProbe():
                yield _action(robot, probe, facts)
            case MessageProbe():
                yield from _messages(robot, probe, facts)
            case ListenerProbe() | ServiceProbe() if facts.rosapi.problem:
                pass  # it is listed that services are unknown
            case ListenerProbe():
                yield listener_finding(robot, probe, facts)
            case ServiceProbe():
                yield service_finding(robot, probe, facts)
            case LifecycleProbe():
                yield from active_findings(robot, probe, facts)
            case BridgeProbe():
                pass
            case _:
                assert_never(probe)


def _judged(subject: str, check: str, diagnosis: Diagnosis, **values: object) -> Finding:
    return Finding(subject, check, VERDICTS[diagnosis.level], diagnosis.measured, diagnosis.remedy, values)


def _action(robot: str, probe: ActionProbe, facts: BridgeFacts) -> Finding:
    rosapi, values = facts.rosapi, {"action": probe.action}
    if rosapi.problem or not rosapi.actions:
        unknown = "unknown without a list of action servers"
        return Finding(robot, probe.check, Verdict.SKIPPED, unknown, values=values)
    if probe.action in rosapi.actions:
        return Finding(robot, probe.check, Verdict.OK, f"{probe.action} available", values=values)
    verbs = {name.rpartition("/")[2] for name in rosapi.actions}
    alike = nearest(probe.action.rpartition("/")[2], verbs, 1)
    # Of the same robot, or another namespace: nearly all of a name is that of its robot.
    near = nearest(probe.action, [name for name in rosapi.actions if name.rpartition("/")[2] in alike], 1)
    remedy = f"did you mean {near[0]}? Otherwise {probe.remedy}" if near else probe.remedy
    return Finding(robot, probe.check, Verdict.FAIL, f"no action server {probe.action}", remedy, values)


def _messages(robot: str, probe: MessageProbe, facts: BridgeFacts) -> Iterator[Finding]:
    """Judge the messages of a robot that is online; unreadable ones are listed at the topic."""
    topics = facts.of(robot)
    for one in topics if any(one.count for one in topics) else ():
        fits = one.wanted.key == probe.key and (one.count or one.waited >= LONG_ENOUGH)
        if fits and not (one.faults and one.event is None):
            event = one.events.get(robot) if one.wanted.is_shared else one.event
            diagnosis = probe.judge(one.count, event)
            if diagnosis is not None:
                yield _judged(robot, probe.check, diagnosis)
