"""Overlays: the key after the one that opened it is theirs."""

import pytest

from fleet_tui.features.programs.page import Programs
from fleet_tui.text.language import verbatim
from tests.support.ordering import one_packet
from tests.support.planted_console import planted


@pytest.mark.parametrize("opener", [":", "?"])
async def test_keys_typed_right_after_the_palette_or_help_belong_to_it(opener: str) -> None:
    async with planted() as it:
        one_packet(it, opener + "pPoxX")
        await it.shows("pPoxX")
        one_packet(it, "\x1b")
        await it.hides("pPoxX")
        assert it.sent == []


async def test_a_dialog_over_a_list_gives_it_back_and_over_nothing_the_map() -> None:
    async with planted() as it:
        rest, programs = it.app.main.features, it.app.main.query_one(Programs)
        await it.press("J")
        rest.confirm.ask(lambda: verbatim("Really?"), lambda: None)
        await it.shows("Really?")
        assert not programs.is_open
        await it.press("n")
        assert programs.is_open and programs.rows.has_focus
        await it.press("escape")
        rest.confirm.ask(lambda: verbatim("Really?"), lambda: None)
        await it.press("n")
        assert not programs.is_open and rest.map.has_focus


async def test_help_in_the_place_of_a_dialog_over_a_list_leaves_no_focus_in_what_is_hidden() -> None:
    async with planted() as it:
        rest, programs = it.app.main.features, it.app.main.query_one(Programs)
        await it.press("J")
        rest.confirm.ask(lambda: verbatim("Really?"), lambda: None)
        await it.press("f1", "escape")
        assert it.app.main.focused is rest.map and not programs.is_open


async def test_every_overlay_has_its_title_in_its_border() -> None:
    async with planted(2) as it:
        it.fleet.world.robots["robot_1"].paused = True
        await it.until(lambda state: state.is_paused(state.robots["robot_1"]))
        for key, title in ((":", "Command"), ("?", "Help"), ("enter", "Actions"), ("R", "Question")):
            await it.press(key)
            await it.shows(f"╭─ {title} ─")
            await it.press("escape")
