"""Matches below a field: one is marked, unless none may be taken yet."""

from fleet_tui.widgets.matches import Matches
from tests.support.widget_app import WidgetApp


async def test_the_mark_goes_round_and_begins_with_the_first() -> None:
    matches = Matches(id="matches")
    async with WidgetApp(matches).run_test():
        matches.show(["one", "two", "[b]three"])
        assert matches.marked == 0
        for step, marked in ((1, 1), (1, 2), (1, 0), (-1, 2)):
            matches.step(step)
            assert matches.marked == marked
        assert str(matches.get_option_at_index(2).prompt) == "[b]three", "no markup"
        matches.show(["four"], mark=False)
        assert matches.highlighted is None and matches.marked == 0
        matches.show([])
        assert matches.highlighted is None
        assert not matches.can_focus


async def test_a_long_line_is_cut_before_its_key() -> None:
    matches = Matches(id="matches")
    async with WidgetApp(matches).run_test(size=(30, 10)) as pilot:
        await pilot.pause()
        matches.show(["go to the next robot in trouble, whatever its floor"], keys=["!"])
        shown = str(matches.get_option_at_index(0).prompt)
        assert shown.endswith(" !") and "…" in shown
        assert len(shown) < 30
