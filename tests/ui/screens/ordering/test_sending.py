"""From filled fields to an order: the first field that lacks a place is named."""

from tests.support.planted_console import planted


async def test_what_is_missing_is_named() -> None:
    async with planted() as it:
        await it.press("o", "enter")
        await it.shows("From is missing")
        await it.type("zzz")
        await it.press("enter")
        await it.shows("no match for 'zzz'")
        await it.press("escape", "o")
        await it.type("Base")
        await it.press("enter", "enter")
        await it.shows("To is missing")
        await it.type("Base")
        await it.press("enter")
        await it.shows("same place")
        await it.press("escape")
        await it.hides("To is missing")
        assert it.sent == []
