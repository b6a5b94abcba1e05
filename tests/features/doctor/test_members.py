"""Robots of fleets: their own age, whatever their adapter sends."""

from fleet_tui.features.doctor.run import member_findings
from fleet_tui.links.discovery.facts import BridgeFacts, RosapiFacts, TopicFacts
from fleet_tui.links.discovery.finding import Verdict
from fleet_tui.model.events import Event
from fleet_tui.model.fleets.events import MemberReported, StatusReported
from fleet_tui.model.geometry import Pose
from tests.support.rmf import TINY, adapter, feed, reported


def found(key: str, event: Event, lag: float | None = None, least: float | None = None) -> list[str]:
    lags = {} if lag is None else {TINY: lag}
    topic = TopicFacts(feed(adapter(), key), count=3, events={TINY: event}, lags=lags, lag=least)
    facts = BridgeFacts("rosbridge", RosapiFacts(), (topic,))
    return [f"{one.verdict.name} {one.check}: {one.measured}" for one in member_findings(TINY, facts, 5.0)]


def member(stamp: float | None) -> MemberReported:
    return MemberReported(TINY, 5.0, Pose(0.0, 0.0), "L1", stamp, 80.0, "idle", "")


def test_a_location_is_as_old_as_it_lags_the_newest_of_its_fleet() -> None:
    assert found("fleets", member(7.0), 0.5, 0.1) == ["OK location: 0 s old, on L1"]
    assert found("fleets", member(7.0), 40.0, 0.1) == [
        "FAIL location: 40 s old, while its fleet adapter goes on"
    ]
    (without,) = found("fleets", member(None))
    assert without.startswith("WARN location: its driver gives no time")
    assert Verdict.FAIL


def test_issues_and_tasks_are_told() -> None:
    status = StatusReported(TINY, 5.0, "idle", "", ("lift: stuck",))
    assert found("statuses", status) == ["WARN issues: lift: stuck"]
    assert not found("statuses", StatusReported(TINY, 5.0, "idle", "", ()))
    assert found("tasks", reported(5.0, "p1", robot=TINY)) == [
        "OK task: 3 messages of tasks, the last of p1: in process"
    ]
