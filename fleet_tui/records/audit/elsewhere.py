"""What other consoles of this machine send to robots, as their audit log tells it while this console runs."""

import logging
import re
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path

from msgspec.structs import replace

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import NOT_LEFT, Stage
from fleet_tui.model.desk.desk import REMOVES, CommandElsewhere
from fleet_tui.model.desk.events import CommandedElsewhere
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.log import console_name
from fleet_tui.records.audit.tail import AuditTail
from fleet_tui.state.store import Store
from fleet_tui.storage.worker import Worker

LOG = logging.getLogger(__name__)

EVERY = 0.2
"""Seconds between two looks at the log."""
STAGES = {stage.value: stage for stage in Stage if stage not in NOT_LEFT}
GOES_ON = re.compile(r"order (\S+): ")
"""Words of an order that waits for its next goal: they name the last one."""


def command_of(record: AuditRecord, state: FleetState, console: str, at: float) -> CommandElsewhere | None:
    """Return the command that a record of another console than this one tells about, None for none. `at`:
    its monotonic second. Robots of other sites have the same names: its link must be that of ours."""
    kept = GOES_ON.match(record.words) if record.change == Stage.WAITING.value else None
    robot, stage = state.robots.get(record.robot), Stage.WAITING if kept else STAGES.get(record.change)
    if record.kind != "command" or record.console == console or robot is None or stage is None:
        return None
    if _address(record.url) != _address(state.links[robot.link].url):
        return None
    key, order_id = f"{record.run} {record.id}", (record.order or "") if record.what in REMOVES else ""
    found = CommandElsewhere(
        key, robot.name, order_id, record.operator, record.console, at, stage, record.what
    )
    if record.what != "order" or not robot.kind.keeps_goals:
        return found
    goal = kept[1] if kept else record.order if stage is Stage.CONFIRMED else None
    names = (record.start_label or record.start, record.end_label or record.end)
    way = " -> ".join(filter(None, names))
    return replace(found, goals=(goal,) if goal else (), way=way, goes_on=kept is not None)


def _address(url: str) -> str:
    return url.replace("//localhost", "//127.0.0.1").rstrip("/")


@contextmanager
def watched_commands(
    folder: Path, store: Store, post: Callable[[CommandedElsewhere], object], console: str = ""
) -> Iterator[None]:
    """Post what the log in the state folder tells about other consoles than `console` (empty: this process),
    while this lasts. It reads in a thread of its own, since a disk may hang."""
    reader = _CommandsElsewhere(folder / FILE_NAME, store, post, console or console_name())
    worker = Worker("elsewhere", reader.read, EVERY, reader.close)
    worker.start()
    try:
        yield
    finally:
        worker.close(0.0)


class _CommandsElsewhere:
    def __init__(
        self, path: Path, store: Store, post: Callable[[CommandedElsewhere], object], console: str
    ) -> None:
        self._path = path
        self._store = store
        self._post = post
        self._console = console
        self._log: AuditTail | None = None
        self._problem = ""

    def read(self) -> None:
        """Post the commands since the last time."""
        try:
            self._log = self._log or AuditTail(self._path)
            for record in self._log.new():
                at = time.monotonic() - (time.time() - datetime.fromisoformat(record.time).timestamp())
                if (command := command_of(record, self._store.state, self._console, at)) is not None:
                    self._post(CommandedElsewhere(command))
            self._problem = ""
        except (OSError, ValueError) as error:
            if str(error) != self._problem:
                LOG.warning("audit log of other consoles: %s", error)
            self._problem = str(error)

    def close(self) -> None:
        if self._log is not None:
            self._log.close()
