"""The doctor's judgement without a wire: graphs, clocks, terminal, text."""

import os
import pty
import threading
from dataclasses import replace

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from fleet_tui.adapters.adapter import Feed
from fleet_tui.config.schema import FloorEntry
from fleet_tui.discovery.facts import BridgeFacts, RosapiFacts, TopicFacts
from fleet_tui.discovery.finding import Finding, Verdict
from fleet_tui.discovery.tools import LOOK_FOR_NODE, named
from fleet_tui.discovery.wire import TopicListening
from fleet_tui.doctor.charts import FloorSurvey
from fleet_tui.doctor.clocks import clock_findings, load_finding, round_trip_finding
from fleet_tui.doctor.graphs import connection_finding, label_finding
from fleet_tui.doctor.render import line, summary
from fleet_tui.doctor.terminal import (
    BRAILLE,
    NOTHING,
    colour_finding,
    locale_finding,
    measured_findings,
    size_finding,
    speed_finding,
)
from fleet_tui.model.events import Event, TimePassed
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex

FLOOR = FloorEntry("floor_0")
IDS = st.integers(0, 7)


def graph(pairs: list[tuple[int, int]], directed: bool = False, lifts: tuple[int, ...] = ()) -> RouteGraph:
    roles = {id_: Role.ELEVATOR if id_ in lifts else Role.PLAIN for id_ in range(8)}
    vertices = {str(id_): Vertex(str(id_), float(id_), 0.0, role) for id_, role in roles.items()}
    return RouteGraph(
        vertices, tuple(Edge(str(n), *map(str, pair)) for n, pair in enumerate(pairs)), directed
    )


@given(st.lists(st.tuples(IDS, IDS), max_size=20), st.booleans())
@example([(n, n + 1) for n in range(7)], True)
@example([(n, n + 1) for n in range(7)], False)
def test_a_graph_hangs_together_if_there_is_a_path_between_any_two(
    pairs: list[tuple[int, int]], directed: bool
) -> None:
    routes = graph(pairs, directed)
    together = all(routes.path(str(start), str(end)) for start in range(8) for end in range(8))
    found = connection_finding(FLOOR, "", FloorSurvey(routes), routes, False)
    assert (found.verdict is Verdict.OK) == together


def test_elevators_join_parts_where_there_are_other_floors() -> None:
    routes = graph([(0, 1), (1, 2), (2, 3), (4, 5), (5, 6), (6, 7)], lifts=(3, 4))
    assert connection_finding(FLOOR, "", FloorSurvey(routes), routes, True).verdict is Verdict.OK
    alone = connection_finding(FLOOR, "", FloorSurvey(routes, {"6": "Store"}), routes, False)
    assert alone.verdict is Verdict.FAIL and "4 of 8 vertices unreachable" in alone.measured


def test_labels_given_twice_or_not_at_all() -> None:
    routes = graph([])
    assert "duplicate: Base" in label_finding(FLOOR, "", {"0": "Base", "1": "Base"}, routes).measured
    assert label_finding(FLOOR, "", {}, routes).verdict is Verdict.WARN


def test_a_message_that_is_being_read_is_not_one_that_can_not_be_read() -> None:
    """A large map takes its time on a thread, and the facts may be asked for meanwhile."""
    seen = []

    def read(_feed: Feed, _msg: object, at: float) -> list[Event]:
        seen.append(heard.facts(at).count)
        return [TimePassed(at, at)]

    heard = TopicListening(Feed("map", ("robot_0",), "floor_0", "/map", ""), 0.0, read)
    heard.take({}, 1.0)
    facts = heard.facts(2.0)
    assert seen == [0] and (facts.count, facts.event) == (1, TimePassed(1.0, 1.0))


