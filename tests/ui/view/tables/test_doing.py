"""What a robot does, in the one word of the screen."""

from typing import Any

import pytest
from msgspec.structs import replace

from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.events import Event, ObstacleReported, PausedReported
from fleet_tui.model.fleet import FleetState, with_robot
from fleet_tui.model.fleets.member import Member
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.navigation_events import BlockedReported
from fleet_tui.model.robot import Reading
from fleet_tui.model.vehicles.events import VehicleReported
from fleet_tui.model.vehicles.vehicle import Vehicle, VehicleError
from fleet_tui.situation.activity import OBSTRUCTED, activities
from fleet_tui.situation.alarms.trouble import waits
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from fleet_tui.ui.languages import ENGLISH, use_language
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.map.glyphs import robot_tag
from fleet_tui.ui.view.selection import Selection
from fleet_tui.ui.view.tables.doing import count_text, count_word, doing_text, told_text, word
from fleet_tui.ui.view.tables.fleet import fleet_table
from tests.support.fleets import F0, R0, T0, battery, fleet, link_up, pose, queue, reduced, text_of, tick

AT = T0 + 40.0


def standing(*facts: ObstacleReported | PausedReported, ordered: bool = True) -> FleetState:
    orders = ((1, 1, 2, "W"),) if ordered else ()
    listed = queue(AT, *orders, current=int(ordered))
    return reduced(fleet(), link_up(T0 - 9), pose(T0), pose(AT), battery(AT), listed, *facts, tick(AT))


SITUATIONS = {
    "waiting 40 s": standing(),
    "idle": standing(ordered=False),
    "obstacle 9.0 s": standing(ObstacleReported(R0, AT, 9.0)),
    "paused (elsewhere)": standing(PausedReported(R0, AT, True)),
    "unknown": reduced(fleet(), link_up(AT), queue(AT, (1, 1, 2, "W"), current=1), tick(AT)),
}


def test_one_that_stood_idle_before_its_order_has_waited_since_that_was_begun() -> None:
    idle = standing(ordered=False)
    ordered = reduced(idle, queue(AT + 1, (1, 1, 2, "W"), current=1), pose(AT + 8), tick(AT + 8))
    robot = ordered.robots[R0]
    assert doing_text(ordered, robot, Activity.WAITING) == "waiting 7 s"
    assert not waits(ordered, robot)
    later = reduced(ordered, queue(AT + 31, (1, 1, 2, "W"), current=1), pose(AT + 32), tick(AT + 32))
    assert waits(later, later.robots[R0])


def vehicle(**state: Any) -> VehicleReported:
    return VehicleReported(R0, AT, Vehicle("a", "2.0.0", **state))


BLOCKED: dict[str, tuple[str, Event]] = {
    "blocked 4.0 s (seen)": ("1 blocked", BlockedReported(R0, AT - 4.0, "stop", "front")),
    "e-stop (manual)": ("1 e-stop", vehicle(e_stop="MANUAL")),
    "motor": ("1 error", vehicle(errors=(VehicleError("motor", "FATAL"),))),
}


@pytest.mark.parametrize("said", BLOCKED)
def test_who_cannot_drive_is_counted_by_the_word_of_its_row_and_blocked_on_the_map(said: str) -> None:
    count, report = BLOCKED[said]
    state = reduced(standing(ordered=False), report, tick(AT))
    robot = state.robots[R0]
    assert activities(state, [robot]) == {R0: Activity.BLOCKED}
    table = fleet_table(state, R0, 100)
    assert text_of(table.title).endswith(f": {count}")
    row = text_of(table.rows[0].runs)
    assert said in row and "idle" not in row and row.count("blocked") == said.count("blocked")
    drawn = floor_scene(state, Selection(R0, F0)).robots[0]
    assert "!" in robot_tag(drawn, plain=True)


