"""Invariants that no fault may break, checked on a watched link during and after the fault."""

import json
import tempfile
from collections import Counter
from collections.abc import AsyncIterator, Iterable
from contextlib import asynccontextmanager
from pathlib import Path

from fleet_tui.config.schema import Config
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model import commands
from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import Stage
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import Audit
from fleet_tui.records.audit.reader import AuditReader
from tests.support.links import linked as plainly_linked
from tests.support.watched_store import WatchedStore

OPEN = (Stage.NO_ANSWER, Stage.UNKNOWN)
ENDS = {stage.value for stage in Stage if stage not in commands.OPEN} | {"console closed"}


class Wire:
    """Which calls to robots left, by their services."""

    def __init__(self) -> None:
        self.left: Counter[str] = Counter()

    def on_received(self, link: str, channel: str, payload: bytes, is_binary: bool, at: float) -> None: ...

    def on_sent(self, link: str, channel: str, payload: bytes) -> None:
        frame = json.loads(payload)
        if channel == "commands" and not frame["service"].startswith(("/rosapi/", "/rosbridge_websocket/")):
            self.left[frame["service"].split("/")[1]] += 1

    def on_event(self, event: Event) -> None: ...


@asynccontextmanager
async def linked(config: Config) -> AsyncIterator[tuple[FleetLink, WatchedStore]]:
    """A link with an audit log. When a test is through with it, nothing may be lost."""
    wire = Wire()
    alarms: set[tuple[str, str]] = set()

    def see(_before: FleetState, after: FleetState) -> None:
        alarms.update(alarm.key for alarm in after.alarms)

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / FILE_NAME
        async with plainly_linked(config, wire) as (link, store):
            audit = Audit(audit_file(path), Origin("ana", "host:1", "run"))
            store.watchers += [audit.watch, see]
            yield link, store
            store.watchers.clear()
            state = store.state
            assert audit.close(state) == 0
        lines = read(path)
        commands_are_kept(config, state, lines, wire)
        alarms_are_kept(state, lines, alarms)


def read(path: Path) -> list[AuditRecord]:
    """Every line of an audit log, the oldest first; all are whole."""
    reading = AuditReader(path)
    lines = list(reading.newest_first())[::-1]
    assert reading.unreadable == 0
    return lines


def commands_are_kept(config: Config, state: FleetState, lines: Iterable[AuditRecord], wire: Wire) -> None:
    """Each command has one end or is open and says so, left once or not at all, and all of it is logged."""
    for record in state.commands:
        stages = [step.stage for step in record.steps]
        waits = state.now - record.at < config.alarms.no_answer_after + 1.0
        is_open = stages[-1] in OPEN or (waits and stages[-1] in (Stage.SENT, Stage.ACCEPTED))
        assert is_open or record.is_decided
        logged = [line.change for line in lines if line.id == record.id and line.kind == "command"]
        is_open = not record.is_decided or record.has_open_order
        assert logged == [stage.value for stage in stages] + ["console closed"] * is_open
    sent = Counter(record.command.robot for record in state.commands if record.time_of(Stage.SENT))
    assert wire.left == sent


def alarms_are_kept(state: FleetState, lines: Iterable[AuditRecord], seen: Iterable[tuple[str, str]]) -> None:
    """Each alarm that ever was there, or the log says that it has gone."""
    there = {alarm.key for alarm in state.alarms}
    for source, kind in seen:
        logged = [line for line in lines if line.what == kind and source in (line.robot, line.link)]
        assert logged[0].change.startswith("raised")
        gone = logged[-1].change.endswith(AlarmStage.CLEARED.value)
        assert gone != ((source, kind) in there)


def log_is_whole(home: Path, killed: bool = False) -> None:
    """The same of a log alone: every line is whole, and a command of a console that closed has its end."""
    for path in (home / "state").rglob(FILE_NAME):
        assert path.read_bytes()[-1:] in (b"", b"\n")
        commands: dict[tuple[str, int], list[str]] = {}
        for line in read(path):
            if line.kind == "command" and line.id is not None:
                commands.setdefault((line.run, line.id), []).append(line.change)
        for changes in commands.values():
            assert changes[0] == Stage.CHECKED.value
            assert changes[-1] in ENDS or killed
