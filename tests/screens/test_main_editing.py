"""The graph editor by its keys, on a real console."""

import pytest

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console, console
from tests.support.watched_store import config_of


def drawn(it: Console) -> tuple[int, int]:
    draft = it.app.main.rest.editor.draft
    assert draft is not None
    return len(draft.floor.vertices), len(draft.floor.edges)


async def test_its_keys_take_precedence_on_the_map_and_nothing_reaches_the_robots(
    server: RosbridgeServer,
) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("E")
        await it.shows("EDIT", "map")
        await it.shows("vertex", "hints")
        vertices, edges = drawn(it)
        await it.press("i", "L", "e", "J", "e")
        assert drawn(it) == (vertices + 3, edges + 2)
        await it.press("m", "right", "enter", "t", "escape", "n")
        await it.type("Dock 7")
        await it.press("enter")
        await it.shows("Dock 7", "map")
        await it.press("d", "n", "escape", "u", "u", "u", "ctrl+r", "x")
        assert not it.store.state.commands
        assert not [
            one
            for one in it.app.main.query("Overlay")
            if one.display and one.id in ("confirm", "diagnostics")
        ]


async def test_the_pause_of_all_works_in_it(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("E", "P")
        await it.until(lambda state: len(state.commands) == 2)
        await it.press("f12")
        await it.until(lambda state: len(state.commands) == 4)


async def test_beside_the_map_the_console_keeps_its_keys_and_escape_leaves(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("E", "tab", "d")
        await it.shows("round trip")
        await it.press("escape", "escape")
        await it.shows("EDIT", "map")
        await it.press("g", "N", "}", "i")
        await it.shows("the draft is of floor_0")
        await it.press("{", "escape")
        await it.hides("EDIT")
        await it.press("d")
        await it.shows("round trip")


async def test_the_mouse_draws_too(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("E", "i")
        editor = it.app.main.rest.editor
        assert editor.draft is not None and editor.mode is not None
        (made,) = [v for v in editor.draft.floor.vertices.values() if v.id == editor.mode.selected]
        picture = it.app.main.rest.map.picture
        assert picture.scene is not None
        camera = picture.viewport.camera(picture.scene)
        x, y = camera.to_cell(*picture.scene.frame.to_pixel(made.x, made.y))
        await it.pilot.mouse_down("#map", offset=(x, y + 1))
        await it.pilot.hover("#map", offset=(x + 6, y + 3))
        await it.pilot.mouse_up("#map", offset=(x + 6, y + 3))
        await it.settled()
        moved = editor.draft.floor.vertices[made.id]
        assert moved.x > made.x and moved.y < made.y


@pytest.mark.parametrize("size", [(60, 16), (80, 24)])
async def test_small_screens_say_that_a_draft_is_edited(
    server: RosbridgeServer, size: tuple[int, int]
) -> None:
    async with console(config_of(server.url, 1, 1), size) as it:
        await it.press("E")
        await it.shows("EDIT", "map")
