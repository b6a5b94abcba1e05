"""The footer: the keys available at the current focus."""

from collections.abc import Collection, Mapping
from typing import Any

from fleet_tui.keys import KEYS, LISTS, Key, Pane
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Run


def hidden_keys(state: FleetState, selected: str) -> set[str]:
    """Return the ids of keys without a use for the kind of the selected robot, or the whole fleet."""
    robots = list(state.robots.values())
    return {
        key.id
        for key in KEYS
        if key.needs
        and not any(_serves(one, key.needs) for one in (robots if key.of_any else [state.robots[selected]]))
    }


def _serves(robot: Robot, need: str) -> bool:
    return robot.kind.lists_orders if need == LISTS else robot.kind.can(need)


def _runs(key: Key[Any], keys: Mapping[str, tuple[str, ...]]) -> list[Run]:
    shown = keys[key.id][0]
    return [(f" {shown} ", StyleRole.KEY), (f"{key.hint} ", StyleRole.DIM)]


def hints(
    keys: Mapping[str, tuple[str, ...]],
    pane: Pane,
    can_command: bool = True,
    hidden: Collection[str] = (),
) -> tuple[list[Run], list[Run]]:
    """Return the hints at the left, the pane's own first, and the permanent ones at the right. In an overlay
    only global keys reach the console. `hidden`: ids of keys without a use here."""
    away = {*hidden, *(key.id for key in KEYS if key.commands and not can_command)}
    offered = [key for key in KEYS if key.hint and keys[key.id] and key.id not in away]
    if pane is Pane.ANYWHERE:
        left, right = [key for key in offered if key.pane is pane], []
    else:
        offered.sort(key=lambda key: key.pane is not pane)
        left = [key for key in offered if key.pane in (pane, Pane.CONSOLE) and not key.always]
        right = [key for key in offered if key.always]
    return [run for key in left for run in _runs(key, keys)], [
        run for key in right for run in _runs(key, keys)
    ]
