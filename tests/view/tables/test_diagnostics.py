"""What the diagnostics screen says of links, topics, logs and health, from planted counters."""

from collections.abc import Iterable

import pytest
from hypothesis import given

from fleet_tui.model.counters import LinkCounter, Raw, TopicCounter
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import Kind
from fleet_tui.model.ros_logs import LogLine, PartDiagnosis, Severity
from fleet_tui.view.lines.diagnostics import foot_runs, page_runs
from fleet_tui.view.tables.console import OwnFacts, console_table
from fleet_tui.view.tables.health import health_table
from fleet_tui.view.tables.links import Links, link_table
from fleet_tui.view.tables.raw_message import raw_table
from fleet_tui.view.tables.robot_log import lines_of, robot_log_table
from fleet_tui.view.tables.table import Run, Table, cut, width_of
from fleet_tui.view.tables.topics import topic_table
from tests.support.fleets import LINK, R0, T0, fleet, link_lost, link_up, of_kinds, tick, told
from tests.support.hostile_text import TEXTS, WIDTHS, harmless

POSE, GRAPH, MAP, BATTERY = "/robot_0/pose", "/robot_0/f/graph", "/robot_0/f/map", "/robot_0/battery"
NOW = T0 + 20.0


def counter() -> LinkCounter:
    topics = [
        TopicCounter(BATTERY, R0, "battery"),
        TopicCounter(POSE, R0, "pose"),
        TopicCounter("/robot_1/pose", "robot_1", "pose"),
        TopicCounter(GRAPH, R0, "graph", once=True),
        TopicCounter(MAP, R0, "map", once=True, on_demand=True),
        TopicCounter("/rosout"),
    ]
    return LinkCounter(LINK, topics)


def seen(link: LinkCounter, state: FleetState | None = None) -> tuple[FleetState, Links]:
    state = told(state or told(fleet(2), link_up(T0)), tick(NOW))
    return state, [(state.links[LINK], link)]


def text(table: Table) -> list[str]:
    title = "".join(part for part, _ in table.title)
    return [title, *("".join(part for part, _ in row.runs).rstrip() for row in table.rows)]


def row(table: Table, word: str) -> str:
    (found,) = (line for line in text(table)[1:] if word in line)
    return found


def steady(topic: TopicCounter, until: float = NOW, rate: float = 10.0) -> None:
    for n in range(100):
        topic.heard(b"x" * 200, False, until - (99 - n) / rate)


def test_a_link_that_is_well() -> None:
    link = counter()
    link.opened()
    for n in range(100):
        link.all.take(300, NOW - (99 - n) / 50)
    for took in (0.001, 0.003, 0.002):
        link.round_trips.take(took, NOW - 1.0)
    table = link_table(seen(link)[1], NOW)
    assert "● up for 20 s" in row(table, "state")
    assert "2.00 ms, 1.0 s ago  last 3: 1.00 ms to 3.00 ms, mean 2.00 ms, jitter 1.50 ms" in row(
        table, "trip"
    )
    assert "50.0 /s, 15.0 kB/s, 100 and 30.0 kB in total" in row(table, "messages  ")
    assert "0 reconnects" in row(table, "connections") and "lost" not in row(table, "connections")
    assert "○ not tried yet" in row(table, "commands")


def test_a_link_that_is_down_says_so_and_since_when_everything_is_old() -> None:
    link = counter()
    link.opened()
    link.all.take(1, T0)
    link.lost("the bridge went away", T0 + 10.0)
    link.dropped, link.unreadable = 2, 1
    link.failed("no JSON", b"{", False, NOW - 3.0)
    link.round_trips.take(0.001, T0)
    link.round_trips.unanswered = 4
    state = told(fleet(2), link_up(T0), link_lost(T0 + 10.0, "connection refused", NOW + 3.0))
    table = link_table(seen(link, state)[1], NOW)
    assert "○ no link for 10 s: connection refused, retry in 3 s" in row(table, "state")
    assert "20 s ago" in row(table, "last message")
    assert "overdue" in row(table, "trip") and "4 unanswered" in row(table, "trip")
    assert "last lost 10 s ago: the bridge went away" in row(table, "connections")
    assert "2 frames: too large" in row(table, "dropped")
    assert "2 frames, last 3.0 s ago: no JSON" in row(table, "unreadable")


def test_before_anything_came() -> None:
    link = counter()
    _, links = seen(link)
    table = link_table(links, NOW)
    assert "no heartbeat reply yet" in row(table, "trip") and "never" in row(table, "last message")
    assert link_table([], NOW).rows == []


