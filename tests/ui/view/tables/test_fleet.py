"""The fleet pane says a word exactly while it is true."""

import pytest
from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.alarm import Alarm, Condition, Priority
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.language import Message
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import NO_MATCH, RowArrangement
from fleet_tui.ui.view.tables.fleet import CARGO, fleet_table
from fleet_tui.ui.view.tables.table import Run
from tests.support.fleets import (
    R0,
    T0,
    battery,
    commanded,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    place_order,
    pose,
    queue,
    reduced,
    text_of,
    tick,
)

WIDTH = 80


def runs(state: FleetState, robot: int = 0, selected: str = R0) -> tuple[Run, ...]:
    return fleet_table(state, selected, WIDTH).rows[robot].runs


def row(state: FleetState) -> str:
    return text_of(runs(state))


def role_of(state: FleetState, part: str) -> StyleRole:
    (found,) = {role for text, role in runs(state) if part in text}
    return found


def received(*facts: events.Event, at: float = T0 + 1.0) -> FleetState:
    """A robot that just spoke, and then these facts, seen a moment later."""
    return reduced(fleet(), link_up(T0), pose(at), battery(at), queue(at), *facts, tick(at + 0.1))


def test_a_calm_robot_says_nothing_that_is_not_so() -> None:
    text = row(received())
    assert "80 %" in text and "floor_0" in text and "idle" in text
    for word in ("offline", "obstacle", "paused", "never seen", "old", "bad data", CARGO, "unknown"):
        assert word not in text


def test_never_seen_until_it_speaks() -> None:
    state = reduced(fleet(), link_up(T0), graph(1), tick(T0 + 99))
    assert "never seen" in row(state) and "offline" not in row(state)
    assert "- %" in row(state)
    assert "never seen" not in row(reduced(state, battery(T0 + 100), tick(T0 + 100)))


def test_bad_data_is_marked_even_if_nothing_else_came() -> None:
    state = reduced(
        fleet(), events.MessageRejected(R0, Message("pose")), events.MessageRejected(R0, Message("pose"))
    )
    assert "never seen, bad data x2" in row(state)
    assert "bad data x1" in row(received(events.MessageRejected(R0, Message("pose"))))


def test_offline_with_its_age_after_the_limit() -> None:
    state = received(at=T0)
    assert "offline" not in row(reduced(state, tick(T0 + 5.0)))
    silent = reduced(state, tick(T0 + 7.2))
    assert "offline 7 s" in row(silent) and role_of(silent, "offline") is StyleRole.ALARM
    assert "idle" not in row(silent)
    assert "offline" not in row(reduced(silent, battery(T0 + 8), tick(T0 + 8)))


@pytest.mark.parametrize(("seconds", "said"), [(0.0, False), (3.0, False), (3.1, True), (4.2, True)])
def test_obstacle_above_three_seconds(seconds: float, said: bool) -> None:
    state = received(events.ObstacleReported(R0, T0 + 1, seconds))
    assert (f"obstacle {seconds:.1f} s" in row(state)) is said
    assert ("obstacle" in row(state)) is said
    free = reduced(state, events.ObstacleReported(R0, T0 + 2, 0.0))
    assert "obstacle" not in row(free)


def test_an_obstacle_of_an_offline_robot_was_then() -> None:
    state = reduced(received(events.ObstacleReported(R0, T0 + 1, 4.2)), tick(T0 + 30))
    assert "obstacle" not in row(state)
    assert "contact for 4.2 s, 29 s ago" in row(state) and role_of(state, "contact") is StyleRole.DIM


def test_paused_by_its_own_word_or_by_ours() -> None:
    assert "paused " in row(received(events.PausedReported(R0, T0 + 1, True)))
    assert "by us" not in row(received(events.PausedReported(R0, T0 + 1, True)))
    ours = commanded(1, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED)
    assert "paused (by us)" in text_of(fleet_table(received(*ours), R0, 120).rows[0].runs)
    assert "paused" not in row(received(*ours, pose(T0 + 1, 8.0), pose(T0 + 2, 9.0)))
    assert "paused" not in row(received(*ours, events.PausedReported(R0, T0 + 1, False)))


