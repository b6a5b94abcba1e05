"""Notifications of alarms by a program of the operator's own: a JSON line for each on its standard input."""

import asyncio
import json
import logging
import threading
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

from fleet_tui.config.schema import Notify
from fleet_tui.config.withholding import doubt_of_command
from fleet_tui.model.alarm import Alarm, AlarmStage, Key, class_of
from fleet_tui.model.fleet import FleetState
from fleet_tui.programs.process import EndedProcess, run
from fleet_tui.storage.write_queue import WriteQueue
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.sanitize import sanitize

LOG = logging.getLogger(__name__)

EVERY = 5.0
"""Seconds between two starts of the program: alarms raised meanwhile are lines of one."""
WITHIN = 30.0
"""Seconds after which it is ended."""
MOST = 100
"""Lines that wait for it; of more alarms the oldest are left out, and counted."""


class AlarmProgram:
    """Starts the program for alarms that are new to this console. It never waits for the program.

    `folder` is where it runs; `say` shows the operator, on the screen's thread, that it failed; `is_ours`
    tells whether this console, and no other one of the same site, calls it.
    """

    def __init__(
        self,
        notify: Notify,
        folder: Path,
        say: Callable[[Message], None],
        is_ours: Callable[[], bool] = lambda: True,
    ) -> None:
        self._command = list(notify.command)
        self._classes = frozenset(notify.classes)
        self._folder = folder
        self._say = say
        self._is_ours = is_ours
        self._known: dict[Key, int] = {}
        self._waiting = WriteQueue[str](MOST)
        self._started_at = float("-inf")
        self._running: threading.Thread | None = None
        self._failed = self._said = EMPTY

    def look(self, state: FleetState) -> None:
        """Take new alarms, and start the program if it does not run and the last start was a while ago."""
        if not self._command:
            return
        self._take(state)
        if self._failed != self._said:
            self._said = self._failed
            if self._failed:
                self._say(self._failed)
        is_free = self._running is None or not self._running.is_alive()
        if self._waiting and is_free and not 0.0 <= state.now - self._started_at < EVERY:
            self._started_at = state.now
            self._running = threading.Thread(target=self._run, args=(self._lines(),), daemon=True)
            self._running.start()

    def _take(self, state: FleetState) -> None:
        """Queue a line for each alarm that was raised, or came back, since the last look."""
        counts = {alarm.key: alarm.count for alarm in state.alarms if alarm.holds}
        for alarm in state.alarms if self._is_ours() else ():
            is_new = alarm.holds and alarm.count > self._known.get(alarm.key, 0)
            if is_new and alarm.stage is AlarmStage.UNACKNOWLEDGED and self._is_wanted(alarm):
                self._waiting.append(line_of(alarm, state))
        self._known = counts

    def _is_wanted(self, alarm: Alarm) -> bool:
        names = alarm.condition.priority.name.lower(), class_of(alarm.condition.kind)
        return not self._classes.isdisjoint(names)

    def _lines(self) -> str:
        lines = [*self._waiting]
        if self._waiting.lost:
            lines.append(json.dumps({"left_out": self._waiting.lost}))
        self._waiting.clear()
        self._waiting.lost = 0
        return "".join(f"{line}\n" for line in lines)

    def _run(self, given: str) -> None:
        # Its files may have changed since the configuration was read.
        if found := doubt_of_command(self._command, self._folder):
            ended = EndedProcess(None, problem=found)
        else:
            ended = asyncio.run(run(self._command, WITHIN, folder=self._folder, given=given))
        self._failed = _failure(self._command[0], ended)
        if self._failed:
            LOG.warning("%s; given: %s; printed: %s", self._failed, given.strip(), ended.output.strip())


def line_of(alarm: Alarm, state: FleetState) -> str:
    """Return an alarm as a line of JSON: `robot` is empty for an alarm of a link or of several robots."""
    condition = alarm.condition
    return json.dumps(
        {
            "time": datetime.fromtimestamp(alarm.first_wall, UTC).isoformat(timespec="milliseconds"),
            "robot": condition.source if condition.source in state.robots else "",
            "source": condition.source,
            "kind": condition.kind,
            "priority": condition.priority.name.lower(),
            "text": sanitize(alarm.text),
        }
    )


def _failure(program: str, ended: EndedProcess) -> Message:
    """Return the failure of a run as the operator reads it, empty if it went well."""
    if ended.code is None:
        return (
            Message("notify: {problem}", problem=ended.problem)
            if program in ended.problem
            else Message("notify: {program}: {problem}", program=program, problem=ended.problem)
        )
    return (
        Message(
            "notify: {program} ended with exit status {code}: see the log file",
            program=program,
            code=ended.code,
        )
        if ended.code
        else EMPTY
    )
