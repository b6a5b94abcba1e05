"""The graph editor by its keys, on a real console."""

import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import Stage
from fleet_tui.ui.controllers.files import ConsoleFiles
from tests.support.console_pilot import Console, console
from tests.support.nav2_site import Site
from tests.support.planted_console import planted


def drawn(it: Console) -> tuple[int, int]:
    draft = it.app.main.features.editing.editor.draft
    assert draft is not None
    return len(draft.floor.vertices), len(draft.floor.edges)


async def test_its_keys_take_precedence_on_the_map_and_nothing_reaches_the_robots() -> None:
    async with planted(2, 2) as it:
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


async def test_the_pause_of_all_works_in_it() -> None:
    async with planted(2, 2) as it:
        await it.press("E", "P")
        await it.until(lambda state: len(state.commands) == 2)
        await it.press("f12")
        await it.until(lambda state: len(state.commands) == 4)


async def test_beside_the_map_the_console_keeps_its_keys_and_escape_leaves() -> None:
    async with planted(2, 2) as it:
        await it.press("E", "tab", "d")
        await it.shows("─ Link ")
        await it.press("escape", "escape")
        await it.shows("EDIT", "map")
        await it.press("g", "N", "}", "i")
        await it.shows("the draft is of floor_0")
        await it.press("{", "escape")
        await it.hides("EDIT")
        await it.press("d")
        await it.shows("─ Link ")


async def test_the_mouse_draws_too() -> None:
    async with planted(2, 2) as it:
        await it.press("E", "i")
        editor = it.app.main.features.editing.editor
        assert editor.draft is not None and editor.mode is not None
        (made,) = [v for v in editor.draft.floor.vertices.values() if v.id == editor.mode.selected]
        picture = it.app.main.features.map.picture
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
async def test_small_screens_say_that_a_draft_is_edited(size: tuple[int, int]) -> None:
    async with planted(1, 1, size) as it:
        await it.press("E")
        await it.shows("EDIT", "map")


SERVICE = "/robot_0/route_server/set_route_graph"


@asynccontextmanager
async def edited(site: Site, folder: Path, path_there: str = "{path}") -> AsyncIterator[Console]:
    """A console on robots with Nav2, with a way to a new vertex in its draft."""
    (floor,), profile = site.config.floors, site.config.profile
    asked = {"graph_load": {"graph_filepath": path_there}}
    config = replace(site.config, profile=replace(profile, requests=asked))
    file = Path(floor.graph) if floor.graph else None
    files = ConsoleFiles(graph_file=lambda _floor: file, folder=folder)
    async with console(config, (160, 40), wait=bool(floor.graph), files=files) as it:
        await it.press("E")
        editor = it.app.main.features.editing.editor
        if editor.draft is not None and editor.mode is not None and editor.draft.floor.vertices:
            start = editor.draft.floor.vertices[site.vertex("Base")]
            editor.mode.selected, editor.mode.cursor = start.id, (start.x + 1.5, start.y)
            await it.press("e")
            await it.shows(" 2W")  # the check is over
        yield it


async def send(it: Console) -> None:
    """Press W, choose to send, and say yes."""
    await it.press("W")
    await it.shows("Send to robot_0 (asks)")
    await it.press("enter")
    await it.shows("y  Yes")
    await it.press("y")


def file_of(site: Site) -> Path:
    return Path(site.config.floors[0].graph)


def text_of(path: Path) -> str:
    return path.read_text()


def loaded(site: Site) -> list[object]:
    """The requests that reached route servers."""
    calls = site.server.bridge.services.calls
    return [args for service, args in calls if service == SERVICE]


def differences(it: Console) -> int:
    editing = it.app.main.features.editing
    assert editing.editor.draft is not None
    return len(editing.checks.changes(editing.editor.draft.floor))


async def test_a_robot_with_nav2_loads_the_drawn_graph_from_the_floors_file(
    site: Site, tmp_path: Path
) -> None:
    file, before = file_of(site), text_of(file_of(site))
    async with edited(site, tmp_path / "state") as it:
        assert differences(it) == 2
        await it.press("W")
        await it.shows("2 differences from the live graph")
        assert text_of(file) == before and not loaded(site)
        await it.press("enter")
        await it.shows("replaces 20 vertices, 26 edges, 8 labels")
        await it.shows(".bak")  # where it wraps depends on the path
        await it.shows("1 other robot of floor_0: send it to each, too")
        await it.press("y")
        await it.shows("confirmed (the robot has loaded the file)")
        await it.until(lambda _: differences(it) == 0)
        assert loaded(site) == [{"graph_filepath": str(file)}]
        taken = site.fleet.route_servers.graphs["robot_0"]
        assert (len(taken.vertices), len(taken.edges)) == (21, 54)
    ids = [one["properties"]["id"] for one in json.loads(text_of(file))["features"]]
    assert len(ids) == len(set(ids)) == 75
    assert text_of(file.with_name(f"{file.name}.bak")) == before


async def test_a_robot_that_sees_the_file_elsewhere_and_refuses_it_leaves_the_live_graph(
    site: Site, tmp_path: Path
) -> None:
    file, before = file_of(site), text_of(file_of(site))
    async with edited(site, tmp_path, path_there="/data/{floor}.geojson") as it:
        await send(it)
        await it.shows("graph.geojson is written, robot_0 has not loaded it (before: graph.geojson.bak)")
        (record,) = it.store.state.commands
        assert (record.stage, record.detail) == (Stage.REFUSED, "success False")
        assert loaded(site) == [{"graph_filepath": "/data/floor_0.geojson"}]
        assert differences(it) == 2 and text_of(file) != before


async def test_a_floor_without_a_file_names_the_remedy(site: Site, tmp_path: Path) -> None:
    (floor,) = site.config.floors
    site.config = replace(site.config, floors=[replace(floor, graph="")])
    async with edited(site, tmp_path) as it:
        await it.press("W")
        await it.shows('set graph = "FILE.geojson" in [[floors]] of floor_0')
        assert not loaded(site)


def replace_by_folder(path: Path) -> None:
    path.unlink()
    path.mkdir()


async def test_a_file_that_can_not_be_written_stops_the_call(site: Site, tmp_path: Path) -> None:
    async with edited(site, tmp_path / "state") as it:
        replace_by_folder(file_of(site))
        await send(it)
        await it.shows("is a folder: name a file")
        assert not loaded(site) and not it.store.state.commands
