"""Alarms with the life cycle of ISA-18.2 (raised, acknowledged, shelved, returned), as a table.

A condition holds or it doesn't. An alarm of a latched class stays until it is acknowledged; the others end
with their condition and remain in the audit log.
"""

from collections.abc import Collection, Iterable, Sequence
from enum import Enum
from operator import is_

from msgspec import Struct, field
from msgspec.structs import replace

from fleet_tui.text.language import EMPTY, Message

Key = tuple[str, str]  # source and kind: the identity of an alarm


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
    CLEAR = "cleared"
    ACKNOWLEDGE = "acknowledged"
    SHELVE = "shelved"
    UNSHELVE = "unshelved"


TRANSITIONS = {
    (AlarmStage.CLEARED, AlarmStep.RAISE): AlarmStage.UNACKNOWLEDGED,
    (AlarmStage.UNACKNOWLEDGED, AlarmStep.ACKNOWLEDGE): AlarmStage.ACKNOWLEDGED,
    (AlarmStage.UNACKNOWLEDGED, AlarmStep.RETURN): AlarmStage.RETURNED,
    (AlarmStage.UNACKNOWLEDGED, AlarmStep.CLEAR): AlarmStage.CLEARED,  # not latched: needs no acknowledgement
    (AlarmStage.UNACKNOWLEDGED, AlarmStep.SHELVE): AlarmStage.SHELVED,
    (AlarmStage.ACKNOWLEDGED, AlarmStep.WORSEN): AlarmStage.UNACKNOWLEDGED,
    (AlarmStage.ACKNOWLEDGED, AlarmStep.RETURN): AlarmStage.CLEARED,
    (AlarmStage.ACKNOWLEDGED, AlarmStep.SHELVE): AlarmStage.SHELVED,
    (AlarmStage.RETURNED, AlarmStep.RAISE): AlarmStage.UNACKNOWLEDGED,
    (AlarmStage.RETURNED, AlarmStep.ACKNOWLEDGE): AlarmStage.CLEARED,
    (AlarmStage.RETURNED, AlarmStep.SHELVE): AlarmStage.SHELVED,
    (AlarmStage.SHELVED, AlarmStep.UNSHELVE): AlarmStage.UNACKNOWLEDGED,  # it still holds
    (AlarmStage.SHELVED, AlarmStep.RETURN): AlarmStage.CLEARED,  # after its shelving
}
_STEPS = {(was, now): step for (was, step), now in TRANSITIONS.items()}
ANSWERS = (AlarmStep.ACKNOWLEDGE, AlarmStep.SHELVE, AlarmStep.UNSHELVE)  # of operators


def class_of(kind: str) -> str:
    """Return the class of alarms that a kind belongs to: a group has that of its members."""
    usual = {"many commands": "command", "order": "command", "frames": "data"}
    return usual.get(kind, kind.removeprefix("many "))


class Condition(Struct, frozen=True):
    """A condition that needs a person now. `text` describes it while it holds, `over` afterwards.

    It is an alarm after the monotonic second `due`. `parts` are the members of a group (robots, failed
    commands): a new one is news. `remedy` is what to do, empty for the action of its class."""

    source: str
    kind: str
    priority: Priority
    text: Message
    over: Message
    due: float = float("-inf")
    parts: frozenset[str] = frozenset()
    remedy: Message = EMPTY

    @property
    def key(self) -> Key:
        return self.source, self.kind

    def is_news_after(self, before: "Condition") -> bool:
        """Tell whether an operator who has seen `before` must look again."""
        return self.priority.value < before.priority.value or not self.parts <= before.parts


class Alarm(Struct, frozen=True):
    """An alarm and its history: `first_wall` and `last_wall` (Unix seconds) are when it was raised, with
    `first_text`, and when it last held, `count` its occurrences since then, `part_wall` when the newest of
    its parts came, 0 if all were there. `held_at` (monotonic) is when it last held, `shelved_until`
    (monotonic) the end of its shelving. `holds` is False during the off-delay as well."""

    condition: Condition
    first_wall: float
    last_wall: float
    held_at: float
    stage: AlarmStage = AlarmStage.UNACKNOWLEDGED
    count: int = 1
    holds: bool = True
    shelved_until: float = field(default=0.0, name="until")  # as recordings have it
    first_text: Message = EMPTY
    part_wall: float = 0.0

    @property
    def shown_wall(self) -> float:
        """Return the time (Unix seconds) to show: of its last change while it holds, else of its end."""
        return max(self.first_wall, self.part_wall) if self.holds else self.last_wall

    @property
    def key(self) -> Key:
        return self.condition.key

    @property
    def needs_acknowledgement(self) -> bool:
        """Tell whether it has not been acknowledged yet."""
        return self.stage in (AlarmStage.UNACKNOWLEDGED, AlarmStage.RETURNED)

    @property
    def text(self) -> Message:
        """Return the current text: the text of the condition is shown only while it holds."""
        return self.condition.text if self.holds else self.condition.over


def _stepped(alarm: Alarm, step: AlarmStep) -> Alarm:
    """Return the alarm after a step; a step that the table doesn't have changes nothing."""
    stage = TRANSITIONS.get((alarm.stage, step))
    return alarm if stage is None else replace(alarm, stage=stage)


