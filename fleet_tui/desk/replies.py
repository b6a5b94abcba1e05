"""Answers of other consoles to alarms: applied here as soon as the alarm is raised here, too."""

import time
from collections.abc import Callable, Sequence
from typing import NamedTuple

from msgspec.structs import replace

from fleet_tui.desk.facts import Fact, SharedAcknowledgement, SharedShelving
from fleet_tui.desk.presence import Presence
from fleet_tui.model.alarm import AlarmStage, Key
from fleet_tui.model.desk.events import AlarmAcknowledged, AlarmShelved, AlarmUnshelved
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.state.store import Store

WAITS = 2.0
"""Seconds for which an answer waits for its alarm: consoles raise one at slightly different times."""
ADOPTS = 30.0
"""Seconds after its start in which a console adopts the answers of those that were there before."""


def answer_as_now(state: FleetState, fact: Fact) -> Fact | None:
    """Return what this console told, as it is in its state by now: an answer counts no more once its alarm
    was answered otherwise, or came again. Other facts stay as they are."""
    if not isinstance(fact, SharedAcknowledgement | SharedShelving):
        return fact
    alarm = next((one for one in state.alarms if one.key == (fact.source, fact.kind)), None)
    if isinstance(fact, SharedAcknowledgement):
        return None if alarm is not None and alarm.needs_acknowledgement else fact
    is_shelved = alarm is not None and alarm.stage is AlarmStage.SHELVED
    if is_shelved != (fact.seconds > 0):
        return None
    return (
        replace(fact, seconds=alarm.shelved_until - state.now) if alarm is not None and is_shelved else fact
    )


class _Reply(NamedTuple):
    """An answer that waits until `until` (monotonic); `seconds` of shelving, None: acknowledged."""

    by: str
    until: float
    seconds: float | None


class Replies:
    """Answers that wait for their alarms."""

    def __init__(self, store: Store) -> None:
        self._store = store
        self.send: Callable[[Event], object] = lambda _event: None
        """Applies an event."""
        self._waiting: dict[Key, _Reply] = {}
        self._adopts_until = time.monotonic() + ADOPTS
        self._answered: set[Key] = set()
        """Alarms that were answered while this console adopts: what others had done before is over."""

    def take(self, fact: SharedAcknowledgement | SharedShelving, by: str) -> None:
        """Take an answer that was just given."""
        key, until = (fact.source, fact.kind), time.monotonic() + WAITS
        if time.monotonic() <= self._adopts_until:
            self._answered.add(key)
        if isinstance(fact, SharedAcknowledgement):
            self._waiting[key] = _Reply(by, until, None)
        elif fact.seconds:
            self._waiting[key] = _Reply(by, until, fact.seconds)
        else:
            self._waiting.pop(key, None)
            self.send(AlarmUnshelved(*key, by))

    def adopt(self, others: Sequence[tuple[str, Presence]]) -> None:
        """Take what the others have answered, once for each alarm, while this console is new."""
        if time.monotonic() > self._adopts_until:
            self._answered.clear()
            return
        stages = {alarm.key: alarm.stage for alarm in self._store.state.alarms}
        self._answered |= {key for key, stage in stages.items() if stage is not AlarmStage.UNACKNOWLEDGED}
        for by, presence in others:
            shelved = {(source, kind): left for source, kind, left in presence.shelved}
            for key in {*presence.acknowledged, *shelved} & stages.keys() - self._answered:
                self._answered.add(key)
                self._waiting[key] = _Reply(by, time.monotonic() + WAITS, shelved.get(key))
        self.post()

    def post(self) -> None:
        """Post the answers whose alarms are there, and forget those that waited too long."""
        state, now = self._store.state, time.monotonic()
        stages = {alarm.key: alarm.stage for alarm in state.alarms} if self._waiting else {}
        for key, reply in list(self._waiting.items()):
            stage = stages.get(key)
            if reply.seconds is not None and stage is not None:
                self.send(AlarmShelved(*key, state.now + reply.seconds, reply.by))
            elif stage in (AlarmStage.UNACKNOWLEDGED, AlarmStage.RETURNED):
                self.send(AlarmAcknowledged(*key, reply.by))
            elif now < reply.until:
                continue
            del self._waiting[key]
