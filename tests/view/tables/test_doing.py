"""What a robot does, in the one word of the screen."""

import pytest

from fleet_tui.model.events import ObstacleReported, PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.rules.history.activity import activities
from fleet_tui.view.tables.doing import OBSTACLE, count_word, counted, doing_text, told_text, word
from fleet_tui.view.tables.fleet import fleet_table
from tests.support.fleets import R0, T0, battery, fleet, link_up, pose, queue, reduced, text_of, tick

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


@pytest.mark.parametrize("said", SITUATIONS)
def test_title_row_and_page_have_the_same_word(said: str) -> None:
    state = SITUATIONS[said]
    robot, does = state.robots[R0], activities(state, state.robots.values()).get(R0)
    table = fleet_table(state, R0, 100)
    counted = count_word(state, robot, does)
    assert said.startswith(counted) and text_of(table.title).endswith(f": 1 {counted}")
    assert said in text_of(table.rows[0].runs) and told_text(state, robot) == said


def test_several_are_counted_in_the_plural() -> None:
    assert [counted(n, OBSTACLE) for n in (1, 2)] == ["1 obstacle", "2 obstacles"]


def test_seconds_are_told_of_who_stands_with_an_order_from_a_few_on() -> None:
    robot = standing().robots[R0]
    assert doing_text(robot, Activity.LOADING) == "loading 40 s"
    assert doing_text(robot, Activity.IDLE) == "idle" and doing_text(robot, None) == word(None) == "unknown"


def test_a_row_never_ends_within_a_word_or_is_longer_than_its_pane() -> None:
    for state in SITUATIONS.values():
        shown = [text_of(fleet_table(state, R0, width).rows[0].runs) for width in range(44, 120)]
        assert all(len(row.rstrip()) <= width for width, row in enumerate(shown, 44))
        assert all("…" not in row for row in shown)
