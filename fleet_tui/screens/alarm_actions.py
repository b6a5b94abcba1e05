"""What an operator can do about an alarm."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING

from fleet_tui.model.alarm import Alarm, AlarmStage
from fleet_tui.model.events import AlarmAcknowledged, AlarmShelved, AlarmUnshelved
from fleet_tui.model.fleet import FleetState
from fleet_tui.screens.command_actions import CommandActions
from fleet_tui.text.durations import age
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.tables.alarms import alarm_table, unacknowledged
from fleet_tui.widgets.rows_pane import RowsPane

if TYPE_CHECKING:
    from fleet_tui.screens.menu import Entry

SHOWN = 3
"""Robots of a group that its menu can go to."""


class AlarmActions(CommandActions):
    """Acknowledge, put on the shelf, go to the robot."""

    alarms: RowsPane
    keys: Mapping[str, tuple[str, ...]]
    clock: Callable[[float], str]

    def show_alarms(self, state: FleetState) -> None:
        """Show the newest alarms. Unless somebody is at it, the cursor leaves what has been seen for
        what has not; it never leaves an alarm that an `a` on its way may mean."""
        fresh = unacknowledged(state)
        if fresh and self.alarms.cursor not in fresh and not self.alarms.has_focus:
            self.alarms.cursor = fresh[0]
        self.alarms.show(alarm_table(state, self.clock))

    def action_acknowledge(self) -> None:
        """Acknowledge the alarm under the cursor, and go to the next: the row moves to those seen."""
        key, fresh = self.alarms.cursor, unacknowledged(self.state)
        if not isinstance(key, tuple):
            return
        self.tell(AlarmAcknowledged(*key))
        if key in fresh and len(fresh) > 1:
            following = [*fresh[fresh.index(key) + 1 :], *fresh]
            self.alarms.cursor = following[0]

    def action_acknowledge_all(self) -> None:
        """Acknowledge every alarm."""
        self.tell(AlarmAcknowledged())

    def alarm_menu(self, source: str, kind: str) -> None:
        """What can be done with an alarm."""
        alarm = next((one for one in self.state.alarms if one.key == (source, kind)), None)
        if alarm is None:
            self.say(f"the alarm of {source} is over")
            return
        first, last = self.clock(alarm.first_wall), self.clock(alarm.last_wall)
        seen = f"first seen {first}, last seen {last}, x{alarm.count}"
        title = f"{source}: {sanitize(alarm.text)}\n{seen}"
        self.menu.show(title, [*self._ways_to(alarm), *self._answers(alarm)])

    def _ways_to(self, alarm: Alarm) -> "Iterator[Entry]":
        """To the robot, or to some of a group."""
        whose = {alarm.condition.source, *alarm.condition.parts}
        for name in [name for name in self.state.robots if name in whose][:SHOWN]:
            yield f"Show {name} on the map", partial(self.find_robot, name)

    def _answers(self, alarm: Alarm) -> "Iterator[Entry]":
        if alarm.needs_acknowledgement:
            key = " ".join(self.keys["acknowledge"])
            yield f"Acknowledge ({key})", partial(self.tell, AlarmAcknowledged(*alarm.key))
        if alarm.stage is AlarmStage.SHELVED:
            yield "Take off the shelf", partial(self.tell, AlarmUnshelved(*alarm.key))
        seconds = self.state.limits.shelve_for
        until = self.state.now + seconds
        yield f"Shelve for {age(seconds)}", partial(self.tell, AlarmShelved(*alarm.key, until))
