"""Responses to an alarm: acknowledge, shelve, go to the robot. Its stage is kept in `model/alarm.py`."""

import math
import time
from collections.abc import Callable, Hashable, Iterator, Sequence
from functools import partial

from fleet_tui.commands.routes.charging import way_to_charger
from fleet_tui.model.alarm import Alarm, AlarmStage, Key
from fleet_tui.model.desk.events import AlarmAcknowledged, AlarmShelved, AlarmUnshelved
from fleet_tui.model.events import Event
from fleet_tui.model.sites import of_site, sites_of
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.text.language import Message, counted, joined, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Entry
from fleet_tui.ui.view.tables.alarms import unacknowledged
from fleet_tui.ui.widgets.rows_pane import RowsPane

LOOK = 1.0
"""Seconds in which a person sees that the cursor is on another alarm."""
SHOWN = 3
"""Number of robots of a group that its menu lists."""


class AlarmResponses:
    """Acts on the alarm under the cursor of a pane, or on all of them."""

    def __init__(
        self,
        console: Console,
        *,
        pane: RowsPane,
        why: Callable[[], None],
        robot_menu: Callable[[str], None],
        charge: Callable[[str], None],
        cleared_at: Callable[[], float] = lambda: -math.inf,
    ) -> None:
        """`charge` opens the order of a robot to a charger; `cleared_at`: when the alarm under the cursor
        went by itself last (monotonic)."""
        self._store = console.store
        self._backend = console.backend
        self._notices = console.notices
        self._navigation = console.navigation
        self._pane = pane
        self._open_menu = console.open_menu
        self._why = why
        self._robot_menu = robot_menu
        self._charge = charge
        self._keys = console.settings.keys
        self._clock = console.settings.clock
        self._cleared_at = cleared_at

    def _post(self, event: Event) -> bool:
        """Apply an event; tell whether it was, and say so if not."""
        if problem := self._backend.post(event):
            self._notices.say(problem)
        return not problem

    def acknowledge(self) -> None:
        """Acknowledge the marked alarms, else the one under the cursor, and go to the next: the row moves
        down."""
        if marks := list(self._pane.listing.marks.values()):
            self._acknowledge_marked(marks)
            return
        key, fresh = self._pane.listing.cursor, unacknowledged(self._store.state)
        if not isinstance(key, tuple):
            return
        if time.monotonic() - self._cleared_at() < LOOK:
            self._notices.say(Message("another alarm has just been marked: press again for that one"))
            return
        self._acknowledge((key[0], key[1]))
        if key in fresh and len(fresh) > 1:
            following = [*fresh[fresh.index(key) + 1 :], *fresh]
            self._pane.listing.cursor = following[0]

    def _acknowledge_marked(self, marks: Sequence[Hashable]) -> None:
        self._pane.listing.marks.clear()
        keys = [key for key in unacknowledged(self._store.state) if key in marks]
        if all(self._post(AlarmAcknowledged(*key)) for key in keys):
            self._notices.say(
                counted("acknowledged: {count} alarm", "acknowledged: {count} alarms", len(keys))
            )

    def _acknowledge(self, key: Key) -> None:
        fresh = key in unacknowledged(self._store.state)
        if self._post(AlarmAcknowledged(*key)) and fresh:
            self._notices.note(
                Message(
                    "acknowledged: {kind} alarm of {source}", kind=Message(key[1]), source=sanitize(key[0])
                )
            )

    def acknowledge_all(self) -> None:
        """Acknowledge every alarm, of several sites those of the one that is shown."""
        state = self._store.state
        if not sites_of(state):
            self._post(AlarmAcknowledged())
            return
        for key in unacknowledged(of_site(state, self._navigation.robot)):
            self._post(AlarmAcknowledged(*key))

    def marked_menu(self) -> None:
        """List the actions for the alarm under the cursor."""
        key = self._pane.listing.cursor
        if isinstance(key, tuple):
            self.menu(key[0], key[1])
        else:
            self._notices.say(Message("no alarm"))

    def menu(self, source: str, kind: str) -> None:
        """List the actions for an alarm, and select its robot: what is shown is about one."""
        alarm = next((one for one in self._store.state.alarms if one.key == (source, kind)), None)
        if alarm is None:
            self._notices.say(Message("the alarm of {source} has cleared", source=source))
            return
        if source in self._store.state.robots:
            self._navigation.select(source)
        first, last = self._clock(alarm.first_wall), self._clock(alarm.last_wall)
        seen = Message(
            "first seen {first}, last seen {last}, x{count}", first=first, last=last, count=alarm.count
        )
        title = Message(
            "{source}: {text}\n{action_of}\n{seen}",
            source=source,
            text=translate(sanitize(alarm.text)),
            action_of=translate(action_of(alarm.condition)),
            seen=seen,
        )
        # What is not always offered is last: each number means the same also after an acknowledgement.
        entries = [*self._ways_to(alarm), *self._shelve(alarm), *self._commands(alarm), *self._answers(alarm)]
        self._open_menu(title, entries)

    def _ways_to(self, alarm: Alarm) -> Iterator[Entry]:
        """Return entries that go to the robot, or to some of a group."""
        whose = {alarm.condition.source, *alarm.condition.parts}
        names = [name for name in self._store.state.robots if name in whose]
        if len(names) == 1:
            yield Message("Explain {names}", names=names[0]), partial(self._explain, names[0])
        for name in names[:SHOWN]:
            yield Message("Show {name} on the map", name=name), partial(self._navigation.find_robot, name)

    def _commands(self, alarm: Alarm) -> Iterator[Entry]:
        source = alarm.condition.source
        if source in self._store.state.robots:
            yield (
                Message("Command {source}: pause, order, clear", source=source),
                partial(self._robot_menu, source),
            )
            state = self._store.state
            if alarm.condition.kind == "battery" and (way := way_to_charger(state, state.robots[source])):
                yield (
                    Message("Order {source} to {name}", source=source, name=way[-1].name),
                    partial(self._charge, source),
                )

    def explain(self) -> None:
        """Explain the robot of the marked alarm, the first of a group; else the selected one."""
        marked = [alarm for alarm in self._store.state.alarms if alarm.key == self._pane.listing.cursor]
        whose = [name for one in marked for name in (one.condition.source, *sorted(one.condition.parts))]
        robots = [name for name in whose if name in self._store.state.robots]
        if robots:
            self._explain(robots[0])
        else:
            self._why()

    def _explain(self, robot: str) -> None:
        self._navigation.find_robot(robot)
        self._why()

    def _answers(self, alarm: Alarm) -> Iterator[Entry]:
        if alarm.needs_acknowledgement:
            key = joined(" ", self._keys["acknowledge"])
            yield Message("Acknowledge ({key})", key=key), partial(self._acknowledge, alarm.key)
        if alarm.stage is AlarmStage.SHELVED:
            yield Message("Unshelve"), partial(self._post, AlarmUnshelved(*alarm.key))

    def _shelve(self, alarm: Alarm) -> Iterator[Entry]:
        state = self._store.state
        seconds = state.limits.shelve_for
        shelved = AlarmShelved(*alarm.key, state.now + seconds)
        yield Message("Shelve for {age}", age=age(seconds)), partial(self._post, shelved)
