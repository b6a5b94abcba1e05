"""The last events of the fleet, the newest first."""

from msgspec import structs

from fleet_tui.model.commands import CancelOrder, PauseRobot, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued, ObstacleReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.language import Message
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.news import failed_command
from fleet_tui.ui.view.tables.recent import recent_table
from fleet_tui.ui.view.tables.selected_robot import robot_page
from tests.support.alarms import without_poses
from tests.support.fleets import (
    R0,
    T0,
    WALL,
    commanded,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    place_order,
    queue,
    reduced,
    text_of,
    tick,
)
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import node, state


def clock(wall: float) -> str:
    return f"{wall - WALL - T0:.0f}"


def lines(state: FleetState, most: int = 9) -> list[str]:
    return [" ".join(text_of(row.runs).split()) for row in recent_table(state, clock, most).rows]


NAMED = (graph(1, 2), labels({1: "Base", 2: "Store"}))
DRIVEN = reduced(fleet(), link_up(T0), *NAMED, queue(T0, (4, 1, 2, "W"), current=4), queue(T0 + 1))


def test_an_order_that_ended_has_a_line_with_the_time_of_its_end() -> None:
    assert recent_table(fleet(), clock, 9).empty == "nothing yet"
    assert lines(reduced(DRIVEN, tick(T0 + 2))) == [f"1 {R0} Base -> Store: lost"]


def test_a_narrow_pane_has_what_happened_first_and_times_without_seconds() -> None:
    state = reduced(DRIVEN, tick(T0 + 2))
    (row,) = recent_table(state, lambda _wall: "12:04:31", 9, width=38).rows
    assert " ".join(text_of(row.runs).split()) == f"12:04 {R0} lost -> Store"


def test_a_narrow_pane_does_not_tell_who_gave_an_order_without_a_start() -> None:
    site = VehicleSite()
    site.read("state", state())
    site.read("state", state(orderId="theirs", nodeStates=[node("a", 2)], driving=True))
    for width, told in ((38, "started -> a?"), (80, "-> a? (elsewhere): started")):
        rows = recent_table(site.state, clock, 9, width).rows
        assert any(text_of(row.runs).rstrip().endswith(told) for row in rows), [text_of(r.runs) for r in rows]


def test_a_failure_that_is_an_alarm_is_told_once() -> None:
    given = commanded(1, place_order(R0, 1, 2), Stage.SENT, Stage.ACCEPTED, at=T0)
    listed = reduced(fleet(), link_up(T0), *NAMED, queue(T0 - 1), *given)
    driven = reduced(listed, queue(T0 + 1, (4, 1, 2, "W"), current=4), tick(T0 + 1))
    lost = lines(reduced(driven, queue(T0 + 2), tick(T0 + 2)))
    told = "lost: order Base -> Store (order 4: "
    assert [told in line for line in lost if "lost" in line] == [True]


def test_an_order_that_was_cancelled_here_is_not_lost() -> None:
    given = commanded(1, CancelOrder(R0, "4"), Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED, at=T0 + 0.5)
    listed = reduced(fleet(), link_up(T0), *NAMED, queue(T0, (4, 1, 2, "W"), current=4))
    state = reduced(listed, *given, queue(T0 + 1, (9, 1, 2, "Q")), tick(T0 + 2))
    assert f"1 {R0} Base -> Store: cancelled" in lines(state)
    refused = commanded(1, CancelOrder(R0, "4"), Stage.SENT, Stage.REFUSED, at=T0 + 0.5)
    state = reduced(listed, *refused, queue(T0 + 1, (9, 1, 2, "Q")), tick(T0 + 2))
    assert f"1 {R0} Base -> Store: done" in lines(state)


def test_the_newest_come_first_as_many_as_there_are_lines() -> None:
    issued, *steps = commanded(1, PauseRobot(R0), Stage.SENT, Stage.REFUSED)
    assert isinstance(issued, CommandIssued)
    state = reduced(DRIVEN, structs.replace(issued, wall=WALL + T0), *steps, tick(T0 + 2))
    refused = ["2 robot_0 refused: pause", "1 robot_0 Base -> Store: lost", "0 robot_0 pause: refused"]
    assert lines(state) == refused
    assert lines(state, 2) == lines(state)[:2]
    roles = [row.runs[-1][1] for row in recent_table(state, clock, 9).rows]
    assert roles == [StyleRole.ALARM, StyleRole.WARN, StyleRole.WARN]


