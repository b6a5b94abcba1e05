"""Overlays about the selected robot: its keys work in them, and one leads to the other."""

from tests.support.planted_console import planted


async def test_reasons_and_page_lead_to_each_other_and_back_to_the_focus() -> None:
    async with planted(2) as it:
        rest = it.app.main.features
        await it.press("tab")
        before = it.app.main.focused
        for key, opened, closed in (("w", rest.why, rest.robot_page), ("i", rest.robot_page, rest.why)) * 2:
            await it.press(key)
            assert opened.is_open and not closed.is_open
        await it.press("escape")
        assert not rest.why.is_open and not rest.robot_page.is_open
        assert it.app.main.focused is before


async def test_its_own_key_and_q_close_it() -> None:
    async with planted() as it:
        for opener, overlay in (("w", it.app.main.features.why), ("i", it.app.main.features.robot_page)):
            for closer in (opener, "q", "escape"):
                await it.press(opener)
                assert overlay.is_open
                await it.press(closer)
                assert not overlay.is_open


async def test_the_footer_names_what_works_in_there_but_not_its_own_key() -> None:
    async with planted(2, 1, (200, 40)) as it:
        await it.press("i")
        await it.shows(" Esc close  . robot ", "hints")
        assert " o order " in it.pane("hints") and " w why " in it.pane("hints")
        assert " i page " not in it.pane("hints") and " F12 pause all" in it.pane("hints")
        await it.press("w")
        await it.shows(" i page ", "hints")
        assert " w why " not in it.pane("hints")
