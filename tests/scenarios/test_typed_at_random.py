"""Random keys typed into every form, list and menu: nothing leaves that the row or the key does not say.

More of them: FLEET_TUI_SEQUENCES=10000 (make typed).
"""

import os
import random
from collections.abc import Sequence
from pathlib import Path

import pytest
from textual.widgets import Button, Input, OptionList, Static

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.simulator.robot import SimRobot
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.screens.confirm import Confirm
from fleet_tui.ui.screens.menu import Menu
from fleet_tui.ui.terminal.typing import GAP
from tests.support.console_pilot import Console, console
from tests.support.watched_store import config_of

SEQUENCES = 10
"""Sequences of a console."""
CONSOLES = int(os.environ.get("FLEET_TUI_SEQUENCES", SEQUENCES)) // SEQUENCES
OPENERS: tuple[tuple[str, ...], ...] = (
    *(("o",), ("o", "enter"), (":",), ("s", "enter"), ("s", "down", "enter"), ("tab", "enter"), ("/",)),
    *(("M",), ("?",), ("X",), ("L",), ("w",), ("i",), ("g", "n", "enter"), ("x",), ("R",), ("d",), ("H",)),
)
WORDS = ("Base", "Pack", "Store", "Dispatch", "pause all", "robot_1", "cancel 1", "here", "99")
KEYS = (*"pPrRxXoynNsSaAwgigfclkjh123450 />*=", "enter", "escape", "up", "down", "tab", "f12", "backspace")
VERBS = {PauseRobot: "pause", ResumeRobot: "resume", CancelOrder: "cancel", ClearOrders: "clear"}


class Reader:
    """What a person reads on the screen before a key, and so what the key may do."""

    def __init__(self, it: Console) -> None:
        self._it = it

    def row(self) -> str:
        """The text of the highlighted row of the list that is open, empty for none."""
        for options in self._it.app.main.query(OptionList):
            visible = options.display and all(one.display for one in options.ancestors)
            if visible and options.region.height and options.highlighted is not None:
                return str(options.get_option_at_index(options.highlighted).prompt)
        return ""

    def allows(self, key: str, since_text: float) -> "Allowed":
        """Return what a key may send, so many seconds after the last text."""
        it, focused = self._it, self._it.app.main.focused
        robots = list(it.store.state.robots)
        if key == "f12":
            return Allowed(pauses=robots)
        is_text = len(key) == 1 or key in ("enter", "space")
        if isinstance(focused, Input):
            return self._in_field(focused, key)
        if is_text and since_text < GAP:
            return Allowed()
        if key == "P":
            return Allowed(pauses=robots)
        if isinstance(focused, Confirm):
            question = str(focused.query_one("#question", Static).content)
            return (
                Allowed(text=f"{question} order" if "->" in question else question)
                if key == "y"
                else Allowed()
            )
        if focused is not None and any(isinstance(one, Menu) for one in focused.ancestors):
            return Allowed(text=self._entry(key), robot=robots)
        if isinstance(focused, Button) and focused.id == "simple-send" and key == "enter":
            return Allowed(text="order")
        # The marks are seen beside the rows; without any it is the selected robot.
        meant = it.app.main.features.tables.robots() or [it.app.main.navigation.robot]
        if key in ("p", "r"):
            return Allowed(pauses=meant) if key == "p" else Allowed(text="resume", robot=meant)
        return Allowed()

    def _in_field(self, field: Input, key: str) -> "Allowed":
        if key != "enter":
            return Allowed()
        if field.id == "to":
            return Allowed(text="order", end=self.row().partition("  ")[0])
        if field.id == "request":
            row = self.row()
            return Allowed(text=f"{row} order" if "->" in row else row)
        return Allowed()

    def _entry(self, key: str) -> str:
        """The entry of a menu that a key means."""
        (options,) = [one for one in self._it.app.main.query(OptionList) if one.id == "menu-list"]
        rows = [str(options.get_option_at_index(n).prompt) for n in range(options.option_count)]
        if key == "enter":
            return self.row()
        if key.isdigit():
            return next((row for row in rows if row.startswith(f"{key}  ")), "")
        return next((row for row in rows if row.endswith(f"({key})")), "")


