"""Sort, marks and copies, by the keys on the screen."""

import base64

import pytest

from fleet_tui.model.commands import PauseRobot, ResumeRobot
from fleet_tui.ui.view.tables.groups import GroupHead
from tests.support.console_pilot import Console
from tests.support.planted_console import planted


def names(it: Console) -> list[str]:
    return [line.split("robot_")[1].split()[0] for line in it.pane("fleet").splitlines() if "robot_" in line]


async def test_sorting_goes_through_the_columns_and_back() -> None:
    async with planted(3, 2) as it:
        await it.until(lambda state: all(robot.battery for robot in state.robots.values()))
        await it.press("tab", "S")
        await it.shows("by robot")
        await it.press("S")
        await it.shows("by battery")
        percent = {name[-1]: robot.battery for name, robot in it.store.state.robots.items()}
        wanted = sorted(percent, key=lambda name: percent[name].value if percent[name] else 0.0)  # type: ignore[union-attr]  # waited for
        assert names(it) == wanted
        while "by " in it.pane("fleet").splitlines()[0]:
            await it.press("S")
        assert names(it) == ["0", "1", "2"]


async def test_a_marked_row_is_told_and_commands_go_to_all_of_them() -> None:
    async with planted(3, 2) as it:
        await it.press("tab", "space", "down", "down", "space")
        await it.shows("2 marked", "fleet")
        await it.press("p")
        await it.shows("robot_2 pause: confirmed", "outcomes")
        assert it.sent == [PauseRobot("robot_0"), PauseRobot("robot_2")]
        await it.hides("marked", "fleet")
        await it.press("space", "up", "up", "space", "r")
        await it.shows("Send to 2 robots?")
        await it.press("y")
        assert it.sent[2:] == [ResumeRobot("robot_0"), ResumeRobot("robot_2")]


async def test_escape_closes_the_outcomes_and_clears_marks() -> None:
    async with planted(2) as it:
        await it.press("tab", "space", "down", "space", "p")
        await it.shows("Outcomes")
        await it.press("space")
        await it.shows("1 marked", "fleet")
        await it.press("escape")
        assert "Outcomes" not in it.text and "1 marked" in it.pane("fleet")
        await it.press("escape")
        assert "marked" not in it.pane("fleet")
        assert it.app.main.focused is it.app.main.fleet


async def test_the_row_is_copied_as_it_reads(monkeypatch: pytest.MonkeyPatch) -> None:
    async with planted(2) as it:
        written = list[str]()

        def call(text: str) -> bool:
            written.append(text)
            return True

        monkeypatch.setattr(it.app.output, "call", call)
        await it.press("tab", "down", "y")
        await it.shows("copied to the clipboard: ")
        (sequence,) = written
        copied = base64.b64decode(sequence.removeprefix("\x1b]52;c;").removesuffix("\x07")).decode()
        assert "robot_1" in copied and copied.strip() == copied


async def test_the_cursor_stays_on_the_head_of_a_group_whatever_is_done_with_marks() -> None:
    async with planted(3, 2) as it:
        await it.until(
            lambda state: {robot.floor for robot in state.robots.values()} >= {"floor_0", "floor_1"}
        )
        listing = it.app.main.fleet.listing
        await it.press("tab", "Z", "space", "home")
        head = listing.cursor
        assert isinstance(head, GroupHead) and listing.marks
        await it.press("escape")
        assert not listing.marks and listing.cursor == head
        await it.press("S")
        assert listing.cursor == head
        await it.press("S", "down", "space", "home", "p")
        await it.shows("pause: confirmed")
        assert not listing.marks and listing.cursor == head


async def test_groups_fold_on_enter_and_are_no_robots() -> None:
    async with planted(3, 2) as it:
        await it.until(
            lambda state: {robot.floor for robot in state.robots.values()} >= {"floor_0", "floor_1"}
        )
        selected = it.app.main.navigation.robot
        await it.press("tab", "Z")
        await it.shows("- floor_0", "fleet")
        assert "- floor_1" in it.pane("fleet")
        await it.press("up")
        await it.press("space")
        await it.shows("a group can't be marked")
        assert "marked" not in it.pane("fleet").splitlines()[0]
        before = len(names(it))
        await it.press("enter")
        await it.shows("+ floor_0", "fleet")
        assert names(it) and len(names(it)) < before and it.app.main.navigation.robot == selected
        await it.press("enter")
        await it.shows("- floor_0", "fleet")
        await it.press("Z")
        assert "floor_0 " not in it.pane("fleet").splitlines()[1] and names(it) == ["0", "1", "2"]


async def test_without_groups_their_key_says_so() -> None:
    async with planted() as it:
        await it.press("tab", "Z")
        await it.shows("one floor and one link: nothing to group by")
