"""Bars of activities."""

from fleet_tui.model.history.facts import Activity
from fleet_tui.ui.view.bars import BARS, bars_of, legend_of
from tests.support.fleets import text_of


def test_no_two_activities_look_alike_without_colours() -> None:
    assert set(BARS) == set(Activity)
    for kind in (0, 1):
        assert len({bar[kind] for bar in BARS.values()}) == len(Activity)


def test_a_bar_is_blank_where_nobody_watched_and_the_legend_names_what_is_shown() -> None:
    does = [Activity.DRIVING, None, Activity.BLOCKED, Activity.BLOCKED]
    assert [text for text, _ in bars_of(does, is_ascii=False)] == ["▆", " ", "██"]
    assert [text for text, _ in bars_of(does, is_ascii=True)] == ["=", " ", "BB"]
    assert text_of(legend_of([does], is_ascii=True)) == "  = driving  B blocked"
