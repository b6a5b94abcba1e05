"""Findings about the other end of set-up: whoever listens on its topics and offers its services. Pure.

A robot can drive without them, so none of them is a failure.
"""

from fleet_tui.features.doctor.names import near_service
from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict, listed, nearest
from fleet_tui.links.rosbridge.set_up.listeners import BRIDGE
from fleet_tui.robots.probes import ListenerProbe, ServiceProbe
from fleet_tui.robots.ros.type_names import same_type

NOT_CHECKED = "not checked: out of time"
LONGER = "use a longer --timeout"


def listener_finding(robot: str, probe: ListenerProbe, facts: BridgeFacts) -> Finding:
    """Judge a topic on which consoles publish: without a listener a message is lost without a word."""
    rosapi, table = facts.rosapi, facts.table(robot)
    nodes, there = rosapi.subscribers.get(probe.topic), rosapi.topics.get(probe.topic, "")
    values = {"topic": probe.topic, "type": there or None, "expected_type": probe.type, "nodes": nodes}

    def finding(verdict: Verdict, measured: str, remedy: str = "", late: bool = False) -> Finding:
        return Finding(robot, probe.key, verdict, measured, remedy, values, late)

    fits = any(same_type(there, one) for one in (probe.type, probe.or_type) if one)
    if there and not fits:
        other = f"{probe.topic} has type {there}, not {probe.type}: no {probe.lost}"
        return finding(Verdict.WARN, other, f"correct [{table}.topics] {probe.key}, or [{table}.types]")
    if nodes is None:
        return finding(Verdict.SKIPPED, NOT_CHECKED, LONGER, late=True)
    # A bridge listens for its own clients.
    ears = [node for node in nodes if BRIDGE not in node]
    if ears:
        return finding(Verdict.OK, f"{listed(ears)} listens on {probe.topic}, {there or probe.type}")
    fitting = [name for name, type_ in rosapi.topics.items() if same_type(type_, probe.type)]
    own = [name for name in fitting if name.startswith(f"/{robot}/") and name != probe.topic]
    near = nearest(probe.topic, own, 1)
    if not near and not facts.adapters[robot].names.is_chosen(probe.key):
        return finding(Verdict.SKIPPED, f"nobody listens on {probe.topic}: no {probe.lost}")
    meant = f"did you mean {near[0]}? Otherwise " if near else ""
    start = f'start the node that listens, or set [{table}.topics] {probe.key} = "" if not used'
    return finding(Verdict.WARN, f"nobody listens on {probe.topic}: no {probe.lost}", meant + start)


def service_finding(robot: str, probe: ServiceProbe, facts: BridgeFacts) -> Finding:
    """Judge a service that not every such robot has."""
    rosapi, adapter, service = facts.rosapi, facts.adapters[robot], probe.service
    table, key, there = adapter.names.table, probe.keys[0], rosapi.services.get(service)
    node = rosapi.owners.get(service)
    values = {"service": service, "type": there or None, "expected_type": probe.type, "node": node or None}

    def finding(verdict: Verdict, measured: str, remedy: str = "", late: bool = False) -> Finding:
        check = f"service {', '.join(probe.keys)}"
        return Finding(robot, check, verdict, measured, remedy, values, late)

    if service not in rosapi.services:
        off = ", ".join(f'{one} = ""' for one in probe.keys)
        start = f"start the node that offers it, or set [{table}.services] {off} if not used"
        missing = f"{service} is not on the bridge: no {probe.lost}"
        remedy = near_service(adapter, robot, key, service, probe.type, rosapi)
        if not remedy and not any(map(adapter.names.is_chosen, probe.keys)):
            return finding(Verdict.SKIPPED, missing)
        return finding(Verdict.WARN, missing, remedy or start)
    if there is None:
        return finding(Verdict.SKIPPED, NOT_CHECKED, LONGER, late=True)
    if there and not same_type(there, probe.type):
        other = f"{service} has type {there}, not {probe.type}: no {probe.lost}"
        remedy = f"name its type in [{table}.service_types] {key} and its fields in [{table}.requests.{key}]"
        return finding(Verdict.WARN, other, remedy)
    by = f", by {node}" if node else ""
    return finding(Verdict.OK, f"{service}, {there or 'type unknown'}{by}")
