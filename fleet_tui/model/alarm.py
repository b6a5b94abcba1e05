"""Alarms with the life cycle of ISA-18.2, as a table.

A condition holds or it doesn't; an alarm remembers that it held until a person has seen it.
"""

from collections.abc import Iterable, Sequence
from enum import Enum
from operator import is_

from msgspec import Struct
from msgspec.structs import replace

Key = tuple[str, str]
"""Source and kind: what tells one alarm from another."""


class Priority(Enum):
    """The urgency of an alarm; the value sorts, 1 first."""

    HIGH = 1
    MEDIUM = 2
    LOW = 3


class AlarmStage(Enum):
    """The stage of an alarm. A cleared one is no longer in the list."""

    CLEARED = "cleared"
    UNACKNOWLEDGED = "unacknowledged"
    ACKNOWLEDGED = "acknowledged"
    RETURNED = "returned unacknowledged"
    SHELVED = "shelved"


class AlarmStep(Enum):
    """A transition from one stage to another."""

    RAISE = "raised"
    WORSEN = "worse"
    RETURN = "returned"
    ACKNOWLEDGE = "acknowledged"
    SHELVE = "shelved"
    UNSHELVE = "unshelved"


TRANSITIONS = {
    (AlarmStage.CLEARED, AlarmStep.RAISE): AlarmStage.UNACKNOWLEDGED,
    (AlarmStage.UNACKNOWLEDGED, AlarmStep.ACKNOWLEDGE): AlarmStage.ACKNOWLEDGED,
    (AlarmStage.UNACKNOWLEDGED, AlarmStep.RETURN): AlarmStage.RETURNED,
    (AlarmStage.UNACKNOWLEDGED, AlarmStep.SHELVE): AlarmStage.SHELVED,
    (AlarmStage.ACKNOWLEDGED, AlarmStep.WORSEN): AlarmStage.UNACKNOWLEDGED,
    (AlarmStage.ACKNOWLEDGED, AlarmStep.RETURN): AlarmStage.CLEARED,
    (AlarmStage.ACKNOWLEDGED, AlarmStep.SHELVE): AlarmStage.SHELVED,
    (AlarmStage.RETURNED, AlarmStep.RAISE): AlarmStage.UNACKNOWLEDGED,
    (AlarmStage.RETURNED, AlarmStep.ACKNOWLEDGE): AlarmStage.CLEARED,
    (AlarmStage.RETURNED, AlarmStep.SHELVE): AlarmStage.SHELVED,
    (AlarmStage.SHELVED, AlarmStep.UNSHELVE): AlarmStage.UNACKNOWLEDGED,  # it still holds
    (AlarmStage.SHELVED, AlarmStep.RETURN): AlarmStage.CLEARED,  # off the shelf, and it is over
}
_STEPS = {(was, now): step for (was, step), now in TRANSITIONS.items()}


class Condition(Struct, frozen=True):
    """Something that needs a person now. `text` says it while it holds, `over` once it is over.

    It is an alarm after the monotonic second `due`. `parts` is what it is made of, where that is
    several things (robots of a group, failed commands): a new one is news.
    """

    source: str
    kind: str
    priority: Priority
    text: str
    over: str
    due: float = float("-inf")
    parts: frozenset[str] = frozenset()

    @property
    def key(self) -> Key:
        """Return what tells its alarm from another."""
        return self.source, self.kind

    def is_news_after(self, before: "Condition") -> bool:
        """Tell whether who has seen `before` must look again."""
        return self.priority.value < before.priority.value or not self.parts <= before.parts


class Alarm(Struct, frozen=True):
    """A condition's memory: `first_wall` and `last_wall` (Unix seconds) are when it was raised and
    when it held last, `count` how often it came since then. `held_at` is monotonic: when it held
    last; `until` too: to when it is on the shelf. `holds` is False in the off-delay as well."""

    condition: Condition
    first_wall: float
    last_wall: float
    held_at: float
    stage: AlarmStage = AlarmStage.UNACKNOWLEDGED
    count: int = 1
    holds: bool = True
    until: float = 0.0

    @property
    def key(self) -> Key:
        """Return what tells one alarm from another."""
        return self.condition.key

    @property
    def needs_acknowledgement(self) -> bool:
        """Tell whether nobody has seen it yet."""
        return self.stage in (AlarmStage.UNACKNOWLEDGED, AlarmStage.RETURNED)

    @property
    def text(self) -> str:
        """Return what it says now: the words of an alarm stand on the screen only while they are true."""
        return self.condition.text if self.holds else self.condition.over


def _stepped(alarm: Alarm, step: AlarmStep) -> Alarm:
    """The alarm after a step; one that the table doesn't have changes nothing."""
    stage = TRANSITIONS.get((alarm.stage, step))
    return alarm if stage is None else replace(alarm, stage=stage)


