"""While an order is typed the map shows its way, and the form its length."""

import pytest

from tests.support.console_pilot import Console
from tests.support.ordering import place
from tests.support.planted_console import planted


def scene_of(it: Console) -> tuple[tuple[str, ...], int]:
    """The vertices that stand out, and the lines of the way."""
    scene = it.app.main.features.map.picture.scene
    assert scene is not None
    return scene.target_vertices, len(scene.mission.current) if scene.mission else 0


async def test_the_marked_place_stands_out_and_the_way_has_a_length() -> None:
    async with planted(1, 1, (120, 40)) as it:
        await it.press("o")
        await it.type("Base")
        await it.until(lambda _: scene_of(it) == (("0", "0"), 0))
        await it.press("enter")
        await it.type("Consum")
        await it.shows(" m, about ")
        vertices, lines = scene_of(it)
        assert vertices[:2] == ("0", "19") and lines > 2
        await it.press("escape")
        await it.until(lambda _: scene_of(it) == ((), 0))


async def test_the_way_of_the_current_order_stays_until_a_place_is_typed() -> None:
    async with planted(1, 1, (120, 40)) as it:
        await place(it)
        await it.until(lambda _: scene_of(it)[1] > 2)
        await it.press("o")
        await it.shows("Enter  next")
        await it.until(lambda _: scene_of(it)[1] > 2)
        await it.type("Base")
        await it.until(lambda _: scene_of(it) == (("0", "0"), 0))


@pytest.mark.parametrize("size", [(120, 40), (80, 24)])
async def test_the_form_leaves_the_map_free(size: tuple[int, int]) -> None:
    async with planted(1, 1, size) as it:
        await it.press("o")
        form, map_view = it.app.main.features.order_form, it.app.main.features.map
        await it.until(lambda _: form.region and not form.region.overlaps(map_view.region))
        assert form.region.bottom <= size[1]


async def test_a_place_of_another_floor_is_shown_on_its_floor() -> None:
    async with planted(1, 2, (120, 40)) as it:
        await it.press("o")
        await it.type("Dock")
        await it.shows("floor_1 ─", "map")
        await it.press("escape")
        await it.shows("floor_0 ─", "map")
