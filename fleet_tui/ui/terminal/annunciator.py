"""Calls a person to the screen: the terminal's bell and its notifications (OSC 9), if configured."""

import os
from collections.abc import Callable

from fleet_tui.config.schema import Alarms
from fleet_tui.model.alarm import Alarm, AlarmStage, Key
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize

QUIET = 5.0
"""Seconds between two calls: alarms raised meanwhile are one call."""
LONGEST = 200
"""Characters of a notification."""


def notification(text: str, inside_tmux: bool) -> str:
    """Return the bytes of a terminal notification. tmux passes them on, or, unless its `allow-passthrough` is
    on, drops them."""
    osc = f"\x1b]9;fleet-tui: {sanitize(text)[:LONGEST]}\x1b\\"
    return "\x1bPtmux;" + osc.replace("\x1b", "\x1b\x1b") + "\x1b\\" if inside_tmux else osc


class Annunciator:
    """Calls once for each alarm that newly needs a person. `send` returns whether the bytes were sent."""

    def __init__(self, alarms: Alarms, send: Callable[[str], bool]) -> None:
        self._bell = alarms.bell
        self._notify = alarms.notify
        # The Linux console would print it on the screen.
        if os.environ.get("TERM") == "linux":
            self._notify = []
        self._inside_tmux = "TMUX" in os.environ
        self._send = send
        self._known: set[Key] = set()
        self._waiting: set[Key] = set()
        self._called_at = float("-inf")

    def look(self, state: FleetState) -> None:
        """Call, if an alarm needs it and the last call was a while ago."""
        new = {alarm.key: alarm for alarm in state.alarms if alarm.stage is AlarmStage.UNACKNOWLEDGED}
        self._waiting = (self._waiting | new.keys() - self._known) & new.keys()
        self._known = set(new)
        if not self._waiting or state.now - self._called_at < QUIET:
            return
        alarms = sorted((new[key] for key in self._waiting), key=lambda one: one.condition.priority.value)
        sequence = self._sequence(alarms)
        if not sequence:
            self._waiting.clear()
        elif self._send(sequence):
            self._waiting.clear()
            self._called_at = state.now

    def _sequence(self, alarms: list[Alarm]) -> str:
        rings = any(_priority(alarm) in self._bell for alarm in alarms)
        notified = [alarm for alarm in alarms if _priority(alarm) in self._notify]
        sequence = "\x07" if rings else ""
        if notified:
            more = Message(" and {count} more", count=len(notified) - 1) if notified[1:] else ""
            sequence += notification(
                f"{notified[0].condition.source} {notified[0].text}{more}", self._inside_tmux
            )
        return sequence


def _priority(alarm: Alarm) -> str:
    return alarm.condition.priority.name.lower()