def _holding(alarm: Alarm, condition: Condition, at: float, wall: float) -> Alarm:
    came = max(len(condition.parts - alarm.condition.parts), not alarm.holds)
    news = condition.is_news_after(alarm.condition)
    alarm = replace(
        alarm, condition=condition, holds=True, held_at=at, last_wall=wall, count=alarm.count + came
    )
    if alarm.stage is AlarmStage.RETURNED:
        return _stepped(alarm, AlarmStep.RAISE)
    return _stepped(alarm, AlarmStep.WORSEN) if news else alarm


def _not_holding(alarm: Alarm, at: float, clear_after: float) -> Alarm:
    """Until it has been away for `clear_after` seconds it may as well come back."""
    if alarm.holds:
        alarm = replace(alarm, holds=False)
    away = at - alarm.held_at >= clear_after
    return _stepped(alarm, AlarmStep.RETURN) if away and alarm.stage is not AlarmStage.SHELVED else alarm


def _off_the_shelf(alarm: Alarm) -> Alarm:
    return _stepped(alarm, AlarmStep.UNSHELVE if alarm.holds else AlarmStep.RETURN)


def advance(
    alarms: Sequence[Alarm],
    conditions: Iterable[Condition],
    at: float,
    wall: float,
    clear_after: float = 0.0,
) -> tuple[Alarm, ...]:
    """The alarms after a look at what holds now, oldest first, at most one for each condition."""
    holding = {condition.key: condition for condition in conditions}
    result: list[Alarm] = []
    for alarm in alarms:
        condition = holding.pop(alarm.key, None)
        if condition is not None:
            alarm = _holding(alarm, condition, at, wall)
        else:
            alarm = _not_holding(alarm, at, clear_after)
        if alarm.stage is AlarmStage.SHELVED and at >= alarm.until:
            alarm = _off_the_shelf(alarm)
        if alarm.stage is not AlarmStage.CLEARED:
            result.append(alarm)
    result.extend(
        Alarm(condition, wall, wall, at, count=max(1, len(condition.parts))) for condition in holding.values()
    )
    # The same object says at once that nothing changed: who keeps a history compares ten times a second.
    is_same = len(result) == len(alarms) and all(map(is_, result, alarms))
    return tuple(alarms if is_same else result)


def acknowledge(alarms: Sequence[Alarm], source: str, kind: str) -> tuple[Alarm, ...]:
    """The alarms after a person saw one of them, or with an empty `kind` all. One that is over goes."""
    seen = (
        _stepped(alarm, AlarmStep.ACKNOWLEDGE) if not kind or alarm.key == (source, kind) else alarm
        for alarm in alarms
    )
    return tuple(alarm for alarm in seen if alarm.stage is not AlarmStage.CLEARED)


def shelve(alarms: Sequence[Alarm], key: Key, until: float) -> tuple[Alarm, ...]:
    """The alarms after one was put on the shelf until a monotonic second."""
    return tuple(
        replace(_stepped(alarm, AlarmStep.SHELVE), until=until) if alarm.key == key else alarm
        for alarm in alarms
    )


def unshelve(alarms: Sequence[Alarm], key: Key) -> tuple[Alarm, ...]:
    """The alarms after one was taken off the shelf: it needs a person again, if it still holds."""
    taken = (
        _off_the_shelf(alarm) if alarm.key == key and alarm.stage is AlarmStage.SHELVED else alarm
        for alarm in alarms
    )
    return tuple(alarm for alarm in taken if alarm.stage is not AlarmStage.CLEARED)


class AlarmChange(Struct, frozen=True):
    """One step of one alarm, for who keeps a history: the alarm after it, or the last that was
    known of one that was cleared; `wall` is Unix seconds."""

    alarm: Alarm
    was: AlarmStage
    step: AlarmStep
    now: AlarmStage
    wall: float

    @property
    def word(self) -> str:
        """The step in one word or two; an alarm that is cleared says that in `now`."""
        again = self.step is AlarmStep.RAISE and self.was is AlarmStage.RETURNED
        return "raised again" if again else self.step.value


def transitions(before: Sequence[Alarm], after: Sequence[Alarm], wall: float) -> list[AlarmChange]:
    """Every step between the alarms before and after one event, in the order of the alarms."""
    if before is after:
        return []
    old = {alarm.key: alarm for alarm in before}
    new = {alarm.key: alarm for alarm in after}
    changes = []
    for key, alarm in {**old, **new}.items():
        was = old[key].stage if key in old else AlarmStage.CLEARED
        now = new[key].stage if key in new else AlarmStage.CLEARED
        step = _STEPS.get((was, now))
        if step is not None:
            changes.append(AlarmChange(alarm, was, step, now, wall))
    return changes