@pytest.mark.parametrize(
    ("percent", "text", "role"),
    [
        (100.0, "100 %", StyleRole.TEXT),
        (20.0, " 20 %", StyleRole.TEXT),
        (19.9, " 19 %", StyleRole.WARN),
        (9.9, "  9 %", StyleRole.ALARM),
        (0.4, "  0 %", StyleRole.ALARM),
    ],
)
def test_a_battery_below_twenty_is_amber_below_ten_red_and_reads_below(
    percent: float, text: str, role: StyleRole
) -> None:
    state = received(battery(T0 + 1, percent))
    assert text in row(state) and role_of(state, "%") is role
    assert role_of(reduced(state, tick(T0 + 60)), "%") is StyleRole.DIM


def test_the_alarm_of_a_battery_reads_below_the_limit_too() -> None:
    assert [alarm.text for alarm in received(battery(T0 + 1, 19.6)).alarms] == ["battery 19 %"]


def test_an_order_gives_its_start_to_a_long_state() -> None:
    order = queue(T0 + 1, (4, 1, 2, "W"), current=4), labels({1: "Receiving", 2: "Dock"}), graph(1, 2)
    calm = received(*order)
    assert "Receiving -> Dock" in text_of(fleet_table(calm, R0, 100).rows[0].runs)
    old = reduced(calm, events.CargoReported(R0, T0 + 40, True), tick(T0 + 40))
    told = text_of(fleet_table(old, R0, 100).rows[0].runs)
    assert "Receiving" not in told and "-> Dock  pose 39 s old, " in told


def test_a_value_gone_quiet_shows_its_age_while_the_robot_speaks() -> None:
    state = reduced(received(at=T0), events.CargoReported(R0, T0 + 40, True), tick(T0 + 40))
    for name in ("pose", "battery", "queue"):
        assert f"{name} 40 s old" in text_of(fleet_table(state, R0, 200).rows[0].runs)
    assert "offline" not in row(state)
    assert "old" not in row(reduced(state, tick(T0 + 90)))  # then it is offline, which says more


def test_a_robot_that_speaks_without_a_pose_is_not_well() -> None:
    start = reduced(fleet(), link_up(T0), battery(T0), queue(T0), tick(T0 + 0.1))
    assert "pose" not in row(start) and runs(start)[0][1] is StyleRole.GOOD
    late = reduced(start, tick(T0 + 3.1))
    assert "pose missing" in row(late) and runs(late)[0][1] is StyleRole.WARN


@pytest.mark.parametrize(
    ("width", "said"),
    [(40, "obstacle 4.2 s, ‖"), (44, "obstacle 4.2 s, paused "), (150, "obstacle 4.2 s, paused (elsewhere)")],
)
def test_a_pause_is_a_sign_where_its_words_would_be_cut(width: int, said: str) -> None:
    facts = events.ObstacleReported(R0, T0 + 1, 4.2), events.PausedReported(R0, T0 + 1, True)
    assert said in text_of(fleet_table(received(*facts), R0, width).rows[0].runs)


def test_the_floor_as_far_as_the_pose_tells() -> None:
    assert " -" in row(reduced(fleet(), battery(T0), tick(T0)))
    assert "unknown floor" in row(received(pose(T0 + 1, frame="attic")))
    assert "floor_1" in row(reduced(fleet(1, 2), pose(T0, frame="/floor_1"), tick(T0)))


def test_what_it_does() -> None:
    named = (graph(1, 2), labels({1: "Base", 2: "Consumidores"}))
    assert "Base -> Consumidores" in row(received(*named, queue(T0 + 1, (4, 1, 2, "W"), current=4)))
    assert "waiting" in row(received(*named, queue(T0 + 1, (4, 1, 2, "Q"), (5, 2, 1, "Q"))))
    waits = received(*named, queue(T0 + 1, (4, 2, 1, "Q")))
    assert "waiting -> Base" in text_of(fleet_table(waits, R0, 42).rows[0].runs)
    assert CARGO in row(received(events.CargoReported(R0, T0 + 1, True)))


def test_every_robot_has_its_row_in_the_order_of_the_config() -> None:
    state = reduced(fleet(12), battery(T0), battery(T0, robot="robot_11"), tick(T0))
    table = fleet_table(state, "robot_3", WIDTH)
    assert [line.key for line in table.rows] == [f"robot_{n}" for n in range(12)]
    assert text_of(table.title) == "Fleet 2 of 12 online: 2 unknown"
    marked = [line.key for line in table.rows if StyleRole.ACCENT in {role for _, role in line.runs}]
    assert marked == ["robot_3"]
    starts = {text_of(line.runs).index("robot_") for line in table.rows}
    assert len(starts) == 1


