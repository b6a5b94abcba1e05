"""The reasons why a robot stands still, as lines of text."""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from fleet_tui.keys import BY_ID
from fleet_tui.keys.key import key_name
from fleet_tui.model.alarm import class_of
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import natural
from fleet_tui.model.robot import Robot
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.alarms.trouble import acknowledged, in_trouble
from fleet_tui.situation.battery.charging import CHARGES, ON_ITS_WAY
from fleet_tui.situation.reported_motion import STANDS_AFTER, says_driving
from fleet_tui.situation.why.complaints import Complaint
from fleet_tui.situation.why.place import place_text
from fleet_tui.situation.why.reason import Reason, Strength, stationary_since
from fleet_tui.situation.why.robot import moves
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age, ago
from fleet_tui.ui.view.lines.hints import hidden_keys

if TYPE_CHECKING:  # numpy
    from fleet_tui.situation.pose_checks.match import Match

_AGE = re.compile(r"\d (ms|s|min|h|d)\b")
"""A duration in the name of a reason."""
SHOWN = 5
"""Number of reasons that fit on a small terminal; the weakest are dropped."""
UNBROKEN = "\u00a0"
"""A space at which no line is broken."""
ACTS = {
    "battery": ("charge", "order"),
    "command": ("pause", "cancel"),
    "data": ("diagnostics",),
    "issue": ("robot_page", "facilities"),
    "localisation": ("pause", "pose", "diagnostics"),
}
"""The ids of keys for what a class of alarms asks to do."""

STRENGTHS = {
    Strength.CERTAIN: Message("certain"),
    Strength.LIKELY: Message("likely"),
    Strength.POSSIBLE: Message("possible"),
}


def why_lines(
    state: FleetState,
    robot: Robot,
    keys: Mapping[str, tuple[str, ...]],
    match: "Match | None" = None,
    impact: Sequence[str] = (),
    complaints: Sequence[Complaint] = (),
    load: Reason | None = None,
    is_brief: bool = False,
) -> list[str]:
    """Return the time without movement, then each reason: name, evidence, age and the keys that help;
    `match`, `complaints` and `load` as for `reasons`; `impact`: the lines about orders whose way is cut.
    `is_brief`: only the first reason has its evidence, and each key is named once."""
    found, hidden = reasons(state, robot, match, complaints, load), hidden_keys(state, robot.name)
    if found and moves(state, robot) == found[0]:
        alarms = [*_alarms(state, robot, keys, hidden), *impact]
        return [
            f"{translate(sanitize(found[0].name))} ({translate(found[0].evidence)})",
            *alarms,
            *_others(state, robot, keys),
        ]
    lines = [_standing(state, robot, found[0])]
    for number, reason in enumerate(found[:SHOWN], 1):
        told = _numbered(state, robot, reason, number, is_brief and number > 1)
        helped = [f"    {line}" for line in _help_lines(reason.keys, keys, hidden)]
        lines += ["", *told, *(line for line in helped if not is_brief or line not in lines)]
    return [*lines, *impact, *_others(state, robot, keys)]


def _numbered(state: FleetState, robot: Robot, reason: Reason, number: int, is_brief: bool) -> Iterator[str]:
    """Yield a reason and what is known of it, in brief only what to do."""
    mark = "▶" if number == 1 else " "
    strength = "" if reason.strength is Strength.NONE else f"  ({translate(STRENGTHS[reason.strength])})"
    yield f"{mark} {number}. {translate(sanitize(reason.name))}{strength}"
    known = (translate(sanitize(reason.evidence)), _age(state, robot, reason))
    evidence = "" if is_brief else ", ".join(filter(None, known))
    yield from (f"    {line}" for line in (evidence, translate(reason.remedy)) if line)


def _alarms(
    state: FleetState, robot: Robot, keys: Mapping[str, tuple[str, ...]], hidden: Collection[str]
) -> Iterator[str]:
    """Yield the alarms of a robot that moves, and what to do: they are no reasons to stand."""
    for alarm in state.alarms:
        if alarm.holds and alarm.condition.source == robot.name:
            class_ = class_of(alarm.condition.kind)
            yield from (
                "",
                f"▲ {translate(sanitize(alarm.text))}",
                f"    {translate(action_of(alarm.condition))}",
            )
            acts = () if alarm.condition.remedy in (ON_ITS_WAY, CHARGES) else ACTS.get(class_, ())
            yield from (f"    {line}" for line in _help_lines(acts, keys, hidden))


def _others(state: FleetState, robot: Robot, keys: Mapping[str, tuple[str, ...]]) -> Iterator[str]:
    """Yield who else is in trouble if this robot is not: who asks why may mean that one."""
    troubled = sorted(in_trouble(state) - acknowledged(state), key=natural)
    if not troubled or robot.name in troubled or not keys["next_trouble"]:
        return
    key = key_name(keys["next_trouble"][0])
    name, others = sanitize(troubled[0]), len(troubled)
    yield ""
    if others == 1:
        yield tr("{name} is in trouble: {key} goes there", name=name, key=key)
    else:
        yield tr("{others} other robots are in trouble: {key} goes there", others=others, key=key)


def _standing(state: FleetState, robot: Robot, first: Reason) -> str:
    """Return for how long it stands, unless the first reason says since when, and where."""
    place = translate(sanitize(place_text(robot)))
    seen = (
        f"{place[:1].upper()}{place[1:]}."
        if state.is_fresh(robot, "pose")
        else tr("Last seen {place}.", place=place)
    )
    has_age = first.since != stationary_since(robot) or _AGE.search(first.name) is not None
    is_dated = first.since is not None and has_age
    if place and is_dated and state.is_old(robot, "pose"):
        return seen
    movement = _movement(state, robot, is_dated)
    return f"{movement} {seen}" if place else movement


def _movement(state: FleetState, robot: Robot, is_dated: bool) -> str:
    if "pose" not in robot.kind.reports:
        return tr("Position not reported by this kind of robot.")
    if robot.pose is None or robot.standing is None:
        return tr("No pose received.")
    if state.is_old(robot, "pose"):
        return tr("Last pose {age} old.", age=age(state.now - robot.pose.at))
    if says_driving(state, robot):
        return tr("It reports that it drives.")
    still = robot.still_for
    if says_driving(state, robot) is None and still < STANDS_AFTER:
        return tr("Pose changing.")
    return tr("Not moving.") if is_dated else tr("No movement for {age}.", age=age(still))


def _age(state: FleetState, robot: Robot, reason: Reason) -> str:
    """Return since when a reason holds, unless its name or the first line says so, and when it was
    reported."""
    parts, is_told = [], reason.since == stationary_since(robot) or _AGE.search(reason.name)
    if reason.since is not None and not is_told:
        parts.append(tr("for {age}", age=age(state.now - reason.since)))
    if reason.seen is not None:
        parts.append(tr("reported {ago}", ago=translate(ago(reason.seen, state.now))))
    return ", ".join(part.replace(" ", UNBROKEN) for part in parts)


def _help_lines(
    ids: Iterable[str], keys: Mapping[str, tuple[str, ...]], hidden: Collection[str]
) -> Iterator[str]:
    """Yield one line of the keys, each with its hint in one piece: no space breaks it."""
    shown = [(keys[id_], BY_ID[id_]) for id_ in ids if id_ not in hidden]
    named = [
        (
            key_name(pressed[0]) if pressed else tr("(palette)"),
            translate(key.hint).replace(" ", UNBROKEN) or translate(key.text).partition(":")[0],
        )
        for pressed, key in shown
    ]
    if named:
        yield "   ".join(map(UNBROKEN.join, named))
