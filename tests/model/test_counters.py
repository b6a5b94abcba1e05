"""Counters tell the rates that there were, and never grow."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.model.counters import (
    BEATS,
    HEAD,
    LARGEST_KEPT,
    LOG_LINES,
    MOST_DIAGNOSES,
    WINDOW,
    Flow,
    LinkCounter,
    RoundTrips,
    TopicCounter,
)
from fleet_tui.model.ros_logs import LogLine, PartDiagnosis
from tests.support.fleets import T0


def flow(times: list[float], size: int = 100) -> Flow:
    it = Flow()
    for at in times:
        it.take(size, at)
    return it


@given(st.floats(0.5, 200.0), st.integers(12, 300), st.floats(0.0, 0.99))
def test_a_steady_stream_has_its_rate_whenever_one_looks(rate: float, count: int, later: float) -> None:
    times = [T0 + n / rate for n in range(count)]
    rates = flow(times).rates(times[-1] + later / rate)
    assert rates is not None
    assert rates[0] == pytest.approx(rate, rel=0.01)
    assert rates[1] == pytest.approx(rate * 100, rel=0.01)


@given(st.lists(st.floats(0.0, 3.0), min_size=2, max_size=200), st.floats(0.0, 20.0))
def test_the_rate_is_that_of_what_came_in_the_window(gaps: list[float], silence: float) -> None:
    times = [T0]
    for gap in gaps:
        times.append(times[-1] + gap)
    now = times[-1] + silence
    rates = flow(times).rates(now)
    assert rates is not None and rates[0] >= 0.0
    recent = sum(at >= now - WINDOW for at in times)
    if not recent:
        assert rates == (0.0, 0.0)
    elif silence > 2.0 * max(gaps):
        assert rates[0] * silence <= recent * 2.0


def test_a_stream_that_stops_fades_and_is_nothing_after_the_window() -> None:
    it = flow([T0 + n / 10 for n in range(50)])
    seen = [rates[0] for rates in (it.rates(T0 + 4.9 + n) for n in range(7)) if rates]
    assert seen[0] == pytest.approx(10.0) and seen[-1] == 0.0
    assert seen == sorted(seen, reverse=True)


def test_after_a_recording_was_turned_back_only_what_came_since_counts() -> None:
    it = flow([T0 + n / 10 for n in range(50)])
    for n in range(20):
        it.take(100, T0 - 100.0 + n / 5)
    rates = it.rates(T0 - 96.1)
    assert rates is not None and rates[0] == pytest.approx(5.0, rel=0.05)


def test_what_came_once_has_no_rate() -> None:
    assert Flow().rates(T0) is None and flow([T0]).rates(T0 + 1.0) is None


def test_a_burst_at_one_instant_is_no_division_by_zero() -> None:
    rates = flow([T0, T0, T0]).rates(T0)
    assert rates is not None and rates[0] > 0.0


def test_of_a_large_message_only_the_head_is_kept() -> None:
    topic = TopicCounter("/map")
    topic.count_frame(b"x" * LARGEST_KEPT, False, T0)
    assert topic.last is not None and topic.last.is_whole
    topic.count_frame(b"x" * (LARGEST_KEPT + 1), False, T0)
    assert not topic.last.is_whole
    assert (len(topic.last.payload), topic.last.size) == (HEAD, LARGEST_KEPT + 1)
    topic.failed("too long")
    assert topic.bad is not None and topic.bad.raw is topic.last and topic.errors == 1


def test_the_payload_is_kept_without_copying_it() -> None:
    payload = b'{"op":"publish"}'
    topic = TopicCounter("/pose")
    topic.count_frame(payload, False, T0)
    assert topic.last is not None and topic.last.payload is payload


def test_jitter_is_how_much_two_in_a_row_differ() -> None:
    trips = RoundTrips()
    assert trips.jitter == 0.0
    for took in (0.010, 0.014, 0.012):
        trips.take(took, T0)
    assert trips.jitter == pytest.approx(0.003)
    for _ in range(10 * BEATS):
        trips.take(0.01, T0)
    assert len(trips.took) == BEATS and trips.jitter == 0.0


def test_tries_that_fail_are_no_losses() -> None:
    link = LinkCounter("site", [])
    link.lost("connection refused", T0)
    assert (link.connections, link.lost_at) == (0, None)
    link.opened()
    link.lost("the bridge went away", T0 + 1.0)
    link.lost("connection refused", T0 + 2.0)
    assert (link.connections, link.lost_at, link.lost_why) == (1, T0 + 1.0, "the bridge went away")


def test_log_and_health_are_bounded_and_the_newest_word_counts() -> None:
    link = LinkCounter("site", [])
    for n in range(LOG_LINES + 7):
        link.take_log(LogLine(T0 + n, 2, "/node", str(n)))
    assert len(link.log) == LOG_LINES and link.logged == LOG_LINES + 7
    assert link.log[-1].text == str(LOG_LINES + 6)
    link.take_health(PartDiagnosis(T0, f"part {n}", 0, "fine") for n in range(MOST_DIAGNOSES + 9))
    link.take_health(
        [PartDiagnosis(T0 + 1, "part 0", 2, "broken"), PartDiagnosis(T0 + 1, "one too many", 2, "")]
    )
    assert len(link.health) == MOST_DIAGNOSES and "one too many" not in link.health
    assert link.health["part 0"].message == "broken"


def test_lines_of_a_latched_log_are_kept_once() -> None:
    link = LinkCounter("site", [])
    lines = [LogLine(T0, 2, "/node", "up", stamp=5.0), LogLine(T0, 2, "/node", "up", stamp=6.0)]
    lines += [LogLine(T0, 2, "/other", "up", stamp=5.0), LogLine(T0, 2, "/node", "down", stamp=5.0)]
    for at in (0.0, 9.0):
        for line in lines:
            link.take_log(replace(line, at=T0 + at))
    assert list(link.log) == lines and link.logged == len(lines)
    for _ in range(2):
        link.take_log(LogLine(T0, 2, "/node", "without a stamp"))
    assert link.logged == len(lines) + 2
