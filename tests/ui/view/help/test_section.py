"""The search: words in any order, a title for all its rows, a single character for a key or a glyph."""

import pytest

from fleet_tui.text.language import Message
from fleet_tui.ui.view.help.section import HelpRow, HelpSection, key_row, search
from fleet_tui.ui.view.roles import StyleRole
from tests.support.fleets import text_of
from tests.support.kinds import KEYS

ROWS = (
    key_row(["pause_all", "pause_all_anywhere"], Message("Pause all robots"), KEYS, 1),
    key_row(["palette"], Message("Open the palette"), KEYS, 9),
    HelpRow((("o", StyleRole.VERTEX),), Message("a vertex"), ("⌂",)),
)
SECTIONS = (HelpSection(Message("Stop a robot"), ROWS[:1]), HelpSection(Message("Legend: places"), ROWS[1:]))


@pytest.mark.parametrize(
    ("wanted", "found"),
    [
        ("robots pause", [0]),
        ("STOP", [0]),
        ("legend", [1, 2]),
        ("legend vertex", [2]),
        ("P", [0]),
        ("p", []),
        ("⌂", [2]),
        ("ctrl-p", [1]),
        ("ctrl+p", [1]),
        ("pause_all", [0]),
        ("f12", [0]),
        ("zzz", []),
    ],
)
def test_what_is_typed_finds_rows(wanted: str, found: list[int]) -> None:
    sections = search(SECTIONS, wanted)
    assert [row for section in sections for row in section.rows] == [ROWS[at] for at in found]
    assert all(section.rows for section in sections)


def test_keys_are_named_as_people_write_them() -> None:
    assert [text_of(row.mark) for row in ROWS[:2]] == ["P F12", ": Ctrl-P"]
    assert {role for _, role in ROWS[0].mark} == {StyleRole.KEY}
    assert text_of(key_row(["record"], Message("Record"), KEYS, 1).mark) == "palette"
