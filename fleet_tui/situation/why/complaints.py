"""Warnings and errors that a robot reports about itself: in /diagnostics and in its log."""

import re
from collections.abc import Iterable, Iterator

from msgspec import Struct

from fleet_tui.model.counters import LinkCounter, snapshot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.model.ros_logs import (
    Health,
    LogLine,
    PartDiagnosis,
    Severity,
    cause_of,
    follows,
    is_of_bridge,
    named,
    part_of,
    plain,
)
from fleet_tui.situation.alarms.classes import CLASSES
from fleet_tui.situation.causes import DIAGNOSED_WITHIN, LOGGED_WITHIN
from fleet_tui.situation.why.orders import LOOK
from fleet_tui.situation.why.reason import Reason, Strength
from fleet_tui.text.language import EMPTY, Message

SHOWN = 2
"""Complaints that are shown: the worst have the cause, the others mostly follow from it."""

_LEVELS = {level.value: level.name for level in Health if level is not Health.OK}


class Complaint(Struct, frozen=True):
    """A warning or an error of a robot, received at `at` (monotonic seconds) in its `source`; `cause` is the
    same of all that tell of one."""

    text: Message
    source: str
    is_error: bool
    at: float
    cause: str = ""

    @property
    def reason(self) -> Reason:
        """Return it as a reason to stand still."""
        strength = Strength.LIKELY if self.is_error else Strength.POSSIBLE
        evidence, remedy = (
            Message("in the robot's own {source}", source=self.source),
            LOOK if self.is_error and self.source == "diagnostics" else EMPTY,
        )
        page = "health" if self.source == "diagnostics" else "log"
        keys: tuple[str, ...] = ("diagnostics",)
        if "battery" in self.text.casefold():
            remedy, keys = CLASSES["battery"].action, ("order", "diagnostics")
        return Reason(self.text, evidence, strength, seen=self.at, keys=keys, remedy=remedy, page=page)


def complaints(state: FleetState, robot: Robot, counter: LinkCounter | None) -> list[Complaint]:
    """Return the worst complaints of a robot, the errors first, then the lines of its log that began last.
    `counter` is that of its link, None before there is one."""
    if counter is None:
        return []
    name = named([robot.name])
    if sum(one.link == robot.link for one in state.robots.values()) == 1:
        name = re.compile(rf"({name.pattern})?")  # all of its link is its own
    parts = counter.health.values()
    fresh = [part for part in parts if state.now - part.at < DIAGNOSED_WITHIN]
    recent = [line for line in snapshot(counter.log) if state.now - line.at < LOGGED_WITHIN]
    logged, diagnosed = [*_logged(state, recent, name)], [*_diagnosed(fresh, name)]
    found = {one.cause: one for one in sorted((*logged, *diagnosed), key=lambda one: one.is_error)}
    # What is repeated must not change places each time.
    began = {one.cause: one.at for one in reversed(logged)}
    return sorted(found.values(), key=lambda one: (not one.is_error, -began.get(one.cause, 0.0)))[:SHOWN]


def _logged(state: FleetState, lines: Iterable[LogLine], name: re.Pattern[str]) -> Iterator[Complaint]:
    for line in lines:
        severity = line.severity or Severity.INFO
        is_own = name.search(line.node) and not is_of_bridge(line.node)
        if severity >= Severity.WARN and is_own and not follows(line.text):
            text = Message(
                "{part_of}: {name} {plain}",
                part_of=part_of(name, line.node),
                name=severity.name,
                plain=plain(line.text),
            )
            is_error = severity >= Severity.ERROR
            yield Complaint(text, "log", is_error, _written(state, line), cause_of(line.text))


def _written(state: FleetState, line: LogLine) -> float:
    """Return when a line was written (monotonic seconds), as far as its stamp can be trusted: a bridge sends
    the last lines again to who begins to listen."""
    since = state.wall - line.stamp if line.stamp is not None else 0.0
    return min(line.at, state.now - since) if 0.0 <= since < LOGGED_WITHIN else line.at


def _diagnosed(parts: Iterable[PartDiagnosis], name: re.Pattern[str]) -> Iterator[Complaint]:
    for part in parts:
        if part.level in _LEVELS and name.search(f"{part.name} {part.hardware}"):
            text = Message(
                "{part_of}: {levels} {message}",
                part_of=part_of(name, part.name),
                levels=_LEVELS[part.level],
                message=part.message,
            )
            yield Complaint(text, "diagnostics", part.level == Health.ERROR, part.at, cause_of(text))
