"""What is said of each robot's services. Pure, and none of them is called."""

from collections.abc import Iterator, Sequence

from fleet_tui.adapters.ros.type_names import same_type
from fleet_tui.config.profile import SERVICES, Profile
from fleet_tui.headless.doctor.causes import Cause
from fleet_tui.headless.doctor.facts import BridgeFacts, Rosapi
from fleet_tui.headless.doctor.finding import Finding, Verdict
from fleet_tui.headless.doctor.names import near_service
from fleet_tui.headless.doctor.topics import is_there


def service_findings(
    profile: Profile, robot: str, facts: BridgeFacts, causes: Sequence[Cause]
) -> Iterator[Finding]:
    """One finding for each service, one for all where they can't be looked up."""
    if facts.rosapi.problem:
        yield Finding(robot, "services", Verdict.SKIPPED, "without rosapi only a command would show them")
    elif not is_there(robot, facts):
        yield Finding(robot, "services", Verdict.SKIPPED, "not on this bridge: see above")
    else:
        for key in SERVICES:
            service = profile.service(key, robot)
            cause = next((cause for cause in causes if service in cause.services), None)
            if cause is None:
                yield _service(profile, key, robot, facts.rosapi)
            else:
                values = {"service": service, "node": facts.rosapi.owners.get(service)}
                folded = f"{cause.short}: see above"
                yield Finding(robot, f"service {key}", Verdict.SKIPPED, folded, values=values)


def _service(profile: Profile, key: str, robot: str, rosapi: Rosapi) -> Finding:
    service, expected = profile.service(key, robot), profile.service_type(key)
    there, node = rosapi.services.get(service), rosapi.owners.get(service)
    values = {"service": service, "type": there or None, "expected_type": expected, "node": node or None}

    def finding(verdict: Verdict, measured: str, remedy: str = "", out_of_time: bool = False) -> Finding:
        return Finding(robot, f"service {key}", verdict, measured, remedy, values, out_of_time)

    if service not in rosapi.services:
        free = rosapi.services.keys() - {profile.service(other, robot) for other in SERVICES}
        start = "start the node that offers it, or correct [profile.services] " + key
        remedy = near_service(robot, key, service, free) or start
        return finding(Verdict.FAIL, f"{service} is not on the bridge", remedy)
    if there is None:
        return finding(Verdict.SKIPPED, "no time was left to ask for its type", "a longer --timeout", True)
    by = f", by {node}" if node else ""
    if there and not same_type(there, expected):
        return finding(
            Verdict.FAIL,
            f"{service}{by} has type {there}, not {expected}",
            f'if its fields are the same: [profile.service_types] {key} = "{there}"; else correct'
            f" [profile.services] {key}",
        )
    return finding(Verdict.OK, f"{service}, {there or 'its type was not told'}{by}")
