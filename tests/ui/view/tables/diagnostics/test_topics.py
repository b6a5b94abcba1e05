"""Topics on the diagnostics screen: which are live, silent, bad, or only asked for on demand."""

from msgspec.structs import replace

from fleet_tui.model.counters import LinkCounter, TopicCounter
from fleet_tui.model.kind import Kind
from fleet_tui.ui.view.tables.arrangement import NO_MATCH, RowArrangement
from fleet_tui.ui.view.tables.diagnostics.topics import topic_table
from tests.support.diagnostics import BATTERY, GRAPH, MAP, NOW, POSE, counter, row, seen, steady, text
from tests.support.fleets import LINK, R0, T0, fleet, link_lost, link_up, of_kinds, reduced, text_of


def test_topics_with_problems_first_then_in_the_order_of_the_config_each_with_how_it_is() -> None:
    link = counter()
    steady(link.topics[POSE])
    steady(link.topics["/robot_1/pose"], until=NOW - 6.0)
    link.topics[GRAPH].count_frame(b"{}", False, T0)
    link.topics[BATTERY].not_subscribed = "has type std_msgs/Float64"
    state, links = seen(link)
    table = topic_table(state, links, NOW)
    assert [key[1] for key in table.keys if isinstance(key, tuple)] == [
        BATTERY,
        "/robot_1/pose",
        POSE,
        GRAPH,
        MAP,
        "/rosout",
    ]
    assert text(table)[0] == "Topics 6, 2 with problems"
    assert row(table, BATTERY).startswith("✗ not subscribed") and "std_msgs/Float64" in row(table, BATTERY)
    assert row(table, POSE).split()[:8] == ["●", "live", "0.0", "s", "ago", POSE, "10.0", "Hz"]
    assert row(table, "robot_1/pose").startswith("○ silent") and "6.0 s ago" in row(table, "robot_1/pose")
    assert row(table, GRAPH).startswith("● received") and "Hz" not in row(table, GRAPH)
    assert row(table, MAP).startswith("· on demand") and "never" in row(table, MAP)
    assert row(table, "/rosout").startswith("· on demand")


def test_a_long_name_is_cut_at_its_front_where_it_must_and_the_columns_have_heads() -> None:
    long = "/robot_0/follow_waypoints/_action/feedback"
    link = LinkCounter(LINK, [TopicCounter(long, R0, "pose"), TopicCounter(POSE, R0, "pose")])
    state, links = seen(link)
    table = topic_table(state, links, NOW)
    assert POSE in row(table, POSE).split()
    assert long in row(table, "feedback").split()
    assert text_of(table.head).split() == [
        *("State", "Last", "Topic", "Rate", "At", "most", "Bytes", "Messages")
    ]


def test_a_narrow_pane_has_whole_columns_and_names_from_a_part_on() -> None:
    long = TopicCounter("/robot_0/follow_waypoints/_action/feedback", R0, "pose")
    long.asked_ms = 100
    steady(long)
    long.failed("Object missing required field `pose`")
    refused = TopicCounter("/robot_0/goals", R0, "queue")
    refused.not_subscribed = "has type std_msgs/Float64"
    state, links = seen(LinkCounter(LINK, [long, refused]))
    table = topic_table(state, links, NOW, width=76)
    told = row(table, "feedback")[:76]
    assert "…/_action/feedback " in told and "10.0 Hz  10.0 Hz" in told and "missing" not in told
    assert "has type std_msgs" in row(table, "goals")[:76]
    assert len(text_of(table.head)) <= 76 and "Bytes" not in text_of(table.head)


def test_topics_of_an_overloaded_bridge_are_late_and_far_below_their_rate_slow() -> None:
    link = counter()
    steady(link.topics["/robot_1/pose"], rate=9.0)
    steady(link.topics[POSE], rate=1.6)
    for topic in link.topics.values():
        topic.asked_ms = 100
    state, links = seen(link)
    assert row(topic_table(state, links, NOW), POSE).startswith("● live"), "the robot may send no more"
    table = topic_table(state, [(replace(links[0][0], late=12.0), link)], NOW)
    keys = [key[1] for key in table.keys if isinstance(key, tuple)]
    assert row(table, POSE).startswith("▲ slow") and row(table, "/robot_1/pose").startswith("▲ late")
    assert keys.index(POSE) < keys.index("/robot_1/pose")
    assert text(table)[0].endswith(" messages 12 s late: lower the rates")