def test_news_is_whole_where_the_floor_has_to_give_way() -> None:
    """120 columns leave a pane of 47 cells."""
    state = reduced(
        received(events.ObstacleReported(R0, T0 + 1, 4.2), events.PausedReported(R0, T0 + 1, True)),
        tick(T0 + 1),
    )
    shown = "".join(text for text, _ in fleet_table(state, R0, 47).rows[0].runs)[:47]
    assert "obstacle 4.2 s, paused" in shown


def test_an_order_that_is_only_listed_still_is_not_waiting() -> None:
    assert "idle" in row(received(queue(T0 + 1, (1, 1, 2, "D"), (2, 1, 2, "C"))))
    assert "waiting" in row(received(queue(T0 + 1, (1, 1, 2, "D"), (2, 1, 2, "Q"))))


def test_a_robot_whose_queue_never_came_is_not_idle() -> None:
    start = reduced(fleet(), link_up(T0), pose(T0), battery(T0), tick(T0 + 0.1))
    assert "no queue yet" in row(start) and "idle" not in row(start)
    late = row(reduced(start, tick(T0 + 3.1)))
    assert "queue missing" in late and "idle" not in late


def test_a_pause_that_did_not_come_from_here_is_told_from_ours() -> None:
    paused = events.PausedReported(R0, T0 + 1, True)
    assert "paused (elsewhere)" in text_of(fleet_table(received(paused), R0, 120).rows[0].runs)
    ours = commanded(1, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED)
    assert "paused " in row(received(*ours, paused)) and "elsewhere" not in row(received(*ours, paused))
    refused = commanded(1, PauseRobot(R0), Stage.SENT, Stage.REFUSED)
    assert "paused (elsewhere)" in text_of(fleet_table(received(*refused, paused), R0, 120).rows[0].runs)


def test_bad_data_is_in_the_row_as_long_as_it_is_news() -> None:
    state = received(events.MessageRejected(R0, Message("/robot_0/pose: nonsense")))
    assert "bad data x1" in row(state)
    later: list[events.Event] = [pose(T0 + 13), battery(T0 + 13), queue(T0 + 13), tick(T0 + 13)]
    assert "bad data" not in row(reduced(state, *later))


def test_a_robot_with_an_alarm_stands_first_and_the_others_keep_their_order() -> None:
    state = reduced(fleet(4), link_up(T0))
    for n in range(4):
        state = reduced(state, battery(T0, 5.0 if n == 2 else 80.0, f"robot_{n}"))
    state = reduced(state, *(pose(T0, robot=f"robot_{n}") for n in range(4)))
    names = [row.key for row in fleet_table(reduced(state, tick(T0)), R0, 60).rows]
    assert names == ["robot_2", "robot_0", "robot_1", "robot_3"]
    shelved = reduced(
        state, tick(T0), desk_events.AlarmShelved("robot_2", "battery", T0 + 1800), tick(T0 + 1)
    )
    rows = fleet_table(shelved, R0, 60).rows
    assert [row.key for row in rows] == names
    assert rows[0].runs[0] == ("◇ ", StyleRole.WARN) and rows[1].runs[0] == ("● ", StyleRole.GOOD)


def standing(seconds: float) -> FleetState:
    """A robot with an order whose poses show it in one place for so long."""
    at = T0 + seconds
    ordered = queue(at, (1, 1, 2, "W"), current=1)
    return reduced(fleet(), link_up(T0), pose(T0), pose(at), battery(at), ordered, tick(at + 0.4))


@pytest.mark.parametrize(("seconds", "first"), [(20.0, R0), (40.0, "robot_1")])
def test_a_robot_that_stands_with_an_order_for_long_comes_before_the_calm_ones(
    seconds: float, first: str
) -> None:
    at, other = T0 + seconds, "robot_1"
    poses = (pose(T0, robot=other), pose(at, robot=other), pose(at), queue(at))
    ordered = queue(at, (1, 1, 2, "W"), current=1, robot=other)
    state = reduced(fleet(2), link_up(T0), *poses, ordered, battery(at), battery(at, robot=other), tick(at))
    assert fleet_table(state, R0, WIDTH).keys[0] == first


