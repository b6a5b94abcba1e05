"""Alarms with the life cycle of ISA-18.2: raised, acknowledged, returned, cleared.

A condition holds or it doesn't; an alarm remembers that it held until a person has seen it.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import Enum


class Priority(Enum):
    """How soon a person is needed; the value sorts, 1 first."""

    HIGH = 1
    MEDIUM = 2
    LOW = 3


@dataclass(frozen=True, slots=True)
class Condition:
    """Something that needs a person now. `text` says it while it holds, `over` once it is over."""

    source: str
    kind: str
    priority: Priority
    text: str
    over: str


@dataclass(frozen=True, slots=True)
class Alarm:
    """A condition's memory: `first_wall` (Unix seconds) is when it was raised, `count` how often
    since then, `active` whether it still holds."""

    condition: Condition
    first_wall: float
    last_seen: float
    count: int = 1
    active: bool = True
    acknowledged: bool = False

    @property
    def key(self) -> tuple[str, str]:
        """What tells one alarm from another."""
        return self.condition.source, self.condition.kind

    @property
    def text(self) -> str:
        """What it says now: the words of an alarm stand on the screen only while they are true."""
        return self.condition.text if self.active else self.condition.over


def ripen(
    alarms: tuple[Alarm, ...], conditions: Iterable[Condition], at: float, wall: float
) -> tuple[Alarm, ...]:
    """The alarms after a look at what holds now, oldest first, at most one for each condition."""
    holding = {(condition.source, condition.kind): condition for condition in conditions}
    result = []
    for alarm in alarms:
        condition = holding.pop(alarm.key, None)
        if condition is not None:
            again = not alarm.active
            result.append(
                replace(
                    alarm,
                    condition=condition,
                    active=True,
                    last_seen=at,
                    count=alarm.count + again,
                    acknowledged=alarm.acknowledged and not again,
                )
            )
        elif not alarm.acknowledged:
            result.append(replace(alarm, active=False) if alarm.active else alarm)
    result.extend(Alarm(condition, wall, at) for condition in holding.values())
    return tuple(result)


def acknowledge(alarms: tuple[Alarm, ...], source: str, kind: str) -> tuple[Alarm, ...]:
    """The alarms after a person saw one of them, or with an empty `kind` all. One that is over goes."""
    seen = (
        replace(alarm, acknowledged=True) if not kind or alarm.key == (source, kind) else alarm
        for alarm in alarms
    )
    return tuple(alarm for alarm in seen if alarm.active or not alarm.acknowledged)
