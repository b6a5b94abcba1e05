"""Alarm groups: robots of a link with the same condition as one alarm."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from fleet_tui.model.alarm import Condition, Key, Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.facts import NEVER_SEEN, STUCK
from fleet_tui.text.language import Message, counted
from fleet_tui.text.limits import some

ActiveConditions = Mapping[Key, Condition]
"""Conditions of the last check."""

FLOOD = 5
FLOOD_SPAN = 3.0
"""Robots of a link with the same condition within this many seconds are one alarm."""


class Flood(Struct, frozen=True):
    """The text of an alarm group of one kind: `text` follows the number of robots."""

    text: Message
    over: Message
    priority: Priority


FLOODS = {
    "offline": Flood(Message("offline"), Message("robots back online"), Priority.HIGH),
    "stuck": Flood(Message("stuck with an order"), STUCK.over, Priority.MEDIUM),
    "pause": Flood(Message("in a long pause"), Message("pauses ended"), Priority.LOW),
    "localisation": Flood(
        Message("with an uncertain position"), Message("localisation recovered"), Priority.MEDIUM
    ),
    "navigation": Flood(
        Message("with silent navigation"), Message("navigation reports again"), Priority.MEDIUM
    ),
    "data": Flood(Message("with bad data"), Message("no new bad data"), Priority.LOW),
}


def group_key(link: str, kind: str) -> Key:
    """Return the key of a group of a link's robots."""
    return link, f"many {kind}"


def is_group(kind: str) -> bool:
    return kind.startswith("many ") and kind.removeprefix("many ") in FLOODS


def was_active(active: ActiveConditions, robot: str, link: str, kind: str) -> bool:
    """Tell whether a robot's condition held at the last check, by itself or in the group."""
    if (robot, kind) in active:
        return True
    group = active.get(group_key(link, kind))
    return group is not None and robot in group.parts


def without_floods(
    state: FleetState, found: Sequence[Condition], active: ActiveConditions
) -> list[Condition]:
    """Return the due conditions, with those of many robots as one. A robot stays in its first group until its
    condition ends."""
    due: list[Condition] = []
    kinds: dict[Key, list[Condition]] = defaultdict(list)
    for condition in found:
        robot = state.robots.get(condition.source) if condition.kind in FLOODS else None
        if robot is not None:
            kinds[robot.link, condition.kind].append(condition)
        elif state.now > condition.due:
            due.append(condition)
    for (link, kind), members in kinds.items():
        due.extend(_grouped(state, link, kind, members, active))
    return due


def _grouped(
    state: FleetState, link: str, kind: str, members: Sequence[Condition], active: ActiveConditions
) -> Iterator[Condition]:
    group = active.get(group_key(link, kind))
    parts = group.parts if group else frozenset()
    loose = [one for one in members if one.key not in active]
    fresh = {one.source for one in loose if state.now > one.due and one.source not in parts}
    # Those nearly due, or recently added: a common cause takes a while to show.
    near = sum(one.source not in fresh and abs(state.now - one.due) <= FLOOD_SPAN for one in loose)
    grouped = parts | fresh if fresh and len(fresh) + near >= FLOOD else parts
    together = []
    for one in members:
        if state.now > one.due:
            if one.source in grouped:
                together.append(one)
            else:
                yield one
    if together:
        yield _group(link, kind, together)


def _group(link: str, kind: str, members: Sequence[Condition]) -> Condition:
    flood, names = FLOODS[kind], [one.source for one in members]
    same, count = {one.text for one in members}, len(names)
    text = NEVER_SEEN.word if same == {NEVER_SEEN.word} else flood.text
    return Condition(
        *group_key(link, kind),
        flood.priority,
        counted(
            "{count} robot {text}: {some}",
            "{count} robots {text}: {some}",
            count,
            text=text,
            some=some(names),
        ),
        flood.over,
        parts=frozenset(names),
    )
