"""The desk of one console: its thread writes what is new here, and posts what is new elsewhere as events."""

import logging
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import NamedTuple

from msgspec.structs import replace

from fleet_tui.config.rights import permissions_of
from fleet_tui.config.schema import Config
from fleet_tui.model.alarm import AlarmStage, AlarmStep, Key, transitions
from fleet_tui.model.desk.desk import Colleague
from fleet_tui.model.desk.events import (
    AlarmAcknowledged,
    AlarmShelved,
    AlarmUnshelved,
    ColleaguesSeen,
    DeskJoined,
    EdgeClosed,
    EdgeOpened,
)
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Note
from fleet_tui.model.problem import Right
from fleet_tui.records.desk.commands import elsewhere_event, own_steps
from fleet_tui.records.desk.fact_file import FactFile, lasts
from fleet_tui.records.desk.facts import (
    Fact,
    SharedAcknowledgement,
    SharedClosure,
    SharedCommand,
    SharedNote,
    SharedShelving,
)
from fleet_tui.records.desk.outbox import FactOutbox
from fleet_tui.records.desk.presence import Presence, PresenceFile, PresenceReader, boot_id
from fleet_tui.state.store import Store
from fleet_tui.storage.worker import Worker
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize

LOG = logging.getLogger(__name__)

EVERY = 0.25
"""Seconds between two looks at the folder."""
SLOW = 2.0
"""Seconds of one look after which the folder does not respond."""
LAST_CHANCE = 0.5
"""Seconds at the end after which an unresponsive folder is given up."""
AT_ONCE = 100
"""Facts that are taken with one look: thousands at once would hold the screen."""
NAME = 40
"""Characters of a name of another console that are shown."""
NOTES_FOR = 24 * 3600.0
"""Seconds for which notes are told to a console that has just come."""


WAITS = 2.0
"""Seconds for which an answer waits for its alarm: consoles raise one at slightly different times."""
ADOPTS = 30.0
"""Seconds after its start in which a console adopts the answers of those that were there before."""


def shown(name: str) -> str:
    """Return a name of another console as one short line of safe text."""
    return sanitize(name)[:NAME] or "unknown"