def test_the_most_urgent_trouble_is_first_as_in_the_alarms_pane() -> None:
    low = (battery(T0, 15.0), battery(T0, 5.0, "robot_2"))
    state = reduced(fleet(3), link_up(T0), *low, tick(T0))
    assert fleet_table(state, R0, WIDTH).keys == ["robot_2", R0, "robot_1"]
    seen = reduced(state, desk_events.AlarmAcknowledged("robot_2", "battery"))
    assert fleet_table(seen, R0, WIDTH).keys == [R0, "robot_2", "robot_1"]


def test_a_robot_stands_as_long_as_its_poses_show() -> None:
    now = standing(40.0)
    assert row(now).rstrip().endswith("waiting 40 s")
    assert row(reduced(now, tick(T0 + 41.4))).rstrip().endswith("waiting 40 s"), "its last pose is of then"


def test_a_robot_that_stands_for_long_is_yellow_before_it_is_an_alarm() -> None:
    assert [role_of(standing(seconds), "waiting") for seconds in (20.0, 40.0)] == [
        StyleRole.DIM,
        StyleRole.WARN,
    ]
    assert [role_of(standing(seconds), "●") for seconds in (20.0, 40.0)] == [StyleRole.GOOD, StyleRole.WARN]


def test_in_a_narrow_pane_an_order_that_does_not_get_on_says_so() -> None:
    short, long = (text_of(fleet_table(standing(t), R0, 48).rows[0].runs) for t in (10.0, 40.0))
    assert "waiting 10 s 1? -> 2?" in short and "waiting 40 s 1? -> 2?" in long
    (tight,) = (text_of(fleet_table(standing(40.0), R0, 40).rows[0].runs).rstrip() for _ in "1")
    assert tight.endswith("waiting 40 s -> 2?")


@pytest.mark.parametrize(
    ("percent", "bar"), [(100.0, "━━━━━"), (50.0, "━━━┄┄"), (4.0, "━┄┄┄┄"), (250.0, "━━━━━")]
)
def test_a_wide_pane_has_the_battery_as_a_bar(percent: float, bar: str) -> None:
    state = received(battery(T0 + 1, percent))
    assert f"% {bar}" in row(state)
    assert "━" not in text_of(fleet_table(state, R0, 60).rows[0].runs)
    assert (role_of(state, "━") is StyleRole.ALARM) == (percent < 20)


def test_an_idle_robot_with_a_low_battery_has_the_sign_and_a_calm_state() -> None:
    state = received(battery(T0 + 1, 5.0))
    assert row(state).startswith("▲") and role_of(state, "idle") is StyleRole.DIM


def test_a_robot_whose_alarms_are_acknowledged_has_their_sign_and_no_red() -> None:
    state = received(battery(T0 + 1, 5.0))
    assert role_of(state, "▲") is StyleRole.ALARM and role_of(state, "5 %") is StyleRole.ALARM
    seen = reduced(state, desk_events.AlarmAcknowledged())
    assert row(seen).startswith("△") and StyleRole.ALARM not in {role for _, role in runs(seen)}
    worse = reduced(seen, events.ObstacleReported(R0, T0 + 1.2, 99.0), tick(T0 + 1.3))
    assert row(worse).startswith("▲") and role_of(worse, "obstacle") is StyleRole.ALARM


def test_robots_behind_a_lost_link_whose_alarm_is_acknowledged_are_not_red() -> None:
    lost = reduced(received(), link_lost(T0 + 2), tick(T0 + 20))
    assert role_of(lost, "○") is StyleRole.ALARM
    seen = reduced(lost, desk_events.AlarmAcknowledged())
    assert row(seen).startswith("○") and role_of(seen, "offline") is StyleRole.TEXT


def test_a_stuck_robot_says_so_in_the_colour_of_alarms() -> None:
    state = received(queue(T0, (1, 1, 2, "W"), current=1))
    for second in range(70):
        at = T0 + second
        state = reduced(state, pose(at), battery(at), queue(at, (1, 1, 2, "W"), current=1), tick(at))
    assert "stuck" in row(state) and role_of(state, "stuck") is StyleRole.ALARM