def test_an_order_that_was_seen_to_begin_has_a_line_until_its_end() -> None:
    begun = queue(T0 + 1, (4, 1, 2, "W"), current=4)
    waits = reduced(fleet(), link_up(T0), *NAMED, queue(T0, (4, 1, 2, "Q")), tick(T0))
    assert lines(waits) == ["0 rosbridge connected"], "while there is nothing else"
    drives = reduced(waits, begun, queue(T0 + 2, (4, 1, 2, "W"), current=4), tick(T0 + 2))
    assert lines(drives) == ["1 robot_0 Base -> Store: started"]
    assert lines(reduced(drives, queue(T0 + 3), tick(T0 + 3))) == ["3 robot_0 Base -> Store: lost"]
    unseen = reduced(fleet(), link_up(T0), *NAMED, begun, tick(T0 + 2))
    assert lines(unseen) == ["0 rosbridge connected"], "when it began is not known"
    after_a_gap = reduced(waits, queue(T0 + 30, (4, 1, 2, "W"), current=4), tick(T0 + 30))
    assert not [line for line in lines(after_a_gap) if "started" in line]


def test_a_pause_of_several_robots_is_one_line() -> None:
    given = [event for n in range(3) for event in commanded(n + 1, PauseRobot(f"robot_{n}"), Stage.SENT)]
    stages = (Stage.ACCEPTED, Stage.CONFIRMED)
    ended = [CommandAdvanced(n + 1, stage, T0 + 1) for n in range(2) for stage in stages]
    state = reduced(fleet(3), link_up(T0), *given, *ended, tick(T0 + 2))
    (line,) = lines(state)
    assert "3 robots pause all: 2 confirmed, 1 open (robot_2)" in line


def test_an_alarm_reads_as_it_was_at_its_time() -> None:
    seen = [(ObstacleReported(R0, T0 + n, 40.0 + n), tick(T0 + n)) for n in range(90)]
    state = reduced(without_poses(fleet()), link_up(T0), *(event for both in seen for event in both))
    assert [alarm.text for alarm in state.alarms] == ["obstacle 2 min"]
    assert lines(state) == ["0 robot_0 obstacle 40 s"]


def test_an_alarm_whose_cause_came_later_names_it() -> None:
    state = reduced(without_poses(fleet()), link_up(T0), ObstacleReported(R0, T0, 40.0), tick(T0))
    (alarm,) = state.alarms
    unknown, known = "stuck for 60 s", "stuck for 70 s: drive: no odometry"
    condition = structs.replace(alarm.condition, text=known)
    state = structs.replace(state, alarms=(structs.replace(alarm, condition=condition, first_text=unknown),))
    assert lines(state) == [f"0 robot_0 {known}"]


def test_another_alarm_in_which_something_failed_is_whole() -> None:
    state = reduced(without_poses(fleet()), link_up(T0), ObstacleReported(R0, T0, 40.0), tick(T0))
    (alarm,) = state.alarms
    text = "motor: brake test failed: replace the brake"
    condition = structs.replace(alarm.condition, text=text)
    state = structs.replace(state, alarms=(structs.replace(alarm, condition=condition, first_text=text),))
    assert lines(state) == [f"0 robot_0 {text}"]


def test_the_return_of_a_link_stays_with_its_outage_after_its_alarm_is_gone() -> None:
    back = reduced(fleet(), link_up(T0), link_lost(T0 + 5), tick(T0 + 9), link_up(T0 + 27), tick(T0 + 60))
    assert not [alarm for alarm in back.alarms if alarm.condition.kind == "link"]
    assert "27 rosbridge link restored after 22 s" in lines(back)


def test_of_an_order_that_failed_the_alarm_alone_has_the_cause() -> None:
    given = commanded(1, place_order(R0, 1, 2), Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED, at=T0)
    end = CommandAdvanced(1, Stage.FAILED, T0 + 1, detail=Message("Failed to find a valid control"))
    failed = reduced(fleet(), link_up(T0), *NAMED, *given, end, tick(T0 + 2))
    told = "order Base -> Store failed"
    assert [alarm.text for alarm in failed.alarms] == [f"{told}: Failed to find a valid control"]
    line = next(one for one in lines(failed) if told in one)
    assert line.endswith(f"{R0} {told}")
    robot = failed.robots[R0]
    assert [text for text, _ in failed_command(failed, robot, short=True)] == ["order failed"]
    page = "\n".join(text_of(row.runs) for row in robot_page(failed, R0, 42, clock).rows)
    assert "order failed" in page and "Pose" in page and "valid control" not in page


def test_the_cause_at_the_end_of_an_event_goes_on_in_a_second_line() -> None:
    given = commanded(1, place_order(R0, 1, 2), Stage.SENT, Stage.ACCEPTED, at=T0)
    listed = reduced(fleet(), link_up(T0), *NAMED, queue(T0 - 1), *given)
    driven = reduced(listed, queue(T0 + 1, (4, 1, 2, "W"), current=4), tick(T0 + 1))
    lost = reduced(driven, queue(T0 + 2), tick(T0 + 2))
    rows = [text_of(row.runs) for row in recent_table(lost, clock, 9, 38).rows]
    assert max(map(len, rows)) <= 38 and "(order 4:" in " ".join(" ".join(rows).split())
    assert rows[1].startswith("  ") and len(recent_table(lost, clock, 1, 38).rows) == 1
