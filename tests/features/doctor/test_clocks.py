"""The doctor's judgement of round trips, clocks and load."""

from dataclasses import replace

import msgspec
import pytest

from fleet_tui.features.doctor.clocks import clock_findings, load_finding, round_trip_finding
from fleet_tui.links.discovery.facts import BridgeFacts, RosapiFacts, TopicFacts
from fleet_tui.links.discovery.finding import Verdict
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.robots.adapter import Feed
from fleet_tui.situation.facts import LATE_LINK
from fleet_tui.situation.links import LATE_FROM, is_late


@pytest.mark.parametrize(
    ("late", "calls", "behind", "verdict"),
    [
        (0.02, 0.004, 0.0, Verdict.OK),
        (3.0, 0.004, 0.0, Verdict.OK),  # stamps get older: that is the robot's
        (0.02, 0.6, 0.0, Verdict.WARN),  # calls are slower
        (3.0, 0.6, 2.0, Verdict.SKIPPED),  # we are late ourselves
    ],
)
def test_a_bridge_that_falls_behind_is_told_from_a_machine_that_does(
    late: float, calls: float, behind: float, verdict: Verdict
) -> None:
    wanted = Feed("pose", ("r",), "", "/p", "")
    pose = TopicFacts(wanted, subscribed=True, count=50, rate=490.0, late=late)
    facts = BridgeFacts(
        "rosbridge", RosapiFacts(ros=2), (pose,), (0.004,), busy_trips=(calls,), behind=behind
    )
    found = load_finding(facts)
    assert found.verdict is verdict and "490 messages/s" in found.measured
    assert ("about 500 messages/s" in found.remedy) == (verdict is Verdict.WARN)


def load_at(calls: float) -> str:
    pose = TopicFacts(Feed("pose", ("r",), "", "/p", ""), subscribed=True, count=50, rate=490.0)
    facts = BridgeFacts("rosbridge", RosapiFacts(ros=2), (pose,), (0.004,), busy_trips=(calls,))
    return load_finding(facts).measured


def test_a_bridge_is_overloaded_from_when_the_console_calls_it_so() -> None:
    link = LinkState("rosbridge", "ws://site:9090", phase=Phase.UP)
    for calls in (0.2, 0.4, LATE_FROM - 0.01, LATE_FROM, 3.0):
        says_console = is_late(msgspec.structs.replace(link, late=calls))
        assert (LATE_LINK.word in load_at(calls)) == says_console
    assert load_at(0.4).startswith("bridge slow: 490 messages/s")


def test_round_trips_and_clocks() -> None:
    facts = BridgeFacts("rosbridge", RosapiFacts(), round_trips=(0.01, 0.02, 0.03), ahead=0.2)
    quick = round_trip_finding(facts)
    assert quick.verdict is Verdict.OK and quick.measured == "20.0 ms, jitter 20.0 ms (3 calls)"
    assert round_trip_finding(replace(facts, round_trips=(0.5,))).verdict is Verdict.WARN
    assert [one.verdict for one in clock_findings(facts)] == [Verdict.OK]
    (simulated,) = clock_findings(replace(facts, ahead=-1.7e9))
    assert simulated.verdict is Verdict.WARN and "use_sim_time" in simulated.remedy


def test_behind_a_bridge_that_is_overloaded_no_clock_is_judged() -> None:
    pose = TopicFacts(Feed("pose", ("r",), "", "/p", ""), subscribed=True, count=50, rate=10.0, lag=4.0)
    (found,) = clock_findings(BridgeFacts("rosbridge", RosapiFacts(ros=2), (pose,), busy_trips=(5.0,)))
    assert (found.verdict, found.measured) == (Verdict.SKIPPED, "bridge overloaded, see its load above")


def test_values_that_several_nodes_kept_come_at_once_and_are_no_load() -> None:
    pose = TopicFacts(Feed("pose", ("r",), "", "/p", ""), subscribed=True, count=50, rate=10.0)
    kept = Feed("tf_static", ("r",), "", "/tf_static", "", latched=True)
    frames = TopicFacts(kept, subscribed=True, count=3, rate=2e6)
    facts = BridgeFacts("rosbridge", RosapiFacts(ros=2), (pose, frames), (0.004,))
    assert load_finding(facts).measured.startswith("10 messages/s, ")
