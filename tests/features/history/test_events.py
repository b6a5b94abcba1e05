"""The lines of a history."""

from fleet_tui.features.history.events import matching, past_events
from fleet_tui.model.history.facts import LinkChange, Note
from fleet_tui.model.history.lives import AlarmLife, PastCommand, PastOrder
from fleet_tui.text.language import Message

ORDER = PastOrder("robot_0", "12", "Base -> Store", "floor_0", 10.0, 25.0, 85.0, "done", "driven", "ana")
LOST = PastOrder("robot_1", "13", "-> Base", "floor_0", 11.0, None, 95.0, "lost", "left the queue", "")
OPEN = PastOrder("robot_1", "14", "-> Base", "floor_0", 12.0, None, None, "queued", "", "")
ALARM = AlarmLife("robot_1", Message("stuck"), "high", "stuck for 60 s", 20.0, 80.0, 50.0, 80.0, "bo", 2)
UNSEEN = AlarmLife("robot_1", Message("stuck"), "high", "stuck", 20.0, None, None, 60.0, "", 1)
HELD = AlarmLife("robot_1", Message("offline"), "high", "silent", 99.0, None, None, None, "", 1)
COMMAND = PastCommand(30.0, "ana", "robot_0", "pause", "", "not confirmed", "still drives")


def texts(*args: object) -> list[str]:
    return [event.text for event in past_events(*args)]  # type: ignore[arg-type]  # rows of each kind in turn


def test_an_order_is_told_with_its_end_and_durations() -> None:
    assert texts([ORDER, LOST, OPEN]) == [
        "robot_1 order 14 -> Base: queued",
        "robot_0 order 12 Base -> Store: done (waited 15 s, driven in 60 s), by ana",
        "robot_1 order 13 -> Base: lost (left the queue)",
    ]


def test_an_order_whose_end_nobody_saw_was_driven_in_no_known_time() -> None:
    unseen = PastOrder("robot_1", "16", "-> Base", "floor_0", 11.0, 12.0, 12.0, "end not seen", "", "ana")
    assert texts([unseen]) == ["robot_1 order 16 -> Base: end not seen (waited 1 s), by ana"]


def test_an_order_stands_at_the_time_of_its_last_step() -> None:
    driven = PastOrder("robot_1", "15", "-> Base", "floor_0", 12.0, 27.0, None, "begun", "", "")
    assert [event.told_at for event in past_events([OPEN, driven, ORDER])] == [12.0, 27.0, 85.0]


def test_an_alarm_is_told_with_how_long_it_held_and_who_saw_it() -> None:
    assert texts((), [ALARM, UNSEEN, HELD]) == [
        "robot_1 stuck alarm, stuck for 60 s: held 60 s (2 times, acknowledged after 30 s), by bo",
        "robot_1 stuck alarm, stuck: end not seen, held at least 40 s",
        "robot_1 offline alarm, silent: still holds",
    ]


def test_all_kinds_in_the_order_of_time() -> None:
    events = past_events(
        [ORDER],
        [ALARM],
        [COMMAND],
        [LinkChange("rosbridge", 5.0, True), LinkChange("rosbridge", 40.0, False, "refused")],
        [Note(35.0, "ana", "lift is slow")],
    )
    assert [event.text for event in events] == [
        "rosbridge link: up",
        "robot_1 stuck alarm, stuck for 60 s: held 60 s (2 times, acknowledged after 30 s), by bo",
        "robot_0 pause: not confirmed (still drives), by ana",
        "lift is slow, by ana",
        "rosbridge link: lost (refused)",
        "robot_0 order 12 Base -> Store: done (waited 15 s, driven in 60 s), by ana",
    ]
    assert [event.is_trouble for event in events] == [False, True, True, False, True, False]


def test_words_and_unwanted_words_and_a_robot() -> None:
    events = past_events([ORDER, LOST], [ALARM], [COMMAND])
    assert [event.what for event in matching(events, ["order", "BASE"])] == [
        "order 12 Base -> Store",
        "order 13 -> Base",
    ]
    assert [event.what for event in matching(events, ["!order", "!alarm"])] == ["pause"]
    assert [event.what for event in matching(events, [], "robot_1")] == [
        "stuck alarm, stuck for 60 s",
        "order 13 -> Base",
    ]


def test_nothing_of_it_is_executed_by_a_terminal() -> None:
    assert texts((), (), (), (), [Note(1.0, "ana", "\x1b[2Jgone")]) == ["␛[2Jgone, by ana"]


def test_a_line_has_the_time_of_what_it_says() -> None:
    """Of an order its end, which is its outcome; of one that goes on, its begin."""
    events = past_events([ORDER, OPEN], [ALARM], [COMMAND])
    assert [(event.kind.value, event.told_at) for event in events] == [
        ("order", 12.0),
        ("alarm", 20.0),
        ("command", 30.0),
        ("order", 85.0),
    ]
