"""Records of the audit log as rows and in full."""

from hypothesis import given

from fleet_tui.features.audit.page import audit_table, details
from fleet_tui.records.audit.line import line_text, what_text
from fleet_tui.ui.view.roles import StyleRole
from tests.support.fleets import text_of
from tests.support.hostile_text import TEXTS, harmless
from tests.support.records import record


def test_a_record_is_a_line_with_who_and_what() -> None:
    one = record("queue full")
    assert line_text(one).endswith(f": {one.change} (queue full)")
    assert what_text(one) in line_text(one) and one.operator in line_text(one)


def test_rows_stand_in_the_sequence_given() -> None:
    table = audit_table([record("one"), record("two")], note="newest first", empty="none")
    assert text_of(table.title) == "Audit log newest first"
    assert [text_of(row.runs).rsplit(" (", 1)[1] for row in table.rows] == ["one)", "two)"]
    assert audit_table([], empty="no record").empty == "no record"


def test_trouble_is_seen_by_its_role() -> None:
    roles = {role for text, role in audit_table([record("x")]).rows[0].runs if text.startswith(": ")}
    assert roles <= {StyleRole.ALARM, StyleRole.GOOD, StyleRole.WARN, StyleRole.TEXT}


@given(TEXTS)
def test_nothing_that_anybody_said_acts_on_the_terminal(words: str) -> None:
    one = record(words)
    assert all(harmless(text) for text in (line_text(one), what_text(one), *details(one)))
    assert all(harmless(text) for text, _ in audit_table([one], words, words).rows[0].runs)
