"""Facts: something that is not as usual now, and its kind, the row of a table that says how it is told."""

import math
from typing import NamedTuple

from fleet_tui.model.alarm import Condition, Priority
from fleet_tui.text.language import EMPTY, Message


class AlarmClass(NamedTuple):
    """A class of alarms, rationalised as in ISA-18.2. `priority` is the usual one; `minutes` is the time
    within which the action still helps."""

    priority: str
    cause: str
    consequence: str
    action: Message
    minutes: float


class FactKind(NamedTuple):
    """A row of the table. `name` is the kind of its alarm, `word` what a row and a reason call it, `over`
    the text once it is gone; `alarm` explains it, None if it raises none; `remedy` is empty for the action of
    the alarm; `keys` are the ids of the keys that help, `page` the page of diagnostics that shows more."""

    name: str
    word: Message
    over: Message = EMPTY
    alarm: AlarmClass | None = None
    remedy: Message = EMPTY
    keys: tuple[str, ...] = ()
    page: str = "topics"

    @property
    def action(self) -> Message:
        """Return what a person is to do about it, unless a fact says more."""
        return self.remedy or (self.alarm.action if self.alarm is not None else EMPTY)


class Fact(NamedTuple):
    """`source` is the robot, the link or the console; `since` the monotonic second from which it holds,
    `seen` that of the last report of it. `remedy` is empty for that of the row. `text` is that of an alarm,
    `short` that of a row and of `status`, `evidence` the reports that show it, `question` what a command to
    the robot is confirmed with. Not `is_certain`: a late bridge may explain it, or it need not be what
    holds the robot. `parts` are what it consists of: a new one is news."""

    kind: FactKind
    source: str
    text: Message
    priority: Priority
    since: float
    remedy: Message = EMPTY
    short: Message = EMPTY
    evidence: Message = EMPTY
    question: Message = EMPTY
    seen: float | None = None
    is_certain: bool = True
    parts: frozenset[str] = frozenset()

    @property
    def action(self) -> Message:
        """Return what a person is to do."""
        return self.remedy or self.kind.action

    def condition(self, due: float = -math.inf) -> Condition:
        """Return it as what becomes an alarm at a monotonic second."""
        kind = self.kind
        return Condition(
            self.source, kind.name, self.priority, self.text, kind.over, due, self.parts, self.action
        )
