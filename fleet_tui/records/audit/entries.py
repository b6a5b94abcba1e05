"""Audit records: the difference between two states, in the words of the log."""

import dataclasses
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from datetime import datetime
from typing import Any, assert_never

from msgspec.structs import replace

from fleet_tui.model import commands
from fleet_tui.model.alarm import ANSWERS, Alarm, AlarmStage, transitions
from fleet_tui.model.audit_record import VERSION, AuditRecord
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import Kind
from fleet_tui.model.order import Stop, pose_text
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetUpCommand, heading_text
from fleet_tui.situation.batches import pauses, summary

TEXT_KEPT = 1000
"""Maximum characters of a text from outside: no robot fills the disk with one answer."""


@dataclass(frozen=True, slots=True)
class Origin:
    """The author of records: the operator's name, `console` as host:process id, `run` as its unique id."""

    operator: str
    console: str
    run: str
    demo: bool = False

    def record(self, wall: float, **fields: Any) -> AuditRecord:
        """A record signed with this origin. `wall` is Unix seconds."""
        fields |= {"operator": self.operator, "console": self.console, "run": self.run, "demo": self.demo}
        kept: dict[str, Any] = {
            name: _truncated(value) if isinstance(value, str) else value for name, value in fields.items()
        }
        time = datetime.fromtimestamp(wall).astimezone().isoformat(timespec="milliseconds")
        return AuditRecord(version=VERSION, time=time, **kept)


def _truncated(text: str) -> str:
    """Truncate a text, and drop characters that JSON readers reject: half a surrogate pair."""
    text = text if len(text) <= TEXT_KEPT else text[: TEXT_KEPT - 1] + "…"
    try:
        text.encode()
    except UnicodeEncodeError:
        return text.encode(errors="backslashreplace").decode()
    return text


def command_records(
    origin: Origin, before: FleetState, after: FleetState, wall: Callable[[float], float]
) -> Iterator[AuditRecord]:
    """Return each step that a command made. `wall` converts monotonic to Unix time."""
    if before.commands is after.commands:
        return
    # Of a thousand commands one has changed: the others are only compared.
    same = set(map(id, before.commands)) & set(map(id, after.commands))
    known = {record.id: record for record in before.commands if id(record) not in same}
    decided = set[int]()
    for record in after.commands:
        if id(record) in same:
            continue
        old = known.get(record.id)
        for step in record.steps[len(old.steps) if old else 0 :]:
            yield _of_step(origin, after, record, step, wall(step.at))
        if record.is_decided and old and not old.is_decided:
            decided.add(record.id)
    yield from _summaries(origin, after, decided, wall)


def _summaries(
    origin: Origin, after: FleetState, decided: Collection[int], wall: Callable[[float], float]
) -> Iterator[AuditRecord]:
    """Summarise a request to many robots, once all of it is decided."""
    for batch in pauses(after.commands) if decided else ():
        if all(record.is_decided for record in batch) and any(record.id in decided for record in batch):
            yield _summary(origin, after, batch, wall(max(record.at for record in batch)))


def _summary(
    origin: Origin, state: FleetState, batch: list[commands.CommandRecord], wall: float
) -> AuditRecord:
    what, words = summary(state, batch)
    return origin.record(wall, kind="command", what=what, change="summary", words=words)


def closing_records(origin: Origin, state: FleetState, wall: float) -> Iterator[AuditRecord]:
    """Return this console's last record on each open command and order."""
    for record in state.commands:
        if not record.is_decided or record.has_open_order:
            words = f"order {record.order_id} was in the queue" if record.has_open_order else ""
            fields = _about(state, record) | {"words": words or f"last stage: {record.stage.value}"}
            yield origin.record(wall, change="console closed", **fields)
    for batch in pauses(state.commands):
        if not all(record.is_decided for record in batch):
            yield _summary(origin, state, batch, wall)


def _of_step(
    origin: Origin, state: FleetState, record: commands.CommandRecord, step: commands.Step, wall: float
) -> AuditRecord:
    return origin.record(wall, change=step.stage.value, words=step.detail, **_about(state, record))


def _about(state: FleetState, record: commands.CommandRecord) -> dict[str, Any]:
    robot = state.robots.get(record.command.robot)
    return {
        "kind": "command",
        "id": record.id,
        "robot": record.command.robot,
        "what": commands.command_name(record.command, robot.kind if robot else Kind()),
        "order": record.order_id,
        **(_where(state, robot) if robot else {}),
        **_arguments(robot, record.command),
    }


def _where(state: FleetState, robot: Robot) -> dict[str, Any]:
    return {"floor": robot.floor or "", **_link(state, robot.link)}


def _link(state: FleetState, name: str) -> dict[str, Any]:
    link = state.links.get(name)
    return {"link": name, "url": link.url if link else ""}


def _arguments(robot: Robot | None, command: commands.Command) -> dict[str, Any]:
    match command:
        case commands.PlaceOrder(_, stops):
            start = _stop("start", robot, stops[0]) if len(stops) > 1 else {}
            return {**start, **_stop("end", robot, stops[-1])}
        case commands.CancelOrder(_, order_id):
            return {"order": order_id}
        case commands.ClearOrders() | commands.PauseRobot() | commands.ResumeRobot():
            return {}
        case SetUpCommand():
            return {"end": heading_text(command.place)} if command.place else {}
        case _:
            assert_never(command)


def _stop(role: str, robot: Robot | None, stop: Stop) -> dict[str, Any]:
    if stop.pose is not None:
        return {role: pose_text(stop.pose)}
    name = robot.name_of(stop.vertex) if robot else None
    return {role: stop.vertex, f"{role}_label": "" if name in (None, stop.vertex) else name}


def alarm_records(
    origin: Origin, before: FleetState, after: FleetState, wall: float
) -> Iterator[AuditRecord]:
    """Return each change of an alarm; an operator's at another console of the desk in that one's name."""
    by = after.desk.acted
    for change in transitions(before.alarms, after.alarms, wall, by_time=after.now != before.now):
        cleared = change.now is AlarmStage.CLEARED
        word = f"{change.word}, {AlarmStage.CLEARED.value}" if cleared else change.word
        if by and change.step in ANSWERS:
            word = word.replace(change.step.value, f"{change.step.value} elsewhere", 1)
            yield _of_alarm(dataclasses.replace(origin, operator=by), after, change.alarm, word, wall)
        else:
            yield _of_alarm(origin, after, change.alarm, word, wall)


def held_records(origin: Origin, state: FleetState, wall: float) -> Iterator[AuditRecord]:
    """Return the alarms that hold as if they were raised now: for a log that knows none of them."""
    held = (
        replace(one, stage=AlarmStage.UNACKNOWLEDGED)
        for one in state.alarms
        if one.stage is not AlarmStage.RETURNED
    )
    yield from alarm_records(origin, replace(state, alarms=()), replace(state, alarms=tuple(held)), wall)


def _of_alarm(origin: Origin, state: FleetState, alarm: Alarm, change: str, wall: float) -> AuditRecord:
    condition = alarm.condition
    robot = state.robots.get(condition.source)
    about = {"robot": robot.name, **_where(state, robot)} if robot else _link(state, condition.source)
    return origin.record(
        wall,
        kind="alarm",
        what=condition.kind,
        change=change,
        words=alarm.text,
        priority=condition.priority.name.lower(),
        count=alarm.count,
        **about,
    )