def test_the_type_of_an_error_is_its_makers_word_in_every_language() -> None:
    state = reduced(standing(ordered=False), vehicle(errors=(VehicleError("no pose", "FATAL"),)), tick(AT))
    use_language("de")
    try:
        row = text_of(fleet_table(state, R0, 100).rows[0].runs)
    finally:
        use_language(ENGLISH)
    assert "no pose" in row


def test_an_emergency_of_a_fleet_and_an_issue_are_told_in_the_row() -> None:
    robot = standing(ordered=False).robots[R0]
    for member, does in (
        (Member(mode=Message("emergency")), "blocked"),
        (Member(issues=("lift_1 silent",)), "idle"),
    ):
        known = replace(robot, member=Reading(member, AT))
        state = reduced(with_robot(standing(ordered=False), known), tick(AT))
        table, said = fleet_table(state, R0, 100), member.mode or member.issues[0]
        assert text_of(table.title).endswith(f": 1 {does}")
        assert said in text_of(table.rows[0].runs) and does not in text_of(table.rows[0].runs)


@pytest.mark.parametrize("said", SITUATIONS)
def test_title_row_and_page_have_the_same_word(said: str) -> None:
    state = SITUATIONS[said]
    robot, does = state.robots[R0], activities(state, state.robots.values()).get(R0)
    table = fleet_table(state, R0, 100)
    counted = count_word(state, robot, does)
    assert said.startswith(counted) and text_of(table.title).endswith(f": 1 {counted}")
    assert said in text_of(table.rows[0].runs) and told_text(state, robot) == said


def test_several_are_counted_in_the_plural() -> None:
    assert [count_text(n, OBSTRUCTED) for n in (1, 2)] == ["1 obstacle", "2 obstacles"]


def test_the_count_of_robots_has_the_number_of_its_language() -> None:
    use_language("de")
    try:
        texts = [count_text(count, Activity.DRIVING.value) for count in (1, 2)]
    finally:
        use_language(ENGLISH)
    assert texts == ["1 fährt", "2 fahren"]
    assert [count_text(2, does.value) for does in Activity] == [f"2 {does.value}" for does in Activity]


def test_seconds_are_told_of_who_stands_with_an_order_from_a_few_on() -> None:
    state = standing()
    robot = state.robots[R0]
    assert doing_text(state, robot, Activity.LOADING) == "loading 40 s"
    assert doing_text(state, robot, Activity.IDLE) == "idle"
    assert doing_text(state, robot, None) == word(None) == "unknown"


def test_a_row_never_ends_within_a_word_or_is_longer_than_its_pane() -> None:
    for state in SITUATIONS.values():
        shown = [text_of(fleet_table(state, R0, width).rows[0].runs) for width in range(44, 120)]
        assert all(len(row.rstrip()) <= width for width, row in enumerate(shown, 44))
        assert all("…" not in row for row in shown)


def test_a_shelved_obstacle_is_said_once_in_each_language() -> None:
    state = standing(ObstacleReported(R0, AT, 40.0))
    alarms = tuple(replace(alarm, stage=AlarmStage.SHELVED) for alarm in state.alarms)
    assert alarms
    state = replace(state, alarms=alarms)
    for language in (ENGLISH, "de", "pt"):
        use_language(language)
        try:
            row = text_of(fleet_table(state, R0, 100).rows[0].runs)
        finally:
            use_language(ENGLISH)
        assert row.count("40 s") == 1, row


def test_an_emergency_stop_comes_before_an_obstacle_in_row_title_and_reasons() -> None:
    contact = ObstacleReported(R0, AT, 9.0)
    state = reduced(standing(contact, ordered=False), vehicle(e_stop="MANUAL"), tick(AT))
    table = fleet_table(state, R0, 100)
    assert text_of(table.title).endswith(": 1 e-stop")
    row = text_of(table.rows[0].runs)
    assert row.index("e-stop (manual)") < row.index("obstacle 9.0 s")
    assert reasons(state, state.robots[R0])[0].name == "e-stop (manual)"
