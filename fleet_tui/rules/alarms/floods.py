"""Many alarms with one cause as one alarm: robots of a link to which the same happens together."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from fleet_tui.model.alarm import Condition, Key, Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.limits import some

Held = Mapping[Key, Condition]
"""What held at the last look."""

FLOOD, FLOOD_SPAN = 5, 3.0
"""So many robots of a link to which the same happens within so many seconds are one alarm."""


class Flood(Struct, frozen=True):
    """The text of a group of alarms of one kind: `text` follows the number of robots."""

    text: str
    over: str
    priority: Priority


FLOODS = {
    "offline": Flood("offline", "robots back online", Priority.HIGH),
    "stuck": Flood("with an order, not moving", "no longer stuck", Priority.MEDIUM),
    "pause": Flood("in a long pause", "pauses ended", Priority.LOW),
    "data": Flood("with bad data", "no new bad data", Priority.LOW),
}


def group_key(link: str, kind: str) -> Key:
    """The alarm of a link's robots to which the same happens."""
    return link, f"many {kind}"


def is_held(held: Held, robot: str, link: str, kind: str) -> bool:
    """Tell whether a robot's condition held at the last look, by itself or in the group."""
    if (robot, kind) in held:
        return True
    group = held.get(group_key(link, kind))
    return group is not None and robot in group.parts


def without_floods(state: FleetState, found: Sequence[Condition], held: Held) -> list[Condition]:
    """Return what of the conditions is due, with those of many robots as one.

    A robot stays where it was counted first until its condition is over.
    """
    due: list[Condition] = []
    kinds: dict[Key, list[Condition]] = defaultdict(list)
    for condition in found:
        robot = state.robots.get(condition.source) if condition.kind in FLOODS else None
        if robot is not None:
            kinds[robot.link, condition.kind].append(condition)
        elif state.now > condition.due:
            due.append(condition)
    for (link, kind), members in kinds.items():
        due.extend(_grouped(state, link, kind, members, held))
    return due


def _grouped(
    state: FleetState, link: str, kind: str, members: Sequence[Condition], held: Held
) -> Iterator[Condition]:
    group = held.get(group_key(link, kind))
    parts = group.parts if group else frozenset()
    loose = [one for one in members if one.key not in held]
    fresh = {one.source for one in loose if state.now > one.due and one.source not in parts}
    # Those that are nearly due, or joined a moment ago: what happens together takes a while.
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
    same = {one.text for one in members}
    text = "never seen" if same == {"never seen"} else flood.text
    return Condition(
        *group_key(link, kind),
        flood.priority,
        f"{len(names)} robot{'s' * (len(names) != 1)} {text}: {some(names)}",
        flood.over,
        parts=frozenset(names),
    )