class SharedDesk:
    """One console's part of the desk. `selected` returns the robot that it looks at."""

    def __init__(self, folder: Path, store: Store, name: str, shares: bool = True) -> None:
        """A console that does not `share` is there, and keeps its own acts to itself."""
        self._folder = folder
        self._store = store
        self._name = name
        self._post: Callable[[Event], object] = lambda _event: None
        self.selected: Callable[[], str] = lambda: ""
        self.on_note: Callable[[Note, bool], None] = lambda _note, _is_new: None
        """Called in the desk's thread with a note of another console, and whether it was made just now."""
        self._boot = boot_id()
        self._shares = shares
        self._presence = PresenceFile(folder)
        self._facts = FactFile(folder)
        self._reader = PresenceReader(folder, self._presence.id)
        self._replies = Replies(store)
        self._outbox = FactOutbox(self._facts, self._presence.id, name)
        self._others: tuple[Colleague, ...] | None = None
        self._problems: tuple[str, ...] = ()
        self._untaken = deque[tuple[Fact, bool]]()
        self._worker = Worker("desk", self._step, EVERY, self._end)

    @property
    def notes(self) -> list[Message]:
        """Return notes for the operator; empty while all is shared."""
        if self._worker.busy_for > SLOW:
            return [Message("desk: not responding, nothing is shared")]
        ignored = self._facts.ignored + self._reader.ignored
        told = (
            [Message("desk: {ignored} entries ignored: not of a console", ignored=ignored)] if ignored else []
        )
        lost = [Message("desk: {lost} facts not shared", lost=self._outbox.lost)] if self._outbox.lost else []
        grows = self._facts.grows
        large = (
            [Message("desk: facts.jsonl grows, it can't be shortened: {problem}", problem=grows)]
            if grows
            else []
        )
        return [
            *(Message("desk: not shared: {problem}", problem=one) for one in self._problems),
            *lost,
            *large,
            *told,
        ]

    def start(self, post: Callable[[Event], object]) -> None:
        """Join the desk; `post` applies an event."""
        self._post = self._replies.send = post
        post(DeskJoined(self._name))
        self._store.watchers.append(self.watch)
        self._worker.start()

    def close(self) -> None:
        """Leave the desk: this console's claims end."""
        with suppress(ValueError):
            self._store.watchers.remove(self.watch)
        self._worker.close(LAST_CHANCE)

    def watch(self, before: FleetState, after: FleetState) -> None:
        """Share what this console's operator did; written later."""
        if not self._shares:
            return
        for fields in own_steps(before, after):
            self._share(SharedCommand, **fields)
        if after.desk.acted:
            return
        if after.desk.closed is not before.desk.closed:
            self._share_edges(before, after)
        if after.now == before.now:  # else time did it
            self._share_answers(before, after)

    def _share_edges(self, before: FleetState, after: FleetState) -> None:
        was, now = ({edge.ends: edge for edge in state.desk.closed} for state in (before, after))
        for ends in sorted(was.keys() - now.keys()):
            self._share(SharedClosure, ends=ends, closed=False)
        for edge in after.desk.closed:  # one closed twice, too: somebody may just open it
            if was.get(edge.ends) != edge:
                self._share(SharedClosure, ends=edge.ends, closed=True, wall=edge.wall)

    def _share_answers(self, before: FleetState, after: FleetState) -> None:
        for change in transitions(before.alarms, after.alarms, after.wall):
            source, kind = change.alarm.key
            if change.step is AlarmStep.ACKNOWLEDGE:
                self._share(SharedAcknowledgement, source=source, kind=kind)
            elif change.step in (AlarmStep.SHELVE, AlarmStep.UNSHELVE):
                left = change.alarm.shelved_until - after.now if change.step is AlarmStep.SHELVE else 0.0
                self._share(SharedShelving, source=source, kind=kind, seconds=max(0.0, left))

    def share_note(self, note: Note) -> None:
        """Tell the other consoles a remark for whoever takes over."""
        if self._shares:
            self._share(SharedNote, text=note.text, wall=note.at)

    def _share(self, kind: type[Fact], /, **fields: object) -> None:
        self._outbox.tell(kind, **fields)
        self._worker.wake()

    def _step(self) -> None:
        self._problems = self._tried(self._keep_presence, self._write, self._read, self._look)

    def _tried(self, *works: Callable[[], None]) -> tuple[str, ...]:
        """Return what could not be done: whatever fails, the rest goes on."""
        problems = dict[str, None]()
        for work in works:
            try:
                work()
            except OSError as problem:
                problems[f"{self._folder}: {problem.strerror or problem}"] = None
            except Exception:
                LOG.exception("desk")  # a mistake of ours must not end the desk
                problems["internal error: see the log file"] = None
        return tuple(problems)

    def _end(self) -> None:
        self._tried(self._write)
        self._presence.close()
        self._facts.close()

    def _keep_presence(self) -> None:
        self._presence.keep(self._own())

    def _own(self) -> Presence:
        """Return this console as the others see it."""
        state = self._store.state
        seen, shelved = list[tuple[str, str]](), list[tuple[str, str, float]]()
        for alarm in state.alarms[:1000]:
            if alarm.stage is AlarmStage.ACKNOWLEDGED:
                seen.append(alarm.key)
            elif alarm.stage is AlarmStage.SHELVED:
                # To the minute: the file is written when it changes.
                shelved.append((*alarm.key, round((alarm.shelved_until - state.now) / 60) * 60.0))
        return Presence(
            self._presence.id,
            self._name[:200],
            self._presence.id.rpartition("-")[0].rpartition("-")[0],
            self._boot,
            self.selected(),
            state.desk.claims,
            tuple(seen) if self._shares else (),
            tuple(shelved) if self._shares else (),
        )

    def _write(self) -> None:
        """Append what waits, as it is now."""
        self._outbox.send(partial(answer_as_now, self._store.state))
        if self._shares:
            self._facts.shorten(time.monotonic())

    def _read(self) -> None:
        """Apply what others told, in the order of the file; of edges also this console's own."""
        if not self._untaken:  # else the next ones wait in the file
            is_new = not self._facts.is_past
            self._untaken.extend((fact, is_new) for fact in self._facts.read() if is_new or lasts(fact))
        for _ in range(min(len(self._untaken), AT_ONCE)):
            fact, is_new = self._untaken.popleft()
            if isinstance(fact, SharedClosure):
                self._apply_closure(fact)
            elif fact.console == self._presence.id:
                continue
            elif isinstance(fact, SharedNote):
                now = time.time()
                if is_new or now - fact.wall < NOTES_FOR:  # no clock of others writes into the future
                    self.on_note(Note(min(fact.wall, now), shown(fact.by), fact.text), is_new)
            elif not is_new:
                continue
            elif isinstance(fact, SharedCommand):
                self._post(elsewhere_event(fact, shown(fact.by)))
            else:
                self._replies.take(fact, shown(fact.by))
        self._replies.post()

    def _apply_closure(self, fact: SharedClosure) -> None:
        by = shown(fact.by)
        self._post(EdgeClosed(fact.ends, fact.wall, by) if fact.closed else EdgeOpened(fact.ends, by))

    def _look(self) -> None:
        """Post who is there, if that has changed."""
        found = self._reader.look()
        self._replies.adopt([(shown(one.name), one) for one in found])
        others = colleagues(found)
        if others != self._others:
            self._others = others
            self._post(ColleaguesSeen(others))


def colleagues(found: Sequence[Presence]) -> tuple[Colleague, ...]:
    """Return consoles as the state has them."""
    return tuple(Colleague(one.id, shown(one.name), shown(one.host), one.robot, one.claims) for one in found)


@contextmanager
def desk_of(config: Config, store: Store, name: str) -> Iterator[SharedDesk | None]:
    """Provide the desk of the configuration, None without one. The console leaves it at the end."""
    if not config.desk.folder:
        yield None
        return
    may = permissions_of(config)
    shares = may.right >= Right.DISPATCH and not may.read_only
    desk = SharedDesk(config.beside(config.desk.folder), store, name, shares)
    try:
        yield desk
    finally:
        desk.close()


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
