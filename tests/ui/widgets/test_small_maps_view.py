"""Small maps of other floors on a large screen; none on a small one, none without other floors."""

from tests.support.planted_console import planted

LARGE = (200, 60)


async def test_a_large_screen_shows_the_other_floor_and_a_click_goes_there() -> None:
    async with planted(2, 2, LARGE) as it:
        await it.shows("─ floor_1 ── robot_1 ─", "other-floors")
        await it.shows("Laundry", "other-floors")
        await it.shows("State  ", "page")
        await it.pilot.click("#other-floors", offset=(5, 5))
        await it.shows("─ floor_1 ", "map")
        await it.shows("─ floor_0 ── robot_0 ─", "other-floors")


async def test_below_the_map_of_a_large_fleet_the_other_floor_is_beside_the_last_events() -> None:
    async with planted(30, 2, LARGE) as it:
        await it.shows("─ floor_1 ── 15 robots ─", "other-floors-below")
        below, recent = (it.app.main.query_one(name) for name in ("#other-floors-below", "#recent"))
        assert below.size.height == recent.size.height >= 14 and recent.region.right <= below.region.x
        assert not it.app.main.panes.small_maps.display
        await it.shows("State  ", "page")
        await it.press("tab", "=")
        await it.until(lambda _: not it.app.main.panes.has_small_maps)
        await it.press("=")
        await it.until(lambda _: it.app.main.panes.has_small_maps and below.region.height >= 14)
        await it.pilot.click("#other-floors-below", offset=(5, 5))
        await it.shows("─ floor_1 ", "map")
        await it.shows("─ floor_0 ── 15 robots ─", "other-floors-below")


async def test_neither_a_small_screen_nor_a_fleet_on_one_floor_has_small_maps() -> None:
    for floors, size in ((2, (80, 24)), (2, (120, 40)), (1, LARGE)):
        async with planted(2, floors, size) as it:
            await it.shows("Fleet")
            assert not it.app.main.panes.has_small_maps
