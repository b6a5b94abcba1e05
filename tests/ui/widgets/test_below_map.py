"""Below the map are the last events, and small maps or activities where there are cells for both."""

from textual.app import App, ComposeResult

from fleet_tui.ui.view.layout import LEAST_SHARED
from fleet_tui.ui.widgets.panes import BelowMap
from tests.support.planted_console import planted

LARGE = (200, 60)


class Below(App[None]):
    """The place alone."""

    def compose(self) -> ComposeResult:
        yield BelowMap(is_ascii=False)


async def test_it_has_the_lines_that_are_left_and_says_when_they_change() -> None:
    app = Below()
    async with app.run_test() as pilot:
        below = app.query_one(BelowMap)
        assert below.take(6) and not below.take(6)
        await pilot.pause()
        assert below.size.height == 6
        assert below.take(0) and not below.display


async def test_activities_are_beside_the_last_events_only_where_both_have_cells() -> None:
    app = Below()
    async with app.run_test():
        below = app.query_one(BelowMap)
        shown = []
        for has_maps, cells in ((False, LEAST_SHARED), (False, LEAST_SHARED - 1), (True, LEAST_SHARED)):
            below.divide(has_maps, cells)
            shown.append((below.maps.display, below.activity.rows.display))
        assert shown == [(False, True), (False, False), (True, False)]


async def test_a_large_screen_shows_what_the_robots_did_below_a_map_without_other_floors_there() -> None:
    async with planted(2, 2, LARGE) as it:
        await it.shows("robot_1", "activity")
        activity, recent = (it.app.main.query_one(name) for name in ("#activity", "#recent"))
        assert activity.size.height == recent.size.height and recent.region.right <= activity.region.x


async def test_small_maps_in_its_place_and_small_screens_have_none() -> None:
    for robots, size in ((30, LARGE), (2, (120, 40)), (2, (80, 24))):
        async with planted(robots, 2, size) as it:
            await it.shows("Fleet")
            await it.until(lambda _: not it.app.main.query_one("#activity").size.height)