def _holding(alarm: Alarm, condition: Condition, at: float, wall: float) -> Alarm:
    new_parts = condition.parts - alarm.condition.parts
    came = max(len(new_parts), not alarm.holds)
    news = condition.is_news_after(alarm.condition)
    alarm = replace(
        alarm,
        condition=condition,
        holds=True,
        held_at=at,
        last_wall=wall,
        count=alarm.count + came,
        part_wall=wall if new_parts else alarm.part_wall,
    )
    if alarm.stage is AlarmStage.RETURNED:
        return _stepped(alarm, AlarmStep.RAISE)
    return _stepped(alarm, AlarmStep.WORSEN) if news else alarm


def _not_holding(alarm: Alarm, at: float, clear_after: float, is_latched: bool) -> Alarm:
    """Off-delay: an alarm returns to normal only after its condition has been absent for `clear_after`
    seconds."""
    if alarm.holds:
        alarm = replace(alarm, holds=False)
    if at - alarm.held_at < clear_after or alarm.stage is AlarmStage.SHELVED:
        return alarm
    clears = alarm.stage is AlarmStage.UNACKNOWLEDGED and not is_latched
    return _stepped(alarm, AlarmStep.CLEAR if clears else AlarmStep.RETURN)


def _off_the_shelf(alarm: Alarm) -> Alarm:
    return _stepped(alarm, AlarmStep.UNSHELVE if alarm.holds else AlarmStep.RETURN)


def advance(
    alarms: Sequence[Alarm],
    conditions: Iterable[Condition],
    at: float,
    wall: float,
    clear_after: float = 0.0,
    latched: Collection[str] | None = None,
) -> tuple[Alarm, ...]:
    """Return the alarms after a check of the current conditions, oldest first, at most one for each. Alarms
    of the classes `latched` (None: all) stay until acknowledged, the others end with their condition."""
    holding = {condition.key: condition for condition in conditions}
    result: list[Alarm] = []
    for alarm in alarms:
        condition = holding.pop(alarm.key, None)
        if condition is not None:
            alarm = _holding(alarm, condition, at, wall)
        else:
            stays = latched is None or class_of(alarm.condition.kind) in latched
            alarm = _not_holding(alarm, at, clear_after, stays)
        if alarm.stage is AlarmStage.SHELVED and at >= alarm.shelved_until:
            alarm = _off_the_shelf(alarm)
        if alarm.stage is not AlarmStage.CLEARED:
            result.append(alarm)
    result.extend(
        Alarm(one, wall, wall, at, count=max(1, len(one.parts)), first_text=one.text)
        for one in holding.values()
    )
    # The same object means no change: the audit log compares ten times a second.
    is_same = len(result) == len(alarms) and all(map(is_, result, alarms))
    return tuple(alarms if is_same else result)


def acknowledge(alarms: Sequence[Alarm], source: str, kind: str) -> tuple[Alarm, ...]:
    """Return the alarms after the acknowledgement of one, or with an empty `kind` of all. An alarm that is
    over is removed."""
    seen = (
        _stepped(alarm, AlarmStep.ACKNOWLEDGE) if not kind or alarm.key == (source, kind) else alarm
        for alarm in alarms
    )
    return tuple(alarm for alarm in seen if alarm.stage is not AlarmStage.CLEARED)


def shelve(alarms: Sequence[Alarm], key: Key, until: float) -> tuple[Alarm, ...]:
    """Return the alarms after one was shelved until a monotonic second."""
    return tuple(
        replace(_stepped(alarm, AlarmStep.SHELVE), shelved_until=until) if alarm.key == key else alarm
        for alarm in alarms
    )


def unshelve(alarms: Sequence[Alarm], key: Key) -> tuple[Alarm, ...]:
    """Return the alarms after one was unshelved: it needs a person again, if it still holds."""
    taken = (
        _off_the_shelf(alarm) if alarm.key == key and alarm.stage is AlarmStage.SHELVED else alarm
        for alarm in alarms
    )
    return tuple(alarm for alarm in taken if alarm.stage is not AlarmStage.CLEARED)


def withdraw(alarms: Sequence[Alarm], keys: Collection[Key]) -> tuple[Alarm, ...]:
    """Return the alarms without those whose cause turned out not to be one."""
    # The same object means no change.
    if not any(alarm.key in keys for alarm in alarms):
        return tuple(alarms)
    return tuple(alarm for alarm in alarms if alarm.key not in keys)


class AlarmChange(Struct, frozen=True):
    """One step of one alarm, for a history: the alarm after it, or the last state of one that was cleared;
    `wall` is Unix seconds."""

    alarm: Alarm
    was: AlarmStage
    step: AlarmStep
    now: AlarmStage
    wall: float

    @property
    def word(self) -> str:
        """Return the step in one or two words; `now` is the final step of a cleared alarm."""
        again = self.step is AlarmStep.RAISE and self.was is AlarmStage.RETURNED
        return "raised again" if again else self.step.value


def transitions(
    before: Sequence[Alarm], after: Sequence[Alarm], wall: float, by_time: bool = False
) -> list[AlarmChange]:
    """Return every step between the alarms before and after one event, in the order of the alarms. `by_time`:
    no operator took it."""
    if before is after:
        return []
    old = {alarm.key: alarm for alarm in before}
    new = {alarm.key: alarm for alarm in after}
    changes = []
    for key, alarm in {**old, **new}.items():
        was = old[key].stage if key in old else AlarmStage.CLEARED
        now = new[key].stage if key in new else AlarmStage.CLEARED
        step = _STEPS.get((was, now))
        if by_time and step in (AlarmStep.ACKNOWLEDGE, AlarmStep.CLEAR) and now is AlarmStage.CLEARED:
            step = AlarmStep.RETURN
        if step is not None:
            changes.append(AlarmChange(alarm, was, step, now, wall))
    return changes
