"""Alarms by key and menu."""

import math

import msgspec

from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.desk.events import AlarmShelved
from tests.support.console_pilot import Console
from tests.support.planted_console import SITE, in_the_way, planted
from tests.support.watched_store import config_of


def stages(it: Console) -> list[AlarmStage]:
    return [alarm.stage for alarm in it.store.state.alarms]


async def test_shelved_and_taken_off_the_shelf() -> None:
    async with in_the_way("robot_0") as it:
        it.app.main.alarms.focus()
        await it.press("enter")
        await it.shows("3  Shelve for 30 min")
        await it.press("3")
        await it.until(lambda state: state.shelved)
        await it.shows("Alarms 1 shelved", "alarms")
        await it.shows("0 alarms ", "status")
        await it.shows("◇ shelved until", "alarms")
        await it.press("enter")
        await it.shows("5  Unshelve")
        await it.press("5")
        await it.until(lambda state: state.unacknowledged == 1)
        await it.shows("1 alarm (1 new)", "status")


async def test_a_shelf_ends_by_itself() -> None:
    config = config_of(SITE, 1)
    config = msgspec.structs.replace(
        config, alarms=msgspec.structs.replace(config.alarms, shelve_for=0.5, offline_after=60.0)
    )
    async with planted(config=config) as it:
        it.publish("/robot_0/obstacle", {"data": 44.2})
        await it.shows("robot_0", "alarms")
        it.app.main.alarms.focus()
        await it.press("enter", "3")
        await it.until(lambda _: it.store.told(AlarmShelved))
        await it.until(lambda state: not state.shelved)
        assert stages(it) == [AlarmStage.UNACKNOWLEDGED]


async def test_a_and_a_again_go_through_the_list() -> None:
    async with in_the_way("robot_0", "robot_1") as it:
        await it.shows("robot_1", "alarms")
        await it.press("a")
        await it.shows("2 alarms (1 new)", "status")
        await it.press("a")
        await it.shows("2 alarms ", "status")
        await it.hides("new)")


async def test_the_cursor_goes_to_what_nobody_has_seen() -> None:
    """From any pane, `a` means it; while the list itself is read, the cursor stays."""
    async with planted(2, 2) as it:
        it.publish("/robot_0/obstacle", {"data": 44.2})
        await it.shows("robot_0", "alarms")
        await it.press("a")
        await it.shows("▸△ seen high   robot_0", "alarms")
        it.publish("/robot_1/obstacle", {"data": 44.2})
        await it.shows("▸▲ new  high   robot_1", "alarms")
        it.app.main.alarms.focus()
        await it.press("j", "a")
        assert it.app.main.alarms.listing.cursor == ("robot_0", "obstacle")
        assert it.store.state.unacknowledged == 1


async def test_an_acknowledgement_after_a_choice_is_of_that_robot() -> None:
    async with planted(2, 2) as it:
        await it.press("A")
        for n in range(2):
            it.publish(f"/robot_{n}/obstacle", {"data": 44.2})
        await it.until(lambda state: sum(alarm.condition.kind == "obstacle" for alarm in state.alarms) == 2)
        await it.press("!")
        chosen = it.app.main.navigation.robot
        await it.press("a")
        await it.shows(f"acknowledged: obstacle alarm of {chosen}")


async def test_the_mark_goes_to_a_worse_alarm_unless_somebody_chose_the_marked_one() -> None:
    async with planted(2, 2, (120, 40)) as it:
        it.publish("/robot_1/battery", {"data": 5.0})
        await it.shows("▸▲ new  medium robot_1", "alarms")
        it.publish("/robot_0/obstacle", {"data": 44.2})
        await it.shows("▸▲ new  high   robot_0", "alarms")
        assert math.isfinite(it.app.main.marked_alarm.gone_at), "an acknowledgement waits for a look"
        await it.shows("robot_0: Clear the path", "alarms")
        await it.press("!")
        assert it.app.main.navigation.robot == "robot_1"
        await it.shows("a ack")
        assert "▸▲ new  medium robot_1" in it.pane("alarms")
