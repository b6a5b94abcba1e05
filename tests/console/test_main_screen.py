"""The main screen: what it shows of a real fleet, and its keys."""

import re

import pytest
from msgspec.structs import replace

from fleet_tui.config.start import extended
from fleet_tui.ui.view.lines.commands import READ_AFTER
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.fleets import place_order
from tests.support.planted_console import SITE, planted
from tests.support.situations import BASE, CONSUMIDORES
from tests.support.watched_store import config_of


@pytest.mark.parametrize("size", [(120, 40), (80, 24)])
async def test_every_pane_is_in_view(size: tuple[int, int]) -> None:
    async with planted(2, 2, size) as it:
        text = it.text
        for word in ("floor_0", "Fleet", "Alarms", "Queue robot_0", "robot_1", "? ", "order", SITE):
            assert word in text
        assert "0 alarms" in text
        assert "▀▀▀" in it.pane("map")
        assert len(text.splitlines()) == size[1]


async def test_below_60_by_16_a_plain_list_stays_with_its_alarms() -> None:
    async with planted(2, 2) as it:
        await it.pilot.resize_terminal(59, 15)
        await it.hides("Queue")
        assert "Alarms" in it.text
        assert "robot_1" in it.text


@pytest.mark.parametrize("size", [(1, 1), (5, 3), (300, 90)])
async def test_any_size_is_survived(size: tuple[int, int]) -> None:
    async with planted(2, 2) as it:
        await it.pilot.resize_terminal(*size)
        it.app.main.tick()
        await it.pilot.resize_terminal(120, 40)
        await it.shows("Queue robot_0")


async def test_robots_are_chosen_by_step_and_number() -> None:
    async with planted(2, 2) as it:
        for keys, robot in (("]", "robot_1"), ("]", "robot_0"), ("1", "robot_1"), ("[", "robot_0")):
            await it.press(keys)
            await it.shows(f"Queue {robot}", "queue")
            (marked,) = [line for line in it.pane("fleet").splitlines() if line.startswith("▸")]
            assert robot in marked
        await it.press("9")
        assert it.app.main.navigation.robot == "robot_0"


async def test_floors_step_and_the_map_says_where_the_robot_is() -> None:
    async with planted(2, 2) as it:
        await it.press("}")
        await it.shows("floor_1 ", "map")
        await it.shows("robot_0 is on floor_0", "map")
        await it.press("f")
        await it.shows("floor_0 ", "map")
        await it.shows("follow on", "map")
        await it.press("f", "{")
        await it.shows("robot_0 is on floor_0", "map")


async def test_the_maps_keys_work_from_every_pane() -> None:
    async with planted(2, 2) as it:
        await it.press("tab", "tab", "m")
        assert it.app.main.features.map.picture.options.drawing is Drawing.HALF_BLOCK
        await it.press("m")
        await it.shows("####", "map")
        before = it.pane("map")
        await it.press("+")
        assert it.pane("map") != before
        await it.press("-", "z", "e", "v", "c", "0", "n", "N", "g", "escape")
        await it.press("left", "h", "right", "l", "up", "k", "down", "j")


async def test_the_palette_goes_to_things_and_does_actions() -> None:
    async with planted(2, 2) as it:
        await it.press("colon")
        await it.type("go to robot robot_1")
        await it.press("enter")
        await it.shows("Queue robot_1", "queue")


async def test_the_palette_does_what_a_key_would() -> None:
    async with planted() as it:
        await it.press("colon")
        await it.type("toggle edges")
        await it.press("enter")
        await it.until(lambda _: it.app.main.features.map.picture.options.edges)


async def test_themes_change_at_once() -> None:
    async with planted() as it:
        title = it.app.main.features.map.render_line(0)
        it.app.main.settings.themes["light"]()
        assert it.app.main.features.map.render_line(0) != title
        assert it.app.theme == "fleet-light"


