"""The footer: the keys available at the current focus, by importance."""

from collections.abc import Callable, Collection, Hashable, Mapping

from msgspec.structs import replace

from fleet_tui.keys import BY_ID, KEYS, LISTS, Key, Pane, outdone
from fleet_tui.keys.drive import PASSES
from fleet_tui.keys.key import key_name
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.problem import Right
from fleet_tui.model.robot import Robot
from fleet_tui.situation.alarms.trouble import in_trouble, to_look_at
from fleet_tui.text.language import Message, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.alarms import unacknowledged
from fleet_tui.ui.view.tables.table import Button, Run, width_of

OF_ROWS = {"alarms": "acknowledge", "queue": "cancel"}
"""The keys of the console that are about the rows of one pane."""
FOR_DISPATCHERS = ("arm", "simple")
"""Keys that are of no use without the right to command, beside the commands themselves."""
FOR_EVERYONE = ("order", "pause", "pause_all", "next_trouble", "acknowledge")


def hidden_keys(state: FleetState, selected: str) -> set[str]:
    """Return the ids of keys without a use for the kind of the selected robot, or the whole fleet."""
    robots = list(state.robots.values())
    return {
        key.id
        for key in KEYS
        if key.needs
        and not any(_serves(one, key.needs) for one in (robots if key.of_any else [state.robots[selected]]))
    }


def unoffered_keys(offers: Callable[[Key], bool], right: Right) -> set[str]:
    """Return the ids of keys that have no use in this session, or whose effect the user has no right to."""
    return {
        key.id
        for key in KEYS
        if not offers(key)
        or (right < Right.SETUP and key.sets_up)
        or (right < Right.DISPATCH and (key.commands or key.id in FOR_DISPATCHERS))
    }


def idle_hints(state: FleetState, selected: str = "") -> set[str]:
    """Return the ids of keys that the footer need not name now, without a link those of commands, too."""
    idle = set() if in_trouble(state) or to_look_at(state) else {"next_trouble"}
    if selected and any(link.phase is not Phase.UP for link in state.links.values()):
        idle |= _unreachable(state, selected)
    if not any(map(state.is_paused, state.robots.values())):
        idle |= {"resume", "resume_all"}
    return idle if unacknowledged(state) else {*idle, "acknowledge"}


def _unreachable(state: FleetState, selected: str) -> set[str]:
    """Return the ids of the keys whose commands would not be sent now."""
    reached = [one.name for one in state.robots.values() if state.links[one.link].phase is Phase.UP]
    return {key.id for key in KEYS if key.commands and not (reached if key.of_any else selected in reached)}


def other_alarmed(marked: Hashable | None, selected: str) -> str:
    """Return who has the marked alarm, empty if that is the selected robot."""
    return str(marked[0]) if isinstance(marked, tuple) and marked[0] != selected else ""


def _serves(robot: Robot, need: str) -> bool:
    if need == LISTS:
        return robot.kind.lists_orders
    return robot.kind.can(need) or need in robot.kind.streams


def hints(
    keys: Mapping[str, tuple[str, ...]],
    pane: Pane,
    can_command: bool = True,
    hidden: Collection[str] = (),
    focused: str = "",
    alarmed: str = "",
    about_robot: bool = False,
) -> tuple[list[Key], list[Key]]:
    """Return the keys to hint at the left, the pane's own first, and the permanent ones at the right. In an
    overlay only global keys reach the console. `hidden`: ids of keys without a use here; `focused` is the id
    of the widget, which may have a key for its rows; `alarmed` is who has the marked alarm; `about_robot`:
    the overlay is about the robot, and the keys that help with it work there."""
    away = {*hidden, *(key.id for key in KEYS if key.commands and not can_command)}
    away |= outdone(keys, away)
    offered = [key for key in KEYS if key.hint and keys[key.id] and key.id not in away]
    if pane is Pane.DRIVE:
        # Any other key stops the robot and does nothing else.
        offered = [key for key in offered if key.pane is pane or key.id in PASSES]
    if pane is Pane.ANYWHERE:
        return _of_overlay(offered, about_robot), []
    offered = [_of_robot(key, alarmed) for key in offered]
    offered.sort(key=lambda key: (OF_ROWS.get(focused) != key.id, *_rank(key, pane)))
    offered = _alarm_first(offered)
    if focused == "map":  # on a small screen it is small
        ids = {key.id for key in offered}
        trouble = (id_ for id_ in ("acknowledge", "next_trouble", "why") if id_ in ids)
        offered = _moved(offered, "enlarge", next(trouble, "pause_all"))
    left = [key for key in offered if key.pane in (pane, Pane.CONSOLE) and not key.always]
    return left, [key for key in offered if key.always]


