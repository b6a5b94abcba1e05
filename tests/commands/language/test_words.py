"""Words of a line: quotes, separators, robots and vertices."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.commands.language.words import find_robot, quoted, said, tokens, vertex_of, word_of
from fleet_tui.text.errors import CommandError
from tests.support.fleets import R0, fleet, graph, labels, reduced

STATE = reduced(fleet(2), graph(1, 2, 7), labels({1: "Base", 2: "Far end"}))


def test_a_quoted_word_keeps_its_spaces() -> None:
    assert [token.text for token in tokens("goto robot_0 'Far end'")] == ["goto", "robot_0", "Far end"]
    assert [token.separates for token in tokens("a > b")] == [False, True, False]


@given(st.text("ab '\"->", min_size=1, max_size=6))
def test_a_quoted_text_is_one_word_as_far_as_possible(text: str) -> None:
    found = tokens(quoted(text))
    assert len(found) == 1 or quoted(text) == text


def test_a_robot_is_its_name_or_number() -> None:
    assert find_robot("ROBOT_0", STATE).name == R0 and find_robot("robot_1", STATE).number == 2
    with pytest.raises(CommandError, match="did you mean robot_1"):
        find_robot("robot_l", STATE)


def test_a_vertex_is_its_label_or_id() -> None:
    robot = STATE.robots[R0]
    assert vertex_of(robot, "Base") == ("1", "floor_0") and vertex_of(robot, "id=7") == ("7", "")
    assert word_of(robot, "2") == '"Far end"' and word_of(robot, "7") == "7"
    assert len(said("x" * 99)) == 42