@pytest.mark.parametrize(
    ("late", "calls", "behind", "verdict"),
    [
        (0.02, 0.004, 0.0, Verdict.OK),
        (3.0, 0.004, 0.0, Verdict.WARN),  # stamps get older
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


@pytest.mark.parametrize(
    ("ros", "words"),
    [
        (1, "rosnode ping /base"),
        (2, "ros2 node list"),
        (0, "rosnode ping /base, ROS 2: ros2 node list"),
    ],
)
def test_a_remedy_names_the_tools_of_the_ros_that_is_there(ros: int, words: str) -> None:
    assert named(LOOK_FOR_NODE, ros, "/base") == words


def test_round_trips_and_clocks() -> None:
    facts = BridgeFacts("rosbridge", RosapiFacts(), round_trips=(0.01, 0.02, 0.03), ahead=0.2)
    quick = round_trip_finding(facts)
    assert quick.verdict is Verdict.OK and quick.measured == "20.0 ms, jitter 20.0 ms (3 calls)"
    assert round_trip_finding(replace(facts, round_trips=(0.5,))).verdict is Verdict.WARN
    assert [one.verdict for one in clock_findings(facts)] == [Verdict.OK]
    (simulated,) = clock_findings(replace(facts, ahead=-1.7e9))
    assert simulated.verdict is Verdict.WARN and "use_sim_time" in simulated.remedy


@pytest.mark.parametrize(
    ("finding", "verdict"),
    [
        (size_finding(120, 40), Verdict.OK),
        (size_finding(59, 40), Verdict.WARN),
        (colour_finding({"TERM": "xterm-256color"}), Verdict.OK),
        (colour_finding({"TERM": "dumb"}), Verdict.WARN),
        (colour_finding({"TERM": "dumb", "NO_COLOR": "1"}), Verdict.OK),
        (locale_finding("UTF-8", "C.UTF-8"), Verdict.OK),
        (locale_finding("ANSI_X3.4-1968", "C"), Verdict.WARN),
        (speed_finding(9_600 / 10, 0.1), Verdict.WARN),
    ],
)
def test_the_terminal(finding: Finding, verdict: Verdict) -> None:
    assert finding.verdict is verdict
    assert bool(finding.remedy) == (verdict is Verdict.WARN)


@pytest.mark.parametrize(("wide", "verdict"), [(1, Verdict.OK), (2, Verdict.WARN)])
def test_a_terminal_that_answers_is_measured(wide: int, verdict: Verdict) -> None:
    theirs, ours = pty.openpty()

    def answer() -> None:
        """A terminal: asked four times, it says where its cursor is; braille may take two cells each."""
        heard, asked = b"", 0
        while asked < 4:
            heard += os.read(theirs, 65536)
            while b"\x1b[6n" in heard and asked < 4:
                before, _, heard = heard.partition(b"\x1b[6n")
                column = 1 + wide * before.decode().count(BRAILLE[0])
                os.write(theirs, f"\x1b[1;{column}R".encode())
                asked += 1

    terminal = threading.Thread(target=answer, daemon=True)
    terminal.start()
    glyphs, speed = measured_findings(ours, ours)
    terminal.join(5)
    assert glyphs.verdict is verdict and glyphs.values["cells"] == wide * len(BRAILLE)
    assert speed.check == "speed" and len(NOTHING) > 10_000
    os.close(ours)
    os.close(theirs)


def test_a_terminal_that_does_not_answer_is_skipped() -> None:
    theirs, ours = pty.openpty()
    assert [one.verdict for one in measured_findings(ours, ours)] == [Verdict.SKIPPED] * 2
    os.close(ours)
    os.close(theirs)


LONG = Finding(
    "robot_0",
    "queue",
    Verdict.FAIL,
    "/robot_0/queue is not on the bridge",
    'did you mean /robot_0/action_queue? Set [profile.topics] queue = "/{robot}/action_queue"',
)


def test_80_columns() -> None:
    assert line(LONG, plain=False, colour=False, width=80).splitlines() == [
        "   FAIL ✗ robot_0 queue: /robot_0/queue is not on the bridge -> did you mean",
        "          /robot_0/action_queue? Set [profile.topics] queue =",
        '          "/{robot}/action_queue"',
    ]
    assert "\n" not in line(LONG, plain=False, colour=False)


def test_text_of_the_wire_moves_no_cursor() -> None:
    hostile = replace(LONG, measured="\x1b[2J\u202eboo")
    assert "\x1b" not in line(hostile, plain=False, colour=False)
    assert line(hostile, plain=True, colour=False).isascii()
    assert "\x1b" not in summary([hostile])
