"""Findings about robots that a fleet adapter reports on: it goes on when one of them is lost. Pure."""

from collections.abc import Iterator

from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict
from fleet_tui.model.fleets.events import MemberReported, StatusReported, TaskReported
from fleet_tui.text.units import age, counted


def member_findings(robot: str, facts: BridgeFacts, offline_after: float) -> Iterator[Finding]:
    """Judge the age of a robot's location by the clock of its driver, and the issues of its adapter."""
    for one in facts.of(robot):
        event = one.events.get(robot)
        if isinstance(event, MemberReported):
            yield _location(robot, event, one.lags.get(robot), one.lag, offline_after)
        elif isinstance(event, StatusReported) and event.issues:
            remedy = "see the log of its fleet adapter"
            yield Finding(robot, "issues", Verdict.WARN, "; ".join(event.issues[:3]), remedy)
        elif isinstance(event, TaskReported):
            state = event.task.state.value if event.task.state else event.task.word
            told = f"{counted(one.count, 'message')} of tasks, the last of {event.task.id}: {state}"
            yield Finding(robot, "task", Verdict.OK, told)


def _location(
    robot: str, event: MemberReported, lag: float | None, least: float | None, offline_after: float
) -> Finding:
    if event.stamp is None or lag is None or least is None:
        measured = "its driver gives no time: the age of its location is unknown"
        return Finding(robot, "location", Verdict.WARN, measured, "set location.t in its fleet adapter")
    # The robot with the newest stamp has the clock of all.
    old = lag - least
    if old > offline_after:
        measured = f"{age(old)} old, while its fleet adapter goes on"
        return Finding(
            robot, "location", Verdict.FAIL, measured, "check the robot and the driver of its fleet"
        )
    return Finding(robot, "location", Verdict.OK, f"{age(old)} old, on {event.floor}")
