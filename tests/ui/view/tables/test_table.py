"""Rows of a table: whatever anybody says, they stay as wide as they should."""

from collections.abc import Iterable

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.counters import Raw, TopicCounter
from fleet_tui.model.ros_logs import LogLine, PartDiagnosis, Severity
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.diagnostics.console import OwnFacts, console_table
from fleet_tui.ui.view.tables.diagnostics.health import health_table
from fleet_tui.ui.view.tables.diagnostics.links import link_table
from fleet_tui.ui.view.tables.diagnostics.raw_message import raw_table
from fleet_tui.ui.view.tables.diagnostics.robot_log import lines_of, robot_log_table
from fleet_tui.ui.view.tables.diagnostics.topics import topic_table
from fleet_tui.ui.view.tables.table import Run, Table, column, cut, width_of
from tests.support.diagnostics import NOW, counter, seen
from tests.support.fleets import LINK, T0, fleet, link_lost, reduced
from tests.support.hostile_text import TEXTS, WIDTHS, harmless


def tables(words: str) -> Iterable[Table]:
    link = counter()
    topic = TopicCounter(words, words, words)
    link.topics[words] = topic
    raw = Raw(words.encode(errors="replace"), False, T0, 9)
    topic.failed(words, raw)
    topic.not_subscribed = words
    link.failed(words, b"", True, T0)
    link.opened()
    link.lost(words, T0)
    link.take_log(LogLine(T0, 4, words, words))
    link.take_health([PartDiagnosis(T0, words, 1, words, words, ((words, words),))])
    state, links = seen(link, reduced(fleet(2), link_lost(T0, words)))
    arrangement = RowArrangement()
    arrangement.typed = words
    yield link_table(links, NOW, arrangement=arrangement)
    yield topic_table(state, links, NOW, arrangement=arrangement)
    yield raw_table(topic, raw, words, NOW)
    yield robot_log_table(lines_of(links), links, state, str, Severity.DEBUG)
    yield health_table(links, {(LINK, words)}, NOW)
    yield console_table(OwnFacts(0.1, None, None, 0.0, 0.0, 0, None, None, 1, "1 s"), [words])


@given(TEXTS)
def test_nothing_that_anybody_says_bends_a_row(words: str) -> None:
    for table in tables(words):
        lines: list[tuple[Run, ...]] = [table.title, *(one.runs for one in table.rows)]
        for runs in lines:
            assert all(harmless(part) for part, _ in runs)
            for width in WIDTHS:
                assert width_of(cut(runs, width)) == width


RUNS = st.lists(
    st.tuples(
        st.text(st.characters(categories=["L", "N", "Mn", "So"]), max_size=9), st.sampled_from(StyleRole)
    )
)


@given(RUNS, st.integers(0, 60))
def test_cut_takes_exactly_its_cells_and_keeps_the_beginning(runs: list[Run], cells: int) -> None:
    shown = cut(runs, cells)
    assert width_of(shown) == cells
    if width_of(runs) < cells:  # marks without a width, once all cells are taken, may go
        assert "".join(text for text, _ in shown).rstrip(" ") == "".join(text for text, _ in runs)


@given(st.lists(TEXTS), st.integers(0, 10), st.integers(10, 30))
def test_a_column_holds_its_texts_within_its_limits(texts: list[str], least: int, most: int) -> None:
    width = column(texts, least, most)
    assert least <= width <= most
    assert width == most or all(width_of([(text, StyleRole.TEXT)]) <= width for text in texts)