def test_topics_in_the_order_of_the_config_each_with_how_it_is() -> None:
    link = counter()
    steady(link.topics[POSE])
    steady(link.topics["/robot_1/pose"], until=NOW - 6.0)
    link.topics[GRAPH].heard(b"{}", False, T0)
    link.topics[BATTERY].not_subscribed = "has type std_msgs/Float64"
    state, links = seen(link)
    table = topic_table(state, links, "", NOW)
    assert [key[1] for key in table.keys if isinstance(key, tuple)] == [
        BATTERY,
        POSE,
        GRAPH,
        MAP,
        "/robot_1/pose",
        "/rosout",
    ]
    assert text(table)[0] == "Topics 6, 2 with problems"
    assert row(table, BATTERY).startswith("✗ not subscribed") and "std_msgs/Float64" in row(table, BATTERY)
    assert row(table, POSE).split()[:7] == ["●", "live", POSE, "10.0", "Hz", "0.0", "s"]
    assert row(table, "robot_1/pose").startswith("○ silent") and "6.0 s ago" in row(table, "robot_1/pose")
    assert row(table, GRAPH).startswith("● received") and "Hz" not in row(table, GRAPH)
    assert row(table, MAP).startswith("· on demand") and "never" in row(table, MAP)
    assert row(table, "/rosout").startswith("· on demand")


def test_bad_data_marks_its_topic_for_a_while_and_its_words_stay() -> None:
    link = counter()
    pose = link.topics[POSE]
    steady(pose)
    pose.failed("Object missing required field `pose`")
    state, links = seen(link)
    shown = row(topic_table(state, links, "", NOW), POSE)
    assert shown.startswith("▲ bad data") and "1 bad" in shown and "missing required field" in shown
    steady(pose, until=NOW + 15.0)
    later = row(topic_table(state, links, "", NOW + 15.0), POSE)
    assert later.startswith("● live") and "1 bad" in later and "missing required field" in later


def test_without_a_link_no_topic_looks_live() -> None:
    link = counter()
    steady(link.topics[POSE])
    state, links = seen(link, told(fleet(2), link_up(T0), link_lost(NOW)))
    lines = text(topic_table(state, links, "", NOW))
    assert lines[0].endswith(" no link") and all(line.startswith("○ no link") for line in lines[1:])


def test_topics_are_filtered_by_their_names() -> None:
    state, links = seen(counter())
    assert len(topic_table(state, links, "POSE", NOW).rows) == 2
    assert topic_table(state, links, "nothing", NOW).empty == "no matching topic"


LOG = [
    (T0 + 1, 1, "/robot_0/planner", "tick"),
    (T0 + 2, 20, "robot_1.base", "driving"),
    (T0 + 3, 4, "/robot_0/laser", "something is Close"),
    (T0 + 4, 50, "robot_1.base", "on fire"),
    (T0 + 5, 7, "/odd", "what level is that"),
]


def logged() -> tuple[FleetState, Links]:
    link = counter()
    for line in LOG:
        link.take_log(LogLine(*line))
    return seen(link)


def log(least: Severity = Severity.DEBUG, wanted: str = "") -> list[str]:
    state, links = logged()
    return text(robot_log_table(lines_of(links), links, state, lambda wall: f"<{wall:.0f}>", least, wanted))


def test_the_log_tells_when_how_serious_who_and_what() -> None:
    title, *lines = log()
    assert title == "Robot log /rosout  5 of 5 lines, DEBUG and worse, last 15 s ago"
    words = ["· DEBUG", "  INFO", "▲ WARN", "✗ FATAL", "level 7"]
    assert [word in line for word, line in zip(words, lines, strict=True)] == [True] * 5
    assert "/robot_0/laser" in lines[2] and "something is Close" in lines[2]
    assert lines[0].startswith("<17") and lines == sorted(lines)


@pytest.mark.parametrize(
    ("least", "wanted", "count"),
    [
        (Severity.INFO, "", 4),
        (Severity.WARN, "", 3),
        (Severity.FATAL, "", 2),  # a level that nobody knows is never hidden
        (Severity.DEBUG, "close", 1),
        (Severity.DEBUG, "ROBOT_1", 2),
        (Severity.ERROR, "laser", 0),
    ],
)
def test_level_and_text_filter_the_log(least: Severity, wanted: str, count: int) -> None:
    title, *lines = log(least, wanted)
    assert len(lines) == count and f"{count} of 5 lines" in title


def test_an_empty_log_says_why_it_is_empty() -> None:
    state, links = seen(counter())
    assert "nothing received on /rosout" in robot_log_table((), links, state, str, Severity.INFO, "").empty


