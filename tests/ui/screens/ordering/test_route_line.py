"""The length of the typed order's way."""

from fleet_tui.ui.screens.ordering.route_line import show_route
from tests.support.planted_console import planted


async def test_the_way_is_shown_while_it_is_typed_and_gone_with_the_form() -> None:
    async with planted() as it:
        form = it.app.main.features.order_form
        assert show_route(form, it.store.state) is None and form.route.content == ""
        await it.press("o")
        for place in ("Base", "Store"):
            await it.type(place)
            if place == "Base":
                await it.press("enter")
        drafted = show_route(form, it.store.state)
        assert drafted is not None and drafted[1] is not None
        assert form.route.content == drafted[1].text != ""
        await it.press("escape")
        assert show_route(form, it.store.state) is None and form.route.content == ""
