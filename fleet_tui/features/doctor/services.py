"""Findings about each robot's services. Pure; no service is called."""

from collections.abc import Iterator, Sequence

from fleet_tui.features.doctor.causes import Cause
from fleet_tui.features.doctor.names import near_service
from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict
from fleet_tui.robots.ros.type_names import same_type


def service_findings(robot: str, facts: BridgeFacts, causes: Sequence[Cause]) -> Iterator[Finding]:
    """Return one finding for each service, one for all if they can't be looked up."""
    if facts.rosapi.problem:
        yield Finding(robot, "services", Verdict.SKIPPED, "unknown without rosapi")
    elif not facts.knows(robot):
        yield Finding(robot, "services", Verdict.SKIPPED, "not on this bridge: see above")
    else:
        called = list(facts.adapters[robot].services(robot))
        for key, service, expected in called:
            cause = next((cause for cause in causes if service in cause.services), None)
            if cause is None:
                yield _service(robot, key, service, expected, facts)
            else:
                values = {"service": service, "node": facts.rosapi.owners.get(service)}
                folded = f"{cause.short}: see above"
                yield Finding(robot, f"service {key}", Verdict.SKIPPED, folded, values=values)


def _service(robot: str, key: str, service: str, expected: str, facts: BridgeFacts) -> Finding:
    rosapi, adapter = facts.rosapi, facts.adapters[robot]
    table = adapter.names.table
    there, node = rosapi.services.get(service), rosapi.owners.get(service)
    values = {"service": service, "type": there or None, "expected_type": expected, "node": node or None}

    def finding(verdict: Verdict, measured: str, remedy: str = "", out_of_time: bool = False) -> Finding:
        return Finding(robot, f"service {key}", verdict, measured, remedy, values, out_of_time)

    if service not in rosapi.services:
        start = f"start the node that provides it, or correct [{table}.services] {key}"
        remedy = near_service(adapter, robot, key, service, expected, rosapi) or start
        return finding(Verdict.FAIL, f"{service} is not on the bridge", remedy)
    if there is None:
        return finding(Verdict.SKIPPED, "type not checked: out of time", "use a longer --timeout", True)
    by = f", by {node}" if node else ""
    if there and not same_type(there, expected):
        return finding(
            Verdict.FAIL,
            f"{service}{by} has type {there}, not {expected}",
            f'if the fields match, set [{table}.service_types] {key} = "{there}"; else correct'
            f" [{table}.services] {key}",
        )
    return finding(Verdict.OK, f"{service}, {there or 'type unknown'}{by}")