def test_health_by_name_with_values_where_a_row_is_opened() -> None:
    link = counter()
    link.take_health(
        [
            PartDiagnosis(NOW, "robot_1: laser", 1, "something is close", "l1", (("distance", "0.2"),)),
            PartDiagnosis(NOW, "robot_0: drive", 0, "ready"),
            PartDiagnosis(T0, "robot_0: battery", 2, "empty"),
            PartDiagnosis(NOW, "robot_2: odd", 9, "?"),
        ]
    )
    _, links = seen(link)
    lines = text(health_table(links, {(LINK, "robot_1: laser")}, "", NOW))
    assert lines[0] == "Robot diagnostics /diagnostics  4 parts, 1 ERROR, 1 WARN, 1 level 9"
    starts = ["✗ ERROR", "● OK", "▲ WARN", "          hardware: l1", "          distance: 0.2", "? level 9"]
    assert [line.startswith(start) for line, start in zip(lines[1:], starts, strict=True)] == [True] * 6
    assert "old, 20 s ago" in lines[1]
    assert len(text(health_table(links, (), "laser", NOW))) == 2


def test_the_console_on_itself() -> None:
    facts = OwnFacts(0.1, (0.002, 0.2, 0.3), None, 8.0, 1200.0, 3, 90_000_000, 95_000_000, 7, "2 h")
    lines = text(console_table(facts, ["12:00 WARNING a: x", "12:01 ERROR b: y"], ""))
    assert "2.00 ms, 95 % within 200 ms, max 300 ms  budget 100 ms exceeded" in lines[1]
    assert "not measured yet" in lines[2]
    assert "8.0 frames/s, 1.2 kB/s, 3 held back" in lines[3]
    assert "90.0 MB, peak 95.0 MB" in lines[4] and "7 threads, uptime 2 h" in lines[5]
    assert lines[7:] == ["12:01 ERROR b: y", "12:00 WARNING a: x"]
    assert text(console_table(facts, ["one", "two"], "TW"))[7:] == ["two"]


def test_the_shown_page_stands_in_brackets_and_what_is_frozen_is_said() -> None:
    left, right = page_runs(["Link", "Topics"], 2, "frozen 12 s ago")
    assert "".join(part for part, _ in left) == " 1 Link [2 Topics]"
    assert right[0][0] == "frozen 12 s ago"


def tables(words: str) -> Iterable[Table]:
    link = counter()
    topic = TopicCounter(words, words, words)
    link.topics[words] = topic
    raw = Raw(words.encode(errors="replace"), False, T0, 9)
    topic.failed(words, raw)
    topic.not_subscribed = words
    link.failed(words, b"", True, T0)
    link.opened()
    link.lost(words, T0)
    link.take_log(LogLine(T0, 4, words, words))
    link.take_health([PartDiagnosis(T0, words, 1, words, words, ((words, words),))])
    state, links = seen(link, told(fleet(2), link_lost(T0, words)))
    yield link_table(links, NOW)
    yield topic_table(state, links, words, NOW)
    yield raw_table(topic, raw, words, NOW)
    yield robot_log_table(lines_of(links), links, state, str, Severity.DEBUG, words)
    yield health_table(links, {(LINK, words)}, words, NOW)
    yield console_table(OwnFacts(0.1, None, None, 0.0, 0.0, 0, None, None, 1, "1 s"), [words], words)


@given(TEXTS)
def test_nothing_that_anybody_says_bends_a_row(words: str) -> None:
    for table in tables(words):
        lines: list[tuple[Run, ...]] = [table.title, *(one.runs for one in table.rows)]
        for runs in lines:
            assert all(harmless(part) for part, _ in runs)
            for width in WIDTHS:
                assert width_of(cut(runs, width)) == width


def test_every_page_has_its_keys_and_what_was_said_takes_their_place() -> None:
    from fleet_tui.keys import KEYS

    keys = {key.id: key.keys for key in KEYS}
    for page in range(1, 7):
        _, right = foot_runs(keys, page, "")
        assert width_of(right) <= 75 and "back" in right[-1][0]
    left, right = foot_runs(keys, 3, "sent")
    assert left[0][0] == "sent" and right == []


def test_a_topic_is_silent_after_its_own_time_and_never_where_it_comes_on_change() -> None:
    slow = Kind("slow", silence={"battery": 60.0})
    link = LinkCounter(
        LINK,
        [
            TopicCounter(BATTERY, R0, "battery"),
            TopicCounter(POSE, R0, "pose"),
            TopicCounter("/robot_0/goals", R0, "queue", on_change=True),
        ],
    )
    state = of_kinds(told(fleet(), link_up(T0)), slow)
    state, links = seen(link, state)
    assert row(topic_table(state, links, "", NOW), "goals").startswith("· on change")
    for topic in link.topics.values():
        topic.heard(b"x", False, NOW - 30.0)
    table = topic_table(state, links, "", NOW)
    states = {name: row(table, name).split("/")[0].strip() for name in ("battery", "pose", "goals")}
    assert states == {"battery": "● live", "pose": "○ silent", "goals": "● received"}
