"""Findings about time: round trips and the robots' clocks. Pure."""

import statistics
from collections.abc import Iterator

from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict, milliseconds
from fleet_tui.situation.facts import LATE_LINK
from fleet_tui.situation.links import LATE_FROM
from fleet_tui.text.units import age

# seconds of a round trip or of a call under load; between the best and the worst
SLOW = 0.3
UNEVEN = 0.3
LAST = 3  # calls by which the load is judged
BEHIND = 0.3  # seconds of our own delay, above which others are not judged
MOST_MESSAGES = {1: 4000, 2: 500}  # per second of one bridge, as measured
WRONG = 1.0  # seconds by which a clock may be off
LONG_AGO = 1e8  # a stamp of 1973 or earlier counts from the start of a simulation


def round_trip_finding(facts: BridgeFacts) -> Finding:
    """Judge the time of a call and its answer."""
    if not facts.round_trips:
        return Finding(facts.name, "round trip", Verdict.SKIPPED, "no reply to any call")
    median = statistics.median(facts.round_trips)
    jitter = max(facts.round_trips) - min(facts.round_trips)
    measured = f"{milliseconds(median)}, jitter {milliseconds(jitter)} ({len(facts.round_trips)} calls)"
    values = {"median_s": round(median, 4), "jitter_s": round(jitter, 4), "calls": len(facts.round_trips)}
    if median > SLOW or jitter > UNEVEN:
        remedy = "network or bridge slow: use a cable instead of WLAN, fewer consoles or fewer maps"
        return Finding(facts.name, "round trip", Verdict.WARN, measured, remedy, values)
    return Finding(facts.name, "round trip", Verdict.OK, measured, values=values)


def _calls(facts: BridgeFacts) -> float:
    """Return the seconds of the last calls beside the messages of all topics: the median. A bridge that falls
    behind takes ever longer."""
    return statistics.median(facts.busy_trips[-LAST:] or facts.round_trips or [0.0])


def load_word(facts: BridgeFacts) -> str:
    """Return what a bridge is called whose answers are slow beside the messages: overloaded from when the
    console calls it so, slow before, and nothing if it keeps up. Slow, it explains what its robots lack.
    Stamps are older for reasons of a robot, too. Unknown if we ourselves were late."""
    calls = _calls(facts)
    if calls < SLOW or facts.behind > BEHIND:
        return ""
    return LATE_LINK.word if calls >= LATE_FROM else "bridge slow"


def load_finding(facts: BridgeFacts) -> Finding:
    """Judge whether the bridge keeps up with all topics at once: else calls are slower."""
    rate = sum(topic.rate or 0.0 for topic in facts.topics if not topic.wanted.latched)
    if not rate:
        return Finding(facts.name, "load", Verdict.SKIPPED, "no messages to measure")
    calls = _calls(facts)
    measured = f"{rate:.0f} messages/s, calls {milliseconds(calls)} under load"
    values = {"messages_per_s": round(rate, 1), "call_s": round(calls, 4)}
    word = load_word(facts)
    if not word:
        if calls < SLOW:
            return Finding(facts.name, "load", Verdict.OK, measured, values=values)
        own = f"{measured}; this machine itself lagged by {milliseconds(facts.behind)}"
        return Finding(facts.name, "load", Verdict.SKIPPED, own, values=values)
    carries = MOST_MESSAGES.get(facts.rosapi.ros)
    remedy = "use fewer topics, lower rates at the robots or a second bridge ([links])"
    if carries:
        remedy += f"; a ROS {facts.rosapi.ros} bridge carries about {carries} messages/s"
    return Finding(facts.name, "load", Verdict.WARN, f"{word}: {measured}", remedy, values)


def clock_findings(facts: BridgeFacts) -> Iterator[Finding]:
    """Compare the bridge's clock and each robot's with ours."""
    if facts.ahead is not None:
        yield _clock(facts.name, facts.ahead, "rosapi's time")
    word = load_word(facts)
    for topic in facts.topics:
        if topic.lag is not None and word:
            yield Finding(topic.wanted.robot, "clock", Verdict.SKIPPED, f"{word}, see its load above")
        elif topic.lag is not None:
            yield _clock(topic.wanted.robot, -topic.lag, "its pose stamps")


def _clock(subject: str, ahead: float, by: str) -> Finding:
    values = {"ahead_s": round(ahead, 3)}
    way = "ahead of" if ahead > 0 else "behind"
    measured = f"{_span(abs(ahead))} {way} this machine by {by}"
    if abs(ahead) <= WRONG:
        return Finding(subject, "clock", Verdict.OK, measured, values=values)
    remedy = "synchronise it by NTP (chrony): ages stay correct, log times differ"
    if ahead < -LONG_AGO:
        remedy = "simulation time: check /use_sim_time"
    return Finding(subject, "clock", Verdict.WARN, measured, remedy, values)


def _span(seconds: float) -> str:
    if seconds < 1:
        return milliseconds(seconds)
    return f"{seconds:.1f} s" if seconds < 100 else age(seconds)