async def test_an_alarm_is_new_until_it_is_seen() -> None:
    async with planted(2, 2) as it:
        # On a busy machine the link came late: that was an alarm, too.
        await it.press("A")
        await it.until(lambda state: not state.alarms)
        it.publish("/robot_0/obstacle", {"data": 44.2})
        await it.shows("obstacle 44 s", "alarms")
        await it.shows("obstacle 44 s", "fleet")
        await it.shows("1 alarm (1 new)")
        await it.press("a")
        await it.shows("1 alarm ")
        it.publish("/robot_0/obstacle", {"data": 0.0})
        await it.hides("obstacle 44 s")
        await it.shows("0 alarms")
        it.publish("/robot_0/obstacle", {"data": 49.0})
        await it.shows("obstacle 49 s", "alarms")
        await it.press("A")
        await it.hides("new)")


async def test_hostile_text_from_the_wire_stays_text() -> None:
    evil = "\x1b[31m[bold]x[/bold]\x07‮\u200b"
    async with planted() as it:
        vertices = it.store.state.robots["robot_0"].maps["floor_0"].labels
        labels = [{"label": label + evil, "vertex_id": int(id_)} for id_, label in vertices.items()]
        it.publish("/robot_0/floor_0/labeled_vertices", {"vertices": labels})
        orders = [{"id": 1, "start": 0, "end": 1, "status": evil}]
        it.fleet.server.bridge.muted.add("/robot_0/queue")
        queue = {"last_order_id": 1, "current_order_id": 1, "orders": orders}
        it.publish("/robot_0/queue", queue)
        await it.shows("[bold]x[/bold]", "queue")
        await it.press("o")
        await it.shows("[bold]")
        assert not {"\x1b", "\x07", "‮", "\u200b"} & set(it.text)


async def test_q_leaves() -> None:
    async with planted() as it:
        await it.press("q")
        assert not it.app.is_running


async def test_a_digit_chooses_the_robot_whose_name_ends_with_it() -> None:
    async with planted(2) as it:
        await it.press("1")
        await it.until(lambda _: it.app.main.navigation.robot == "robot_1")
        await it.press("2")
        await it.shows("no robot has the number 2: the fleet's column # shows them")
        assert it.app.main.navigation.robot == "robot_1"


async def test_enter_on_free_ground_tells_the_key_of_the_next_place() -> None:
    async with planted(config=replace(config_of(SITE, 1), keys={"next_vertex": "ctrl+n"})) as it:
        await it.press("g", "left", "enter")
        await it.shows("no place here: Ctrl-N goes to the next one", "message")
        await it.press("ctrl+n", "enter")
        await it.until(lambda _: it.app.main.features.order_form.is_open)


async def test_a_lost_link_leaves_the_time_and_the_next_try_in_view() -> None:
    async with planted(2, 2, (80, 24)) as it:
        it.lose_link()
        await it.shows("retry in")
        assert re.search(r" \d\d:\d\d:\d\d $", it.text.splitlines()[0])


async def test_all_paused_shows_the_way_back_at_80_columns_too() -> None:
    async with planted(2, 2, (80, 24)) as it:
        await it.press("P")
        await it.shows("ALL PAUSED, R resumes all")
        assert SITE in it.text.splitlines()[0]
        await it.press("R")
        await it.shows("robot_0, robot_1")
        await it.press("y")
        await it.hides("ALL PAUSED")


async def test_a_failed_command_leaves_the_last_line_with_the_next_key() -> None:
    async with planted(2, 1, (80, 24)) as it:
        it.fleet.plant("refuse")
        it.app.backend.submit(place_order("robot_0", CONSUMIDORES, BASE))
        await it.shows("refused", "message")
        await it.until(lambda state: state.now > state.commands[0].at + READ_AFTER)
        await it.press("]")
        await it.hides("refused", "message")
        assert "refused" in it.text, "its alarm stays"


async def test_a_robot_that_is_added_has_its_row_and_is_told() -> None:
    async with planted() as it:
        it.store.put(extended(it.store.state, config_of(SITE, 2)))
        await it.shows("added, as they appeared on the broker: robot_1", "message")
        await it.shows("robot_1", "fleet")
