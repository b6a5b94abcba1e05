"""Clicks and selections: Enter in a row, a button in a row, a key of the footer."""

from tests.support.planted_console import planted


async def test_enter_opens_the_menu_of_the_robot_on_the_map_and_in_the_fleet() -> None:
    async with planted(2) as it:
        await it.press("enter")
        await it.shows("Explain why it is not moving")
        await it.press("escape")
        await it.hides("Explain why it is not moving")
        it.app.main.fleet.focus()
        await it.press("down", "enter")
        await it.shows("Explain why it is not moving")
        assert it.app.main.navigation.robot == "robot_1"


async def test_the_menu_of_a_robot_in_trouble_leads_to_its_alarm() -> None:
    async with planted(2) as it:
        it.fleet.world.robots["robot_1"].battery = 5.0
        await it.until(lambda state: state.unacknowledged)
        await it.press("!", "enter")
        await it.shows("Alarm: battery")
        await it.press("down", "down", "enter")
        await it.shows("Shelve")


async def test_the_palette_finds_the_menu_of_the_marked_alarm() -> None:
    async with planted(2) as it:
        for word in ("shelve", "unshelve"):
            await it.press(":")
            await it.type(word)
            await it.shows("Open the marked alarm's menu")
            await it.press("escape")
        await it.press(":")
        await it.type("unshelve")
        await it.until(lambda state: not state.alarms)  # a slow start has one of the link
        await it.press("enter")
        await it.shows("no alarm", "message")


async def test_a_click_on_a_key_of_the_footer_presses_it() -> None:
    async with planted() as it:
        hints = it.app.main.hints
        place = it.pane("hints").index("w why")
        await it.pilot.click(hints, offset=(place + 1, 0))
        await it.shows("Why: ")
