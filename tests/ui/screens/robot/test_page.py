"""`i`: the page of the selected robot, live, on a fleet and on a recording."""

from pathlib import Path

import pytest

from fleet_tui.model.commands import PauseRobot, ResumeRobot
from fleet_tui.model.events import TimePassed
from fleet_tui.records.audit.log import auditing
from tests.support.fleets import R0, T0, WALL, battery, link_up, pose
from tests.support.planted_console import SITE, in_the_way, planted
from tests.support.replay_console import replayed
from tests.support.tapes import MadeUp
from tests.support.watched_store import config_of

TEXT = "robot-page-text"


@pytest.mark.parametrize("size", [(60, 16), (80, 24), (120, 40), (200, 60)])
async def test_it_leaves_the_usual_lines_in_view(size: tuple[int, int]) -> None:
    async with planted(2, 2, size) as it:
        await it.press("i")
        await it.shows("100 %", TEXT)
        assert "robot_0  oh_ressources" in it.pane("robot-page-title")
        lines = it.text.splitlines()
        assert " alarm" in lines[0] and "Esc close" in lines[-1]
        if size[0] < 200:
            assert it.app.main.features.robot_page.size.height == size[1] - 3
        await it.press("escape")
        await it.hides("─ Battery")


async def test_the_map_stays_in_view_where_the_tables_have_space_for_the_page() -> None:
    async with planted(2, 2, (200, 60)) as it:
        await it.press("i")
        await it.shows("100 %", TEXT)
        page, picture = it.app.main.features.robot_page.region, it.app.main.query_one("#map").region
        assert picture.right <= page.x and page.right == 200
        small_maps = it.app.main.panes.small_maps.region
        await it.until(lambda state: it.app.main.features.robot_page.region.bottom == small_maps.y)
        assert (
            it.pane(TEXT).index("─ State") < it.pane(TEXT).index("─ Battery") < it.pane(TEXT).index("─ Route")
        )
    async with planted(2, 2, (200, 40)) as it:
        await it.press("i")
        await it.shows("100 %", TEXT)
        assert it.app.main.features.robot_page.region.width == 200


async def test_it_goes_on_to_the_next_robot_from_the_top() -> None:
    async with planted(2, 1, (80, 24)) as it:
        await it.press("i", "pagedown")
        for key, robot in ((".", 1), ("]", 0), (",", 1), ("[", 0), ("1", 1)):
            await it.press(key)
            await it.shows(f"robot_{robot}  oh_ressources", "robot-page-title")
            assert it.app.main.navigation.robot == f"robot_{robot}"
            assert it.pane(TEXT).startswith("─ State")


async def test_it_scrolls_and_says_where_it_is() -> None:
    async with planted(1, 1, (60, 16)) as it:
        await it.press("i")
        await it.shows("100 %", TEXT)
        await it.shows("1-12 of ", "robot-page-title")
        for key, first in (
            ("down", "2-"),
            ("j", "3-"),
            ("k", "2-"),
            ("pagedown", "14-"),
            ("pageup", "2-"),
            ("home", "1-"),
        ):
            await it.press(key)
            await it.shows(f" {first}", "robot-page-title")


async def test_keys_about_the_robot_work_in_it_and_questions_return_to_it() -> None:
    async with planted(2) as it:
        page = it.app.main.features.robot_page
        await it.press("i", "p")
        await it.shows("Paused    yes", TEXT)
        await it.shows("pause: confirmed", TEXT)
        await it.press("R")
        assert it.app.main.features.confirm.is_open and not page.is_open
        await it.press("y")
        assert page.is_open and page.has_focus
        await it.shows("Paused    no", TEXT)
        await it.press("enter")
        assert it.app.main.features.menu.is_open
        await it.press("escape")
        assert page.is_open
        await it.press("o")
        assert it.app.main.features.order_form.is_open and not page.is_open
        assert it.sent == [PauseRobot(R0), ResumeRobot(R0)]


async def test_alarms_that_are_over_come_from_the_audit_log(tmp_path: Path) -> None:
    async with in_the_way("robot_0") as it:
        with auditing(tmp_path, config_of(SITE, 2), it.store) as it.app.main.files.audit:
            await it.press("i")
            await it.shows("▲ new  obstacle", TEXT)
            await it.press("escape")
            it.publish("/robot_0/obstacle", {"data": 0.0})
            await it.shows("all clear", "alarms")
            it.publish("/robot_0/obstacle", {"data": 44.2})
            await it.shows("Alarms 1 new", "alarms")
            it.publish("/robot_0/obstacle", {"data": 0.0})
            await it.shows("all clear", "alarms")
            await it.press("i")
            await it.shows("  over ", TEXT)


async def test_the_curve_is_drawn_as_the_map_is() -> None:
    async with planted() as it:
        await it.press("m", "m", "i")
        await it.shows("100 %+", TEXT)
        assert not any("\u2800" <= sign <= "\u28ff" for sign in it.pane(TEXT))
        await it.press("escape", "m", "i")
        await it.shows("100 %┤", TEXT)


async def test_old_values_are_marked_with_their_age() -> None:
    async with planted() as it:
        await it.press("i")
        await it.shows("Paused    no", TEXT)
        it.fleet.server.bridge.muted.update(
            f"/robot_0/{topic}" for topic in ("battery", "pose", "obstacle", "paused")
        )
        await it.until(lambda state: state.is_old(state.robots[R0], "battery"))
        await it.shows(" s old", TEXT)


async def test_a_recording_has_the_page_with_what_was_seen_in_it(tmp_path: Path) -> None:
    made = MadeUp(config_of("ws://site:9090", 2))
    made.tell(0, link_up(T0))
    for second in range(60):
        at = T0 + second
        made.tell(second, pose(at), battery(at, 80.0 - second / 4), TimePassed(at, WALL + second))
    path = made.written(tmp_path / "x.jsonl.gz").path
    async with replayed(path, "+20s") as it:
        await it.press("i")
        await it.shows("Battery   75 %", TEXT)
        await it.shows("100 %┤", TEXT)
        await it.shows("no audit log here", TEXT)
        await it.press(">", ">")
        await it.shows("Battery   70 %", TEXT)
        await it.press(".")
        assert it.app.main.navigation.robot == R0, "it is a key of the recording"
        await it.press("]")
        it.app.main.features.robot_page.look()  # its own time comes: in a stopped recording nothing else does
        assert "robot_1  oh_ressources" in it.pane("robot-page-title")
