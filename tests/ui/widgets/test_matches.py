"""Matches below a field: one is marked, unless none may be taken yet."""

from fleet_tui.ui.widgets.matches import Matches
from tests.support.widget_app import WidgetApp


async def test_the_mark_goes_round_and_begins_with_the_first() -> None:
    matches = Matches[int](id="matches")
    async with WidgetApp(matches).run_test():
        matches.show([1, 2, 3], ["one", "two", "[b]three"])
        assert matches.marked == 1
        for step, marked in ((1, 2), (1, 3), (1, 1), (-1, 3)):
            matches.step(step)
            assert matches.marked == marked
        assert str(matches.get_option_at_index(2).prompt) == "[b]three", "no markup"
        matches.show([4], ["four"], mark=None)
        assert matches.marked is None
        matches.show([], [])
        assert matches.marked is None
        assert not matches.can_focus


async def test_a_new_list_keeps_the_mark_on_its_item_or_marks_none() -> None:
    matches = Matches[int](id="matches")
    async with WidgetApp(matches).run_test():
        matches.show([1, 2], ["one", "two"], mark=1)
        assert matches.renew([3, 2], ["three", "two"]) and matches.marked == 2
        assert not matches.renew([3, 4], ["three", "four"]) and matches.marked is None
        assert matches.renew([5], ["five"]) and matches.marked is None


async def test_a_long_line_is_cut_before_its_key() -> None:
    matches = Matches[int](id="matches")
    async with WidgetApp(matches).run_test(size=(30, 10)) as pilot:
        await pilot.pause()
        matches.show([1], ["go to the next robot in trouble, whatever its floor"], keys=["!"])
        shown = str(matches.get_option_at_index(0).prompt)
        assert shown.endswith(" !") and "…" in shown
        assert len(shown) < 30
