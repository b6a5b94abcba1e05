"""Help in one to three columns: whole sections, keys in a column, nothing cut."""

import pytest

from fleet_tui.text.language import Message
from fleet_tui.ui.view.help.layout import THREE_FROM, TWO_FROM, help_lines
from fleet_tui.ui.view.help.pages import tasks
from fleet_tui.ui.view.help.section import HelpRow, HelpSection
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import width_of
from tests.support.fleets import text_of
from tests.support.kinds import KEYS

TASKS = tasks(KEYS, ())


def text(sections: list[HelpSection], width: int) -> list[str]:
    return [text_of(line) for line in help_lines(sections, width)]


@pytest.mark.parametrize("width", [40, 56, 76, TWO_FROM, 116, THREE_FROM, 171, 196])
def test_every_line_is_as_wide_as_wanted_and_no_word_is_missing(width: int) -> None:
    assert {width_of(line) for line in help_lines(TASKS, width)} == {width}
    words = " ".join(text(TASKS, width)).split()
    wanted = [word for section in TASKS for row in section.rows for word in row.text.split()]
    assert sorted(set(wanted) - set(words)) == []


def test_wide_help_fits_a_screen_of_120_by_40_and_narrow_help_three_of_80_by_24() -> None:
    two, one = text(TASKS, TWO_FROM), text(TASKS, 76)
    assert len(two) <= 31 and len(one) <= 52
    assert len(one) == sum(len(section.rows) + 1 for section in TASKS), "a text goes on in the next line"
    assert two[0].split("  ")[0] == TASKS[0].title and any(
        TASKS[-1].title in line and not line.startswith(TASKS[-1].title) for line in two
    )


def test_a_large_screen_has_three_columns_about_equally_high() -> None:
    three = text(TASKS, 196)
    assert len(three) <= sum(len(section.rows) + 2 for section in TASKS) / 3 + 4
    assert len(three) < len(text(TASKS, THREE_FROM - 1))
    for start in (0, 66, 132):
        assert three[0][start:].split("  ")[0] in {section.title for section in TASKS}


def test_long_texts_go_on_below_themselves() -> None:
    row = HelpRow((("Enter", StyleRole.KEY),), Message("one two three four five six"))
    assert [line.rstrip() for line in text([HelpSection(Message("T"), (row,))], 24)] == [
        "T",
        "  Enter  one two three",
        "         four five six",
    ]


def test_texts_without_a_mark_begin_at_the_left() -> None:
    assert text([HelpSection(Message("T"), (HelpRow((), Message("note")),))], 8) == ["T       ", "  note  "]
    assert text([], 8) == []