@pytest.mark.parametrize("seconds", [3.1, 10.0, 31.0])
def test_an_obstacle_is_red_before_it_is_an_alarm(seconds: float) -> None:
    state = received(events.ObstacleReported(R0, T0 + 1, seconds))
    assert role_of(state, "obstacle") is StyleRole.ALARM and bool(state.alarms) is (seconds > 30.0)


def shown(state: FleetState, typed: str, column: str = "") -> list[object]:
    chosen = RowArrangement()
    chosen.typed, chosen.column = typed, column
    return list(fleet_table(state, R0, WIDTH, chosen).keys)


def test_a_filter_finds_robots_by_what_their_rows_say() -> None:
    named = (graph(1, 2), labels({1: "Base", 2: "Store"}))
    state = reduced(fleet(3, 2), link_up(T0), *named, queue(T0, (4, 1, 2, "W"), current=4))
    state = reduced(state, battery(T0, 55.0), battery(T0, 90.0, robot="robot_1"), tick(T0))
    assert shown(state, "") == [R0, "robot_1", "robot_2"]
    assert shown(state, "store") == [R0] == shown(state, "order:base")
    assert shown(state, "2") == ["robot_2"]
    assert shown(state, "55") == [], "a number is rather a robot than its battery"
    assert shown(state, "never") == ["robot_2"] == shown(state, "battery:-")
    assert shown(state, "kind:oh !robot_1") == [R0, "robot_2"]
    assert shown(state, "", "battery") == [R0, "robot_1", "robot_2"]
    nothing = RowArrangement()
    nothing.typed = "nobody"
    table = fleet_table(state, R0, WIDTH, nothing)
    assert text_of(table.title) == "Fleet /nobody: 0" and table.empty == NO_MATCH


def test_any_robot_of_500_is_found_by_its_number() -> None:
    state = fleet(500)
    assert all(f"robot_{n}" in shown(state, str(n)) for n in (7, 137, 499))
    assert shown(state, "137") == ["robot_137"]


def test_a_refused_order_is_not_told_beside_the_one_that_is_driven() -> None:
    refused = commanded(1, place_order(R0, 1, 2), Stage.SENT, Stage.REFUSED)
    state = received(queue(T0 + 1, (4, 3, 4, "W"), current=4), *refused, tick(T0 + 2))
    narrow = text_of(fleet_table(state, R0, 46).rows[0].runs)
    assert "refused: order" in narrow and "-> 4" not in narrow


def test_a_long_state_takes_the_cells_that_its_order_leaves() -> None:
    facts = events.PausedReported(R0, T0 + 1, True), tick(T0 + 2)
    line = text_of(fleet_table(received(*facts), R0, 72).rows[0].runs)
    assert "paused (elsewhere)" in line and len(line.rstrip()) <= 72


def test_jumps_of_a_pose_are_no_movement() -> None:
    order = queue(T0 + 1, (1, 1, 2, "W"), current=1)
    jumps = [pose(T0 + n, 20.0 * (n % 2)) for n in range(5)]
    calm = pose(T0 + 4, robot="robot_1")
    state = reduced(fleet(2), link_up(T0 - 9), order, calm, *jumps, tick(T0 + 4))
    table = fleet_table(state, "robot_1", WIDTH)
    first = table.rows[0]
    assert first.key == R0 and "pose jumps" in text_of(first.runs) and "driving" not in text_of(first.runs)
    assert first.runs[0] == ("● ", StyleRole.WARN)
    assert "1 waiting, 1 driving" in text_of(table.title)


def test_a_robot_whose_order_failed_is_not_called_idle() -> None:
    text = Message("order 1 -> 2 failed (a stop was missed)")
    alarm = Alarm(Condition(R0, "order", Priority.MEDIUM, text, text), 0.0, 0.0, T0)
    state = replace(received(), alarms=(alarm,))
    assert "order 1 -> 2 failed" in text_of(fleet_table(state, R0, 150).rows[0].runs)
    assert "order 1 -> 2 failed" in row(state) and "idle" not in row(state)
    assert role_of(state, "failed") is StyleRole.ALARM
    assert "order failed" in text_of(fleet_table(state, R0, 42).rows[0].runs)