class Allowed:
    """Commands that a person meant: pauses of robots, or what a text says."""

    def __init__(
        self, pauses: Sequence[str] = (), text: str = "", robot: Sequence[str] = (), end: str = ""
    ) -> None:
        self._pauses, self._text, self._robots, self._end = pauses, text.casefold(), robot, end

    def objection(self, it: Console, command: Command) -> str:
        """Return why a command was not meant, empty if it was."""
        if isinstance(command, PauseRobot) and command.robot in self._pauses:
            return ""
        if self._robots and command.robot not in self._robots:
            return "another robot"
        if isinstance(command, PlaceOrder):
            name = it.store.state.robots[command.robot].name_of(command.stops[-1].vertex) or ""
            named = not self._end or self._end.startswith(name)
            said = "order" in self._text or "repeat" in self._text or "return trip" in self._text
            return "" if said and named else f"an order to {name}"
        verb = VERBS.get(type(command), "?")
        return "" if verb in self._text else f"a {verb}"


@pytest.mark.timeout(600)
@pytest.mark.parametrize("seed", range(1, CONSOLES + 1))
async def test_random_keys_send_nothing_that_was_not_meant(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, seed: int
) -> None:
    monkeypatch.chdir(tmp_path)  # maps and files are saved where the console was opened
    chance = random.Random(seed)
    async with console(config_of(server.url, 2, 2), (80, 24)) as it:
        submitted: list[Command] = []
        submit = it.app.backend.submit

        def spy(*commands: Command) -> str:
            submitted.extend(commands)
            return submit(*commands)

        monkeypatch.setattr(it.app.backend, "submit", spy)
        reader, meant = Reader(it), 0
        for number in range(SEQUENCES):
            await _rest(it, server, chance)
            submitted.clear()
            await it.press(*chance.choice(OPENERS))
            assert not submitted, "to open something commands nothing"
            typed: list[str] = []
            since_text = 1.0
            for key in _sequence(chance):
                soon = chance.random() < 0.7
                since_text = since_text + 0.05 if soon else 1.0
                allowed = reader.allows(key, since_text)
                in_field = isinstance(it.app.main.focused, Input)
                is_text = len(key) == 1 or key == "enter"
                before = len(submitted)
                await it.press_after(0.05 if soon else 1.0, "space" if key == " " else key)
                typed.append(key)
                for command in submitted[before:]:
                    objection = allowed.objection(it, command)
                    assert not objection, (
                        f"{number}: {' '.join(typed)} sent {objection}: {command}\n{it.text}"
                    )
                meant += len(submitted) - before
                if key == "escape":
                    since_text = 1.0
                elif is_text and (in_field or since_text < GAP):
                    since_text = 0.0
    # Of many consoles some have, by chance, next to no keys that command.
    assert seed > 1 or meant > SEQUENCES / 10, "some keys command"


def _sequence(chance: random.Random) -> list[str]:
    keys: list[str] = []
    for _ in range(chance.randint(1, 4)):
        keys += chance.choice(WORDS) if chance.random() < 0.5 else [chance.choice(KEYS)]
        if chance.random() < 0.4:
            keys.append(chance.choice(("enter", "enter", "down", "escape", "y")))
        keys += [chance.choice(KEYS) for _ in range(chance.randint(0, 3))]
    return keys


async def _rest(it: Console, server: RosbridgeServer, chance: random.Random) -> None:
    """Nothing open, the map focused, robots in some state."""
    for robot in server.world.robots.values():
        robot.cargo, robot.paused = chance.random() < 0.3, chance.random() < 0.3
        robot.drop({order.id for order in robot.orders})
        if chance.random() < 0.5:
            labels = sorted(robot.floor.labels)
            robot.take(labels[0], labels[1], 0)
    it.packet(*["escape"] * 4)
    await it.settled()
    if it.app.main.panes.has_class("-simple"):
        await it.press("s", "escape")
    it.app.main.dispatch.given.clear()
    # What arrives later would withdraw a question in the middle of a sequence.
    await it.until(lambda state: all(_is_told(state, robot) for robot in server.world.robots.values()))


def _is_told(state: FleetState, robot: SimRobot) -> bool:
    """Tell whether the console knows of a robot what is so."""
    known = state.robots[robot.name]
    orders = [int(order.id) for order in known.orders.orders]
    return state.is_paused(known) == robot.paused and orders == [order.id for order in robot.orders]