def test_bad_data_marks_its_topic_for_a_while_and_its_words_stay() -> None:
    link = counter()
    pose = link.topics[POSE]
    steady(pose)
    pose.failed("Object missing required field `pose`")
    state, links = seen(link)
    shown = row(topic_table(state, links, NOW), POSE)
    assert shown.startswith("▲ bad data") and "1 bad" in shown and "missing required field" in shown
    steady(pose, until=NOW + 15.0)
    later = row(topic_table(state, links, NOW + 15.0), POSE)
    assert later.startswith("● live") and "1 bad" in later and "missing required field" in later


def test_without_a_link_no_topic_looks_live() -> None:
    link = counter()
    steady(link.topics[POSE])
    state, links = seen(link, reduced(fleet(2), link_up(T0), link_lost(NOW)))
    lines = text(topic_table(state, links, NOW))
    assert lines[0].endswith(" no link") and all(line.startswith("○ no link") for line in lines[1:])


def test_topics_are_filtered_by_their_names_and_sorted_by_their_columns() -> None:
    link, arrangement = counter(), RowArrangement()
    steady(link.topics["/robot_1/pose"], rate=2.0)
    steady(link.topics[POSE], rate=9.0)
    state, links = seen(link)
    arrangement.typed = "POSE"
    arrangement.column = "rate"
    table = topic_table(state, links, NOW, "robot_1", arrangement=arrangement)
    assert table.keys == [(LINK, POSE), (LINK, "/robot_1/pose")]
    assert text_of(table.title).endswith(" /POSE: 2 by rate")
    arrangement.typed = "nothing"
    assert topic_table(state, links, NOW, arrangement=arrangement).empty == NO_MATCH


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
    state = of_kinds(reduced(fleet(), link_up(T0)), slow)
    state, links = seen(link, state)
    assert row(topic_table(state, links, NOW), "goals").startswith("· on change")
    for topic in link.topics.values():
        topic.count_frame(b"x", False, NOW - 30.0)
    table = topic_table(state, links, NOW)
    states = {name: row(table, name)[:12].strip() for name in ("battery", "pose", "goals")}
    assert states == {"battery": "● live", "pose": "○ silent", "goals": "● received"}


def test_the_rate_that_was_requested_is_beside_that_of_the_messages() -> None:
    link = counter()
    steady(link.topics[POSE])
    link.topics[POSE].asked_ms, link.topics[BATTERY].asked_ms = 100, 0
    state, links = seen(link)
    table = topic_table(state, links, NOW)
    assert row(table, POSE).partition(POSE)[2].split()[:4] == ["10.0", "Hz", "10.0", "Hz"]
    assert "Hz" not in row(table, BATTERY)


def test_the_topics_of_the_selected_robot_come_first() -> None:
    state, links = seen(counter())
    keys = topic_table(state, links, NOW, "robot_1").keys
    assert [key[1] for key in keys if isinstance(key, tuple)][:2] == ["/robot_1/pose", BATTERY]


def test_what_is_left_of_a_long_name_tells_actions_apart() -> None:
    names = [f"/robot_0/{action}/_action/status" for action in ("follow_waypoints", "navigate_to_pose")]
    state, links = seen(LinkCounter(LINK, [TopicCounter(name, R0, "queue") for name in names]))
    cells = [text_of(one.runs)[28:55].strip() for one in topic_table(state, links, NOW, width=76).rows]
    assert len(set(cells)) == 2 and all(cell.startswith("…") for cell in cells)
    camera = TopicCounter("/robot_0/camera/image_raw/compressed", R0, "image")
    table = topic_table(state, seen(LinkCounter(LINK, [camera]))[1], NOW, width=76)
    assert "…/camera/image_raw/compressed" in row(table, "image_raw"), "whole parts"
