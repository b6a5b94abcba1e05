"""The panes share the lines of the screen, and one can have the whole column."""

import pytest
from textual.widget import Widget

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console, console
from tests.support.planted_console import planted
from tests.support.watched_store import config_of

BESIDE = {"map": 25, "recent": 12, "fleet": 15, "alarms": 3, "queue": 3, "page": 16}
"""Lines at 120x40."""


def _is_shown(pane: Widget) -> bool:
    return all(one.display for one in pane.ancestors_with_self if isinstance(one, Widget))


def heights(it: Console) -> dict[str, int]:
    panes = ("map", "simple", "fleet", "alarms", "queue", "page", "recent")
    shown = {pane.id: pane for name in panes for pane in it.app.main.query(f"#{name}")}
    return {name or "": pane.size.height for name, pane in shown.items() if _is_shown(pane)}


async def test_each_pane_has_what_its_rows_need_and_the_robots_page_the_rest(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 12), (120, 40), wait=False) as it:
        await it.until(lambda _: it.app.main.is_complete)
        await it.until(lambda _: heights(it) == BESIDE)
    async with console(config_of(server.url, 12), (80, 24), wait=False) as it:
        await it.until(lambda _: it.app.main.is_complete)
        await it.until(
            lambda _: heights(it) == {"map": 17, "recent": 2, "queue": 2, "fleet": 15, "alarms": 6}
        )


async def test_a_small_screen_has_the_robots_page_below_its_tables() -> None:
    async with planted(2, 1, (80, 24)) as it:
        below = {"map": 17, "recent": 2, "queue": 2}
        await it.until(lambda _: heights(it) == {**below, "fleet": 5, "alarms": 3, "page": 13})
        await it.shows("0 s", "page")
        assert "…" not in it.pane("page")


@pytest.mark.parametrize("size", [(80, 24), (120, 40), (200, 60)])
async def test_a_dialog_about_the_map_has_one_place_and_moves_nothing(size: tuple[int, int]) -> None:
    async with planted(2, 1, size) as it:
        await it.shows_a_label()
        await it.until(lambda _: "recent" in heights(it))
        await it.settled()
        shown, why, form, fleet = (
            it.app.main.query_one(name) for name in ("#map", "#why", "#order-form", "#fleet")
        )
        before, boxes = (shown.region, fleet.region), set()
        for robot in ("1", "2"):
            await it.press(robot, "w")
            boxes.add(why.region)
            it.app.main.tick()
            await it.press("escape", "o")
            assert form.region and not shown.region.overlaps(form.region)
            assert (shown.region, fleet.region) == before
            await it.press("escape")
        (box,) = boxes
        assert box.height >= 9 and not shown.region.overlaps(box)


async def test_thirty_robots_have_twenty_four_rows_or_more() -> None:
    async with planted(30, 1, (120, 40)) as it:
        assert heights(it)["fleet"] >= 24 + 2


async def test_the_focused_pane_takes_the_column_and_gives_it_back() -> None:
    async with planted(12, 1, (120, 40)) as it:
        await it.until(lambda _: heights(it) == BESIDE)
        await it.press("tab", "=")
        await it.until(lambda _: heights(it) == {"map": 37, "fleet": 37})
        await it.press("=")
        await it.until(lambda _: heights(it) == BESIDE)
        await it.press("escape", "=")
        await it.hides("Fleet")
        assert it.app.main.query_one("#map").size.width == 120
        await it.press("escape")
        await it.shows("Fleet")


async def test_a_screen_without_a_map_has_as_many_robots_as_fit() -> None:
    async with planted(12, 1, (60, 15)) as it:
        assert heights(it) == {"fleet": 10, "alarms": 2}
        await it.press("tab", "=")
        await it.until(lambda _: heights(it) == {"fleet": 12})
        await it.press("=", "s")
        await it.until(lambda _: heights(it) == {"simple": 9, "alarms": 3})


async def test_the_simple_interface_shows_its_four_buttons() -> None:
    async with planted(12, 1, (80, 24)) as it:
        await it.press("s")
        await it.until(
            lambda _: heights(it) == {"simple": 13, "map": 13, "fleet": 5, "alarms": 3, "queue": 3}
        )
    async with planted(12, 1, (80, 16)) as it:
        await it.press("s")
        await it.until(lambda _: heights(it) == {"simple": 6, "fleet": 4, "alarms": 3, "queue": 3})
        assert it.app.main.query_one("#simple-send").region.bottom <= 8


async def test_an_enlarged_pane_leaves_the_simple_interface_in_place() -> None:
    async with planted(12, 1, (120, 40)) as it:
        await it.press("s")
        it.app.main.fleet.focus()
        await it.press("=")
        await it.until(lambda _: heights(it) == {"simple": 17, "map": 19, "fleet": 37})


async def test_an_enlarged_pane_gives_way_to_the_order_form_and_its_map() -> None:
    async with planted(12, 1, (80, 24)) as it:
        await it.press("tab", "=")
        await it.until(lambda _: heights(it) == {"fleet": 21})
        await it.press("o")
        shown, form = (it.app.main.query_one(name) for name in ("#map", "#order-form"))
        await it.until(lambda _: heights(it).get("map", 0) >= 9 and shown.region.right <= form.region.x)
        await it.press("escape")
        await it.until(lambda _: heights(it) == {"fleet": 21})