def _of_robot(key: Key, alarmed: str) -> Key:
    """Return a key that names who has the marked alarm, if that is another robot."""
    if key.id != "acknowledge" or not alarmed:
        return key
    return replace(key, hint=Message("{hint} {robot}", hint=key.hint, robot=sanitize(alarmed)))


def _alarm_first(offered: list[Key]) -> list[Key]:
    """Return the keys with that of an alarm before the one to resume all: the first line has the pauses."""
    return _moved(offered, "resume_all", "acknowledge")


def _moved(offered: list[Key], moved: str, behind: str) -> list[Key]:
    """Return the keys, one of them right behind another if both are offered."""
    ids = [key.id for key in offered]
    if not {moved, behind} <= set(ids):
        return offered
    key = offered.pop(ids.index(moved))
    offered.insert([one.id for one in offered].index(behind) + 1, key)
    return offered


def _rank(key: Key, pane: Pane) -> tuple[bool, ...]:
    """Return the sort key of a hint: the pane's own keys first; at a table those of tables after the commands
    that every dispatcher needs."""
    if pane is Pane.ROWS:
        return key.id not in FOR_EVERYONE, not key.of_rows, key.pane is not pane
    return (key.pane is not pane,)


def _of_overlay(offered: Collection[Key], about_robot: bool) -> list[Key]:
    """Return the keys that work in an overlay."""
    close = replace(BY_ID["back"], hint=Message("close"))
    helping = [key for key in offered if key.helps and about_robot]
    helping.sort(key=lambda key: not key.id.startswith(("next_", "previous_")))
    return [close, *helping, *(key for key in offered if key.pane is Pane.ANYWHERE)]


def footer(
    left: Collection[Key], right: Collection[Key], keys: Mapping[str, tuple[str, ...]], width: int
) -> tuple[list[Run], list[Button]]:
    """Return the hints that fit whole into `width` cells, and their cells, each button with the id of its
    key. The permanent ones are placed first, then the others up to the first that does not fit."""
    own = [key for key in left if key.id == "acknowledge"]
    others = [key for key in left if key not in own]
    # Whose alarm is acknowledged comes before the palette, and before other keys at the left.
    for permanent in (right, [key for key in right if key.id != "palette"], list(right)[:1]):
        at_right = _whole(permanent, keys, width)
        at_left = _whole(left, keys, width - _cells(at_right))
        acknowledging = _whole(own, keys, width - _cells(at_right))
        if own and own[0] not in [key for key, *_ in at_left]:
            at_left = _whole(others, keys, width - _cells(at_right) - _cells(acknowledging)) + acknowledging
        if len(acknowledging) == len(own):
            break
    gap = width - _cells(at_left) - _cells(at_right)
    runs: list[Run] = []
    buttons = []
    for key, parts, size in (*at_left, (None, [(" " * gap, StyleRole.TEXT)], gap), *at_right):
        start = width_of(runs)
        runs += parts
        if key is not None:
            buttons.append(Button(start, start + size, key.id))
    return runs, buttons


Hint = tuple[Key, list[Run], int]
"""A key with its runs and their cells."""


def _cells(hints: Collection[Hint]) -> int:
    return sum(size for _, _, size in hints)


def _whole(offered: Collection[Key], keys: Mapping[str, tuple[str, ...]], width: int) -> list[Hint]:
    """Return the first keys that fit into `width` cells, each with its runs and their width."""
    kept = []
    for key in offered:
        name = key_name(keys[key.id][0])
        parts = [(f" {name} ", StyleRole.KEY), (f"{translate(key.hint)} ", StyleRole.DIM)]
        width -= width_of(parts)
        if width < 0:
            break
        kept.append((key, parts, width_of(parts)))
    return kept
