"""What other consoles of this machine send to robots, as their audit log tells it while this console runs."""

import logging
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path

from fleet_tui.audit.file import FILE_NAME
from fleet_tui.audit.log import console_name
from fleet_tui.audit.tail import AuditTail
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import NOT_LEFT, Stage
from fleet_tui.model.desk.desk import REMOVES, CommandElsewhere
from fleet_tui.model.desk.events import CommandedElsewhere
from fleet_tui.model.fleet import FleetState
from fleet_tui.state.store import Store

LOG = logging.getLogger(__name__)

EVERY = 0.2
"""Seconds between two looks at the log."""
STAGES = {stage.value: stage for stage in Stage if stage not in NOT_LEFT}


def command_of(record: AuditRecord, state: FleetState, console: str, at: float) -> CommandElsewhere | None:
    """Return the command that a record of another console than this one tells about, None for none. `at`:
    its monotonic second. Robots of other sites have the same names: its link must be that of ours."""
    robot, stage = state.robots.get(record.robot), STAGES.get(record.change)
    if record.kind != "command" or record.console == console or robot is None or stage is None:
        return None
    if _address(record.url) != _address(state.links[robot.link].url):
        return None
    key, order_id = f"{record.run} {record.id}", (record.order or "") if record.what in REMOVES else ""
    return CommandElsewhere(
        key, robot.name, order_id, record.operator, record.console, at, stage, record.what
    )


def _address(url: str) -> str:
    return url.replace("//localhost", "//127.0.0.1").rstrip("/")


@contextmanager
def watched_commands(
    folder: Path, store: Store, post: Callable[[CommandedElsewhere], object], console: str = ""
) -> Iterator[None]:
    """Post what the log in the state folder tells about other consoles than `console` (empty: this process),
    while this lasts. It reads in a thread of its own, since a disk may hang."""
    console, closing = console or console_name(), threading.Event()
    reading = threading.Thread(
        target=_read, args=(folder, store, post, console, closing), name="fleet-tui-elsewhere", daemon=True
    )
    reading.start()
    try:
        yield
    finally:
        closing.set()


def _read(
    folder: Path,
    store: Store,
    post: Callable[[CommandedElsewhere], object],
    console: str,
    closing: threading.Event,
) -> None:
    problem, log = "", None
    while not closing.is_set():
        try:
            log = log or AuditTail(folder / FILE_NAME)
            for record in log.new():
                at = time.monotonic() - (time.time() - datetime.fromisoformat(record.time).timestamp())
                if (command := command_of(record, store.state, console, at)) is not None:
                    post(CommandedElsewhere(command))
            problem = ""
        except (OSError, ValueError) as error:
            if str(error) != problem:
                LOG.warning("audit log of other consoles: %s", error)
            problem = str(error)
        closing.wait(EVERY)
    if log is not None:
        log.close()
