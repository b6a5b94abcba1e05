"""A routine that runs: from the newest state of the fleet to orders and programs, one lane for each robot."""

import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import NamedTuple, assert_never

from msgspec.structs import replace

from fleet_tui.commands.checks import no_link
from fleet_tui.commands.language.words import find_robot
from fleet_tui.features.routines.blocks import LanePlan
from fleet_tui.features.routines.clock import next_time
from fleet_tui.features.routines.files import RoutineFile
from fleet_tui.features.routines.lane import (
    SKIPPED,
    EndProgram,
    GiveOrder,
    Lane,
    LaneAction,
    LaneEvent,
    LaneFacts,
    LaneNote,
    LanePhase,
    LaneRequest,
    OrderEnded,
    OrderWithheld,
    ProgramEnded,
    StartProgram,
    Ticked,
)
from fleet_tui.features.routines.programs import ProgramRun
from fleet_tui.features.routines.progress import RoutineProgress, resumed
from fleet_tui.features.routines.rules.conditions import condition_holds
from fleet_tui.features.routines.rules.orders import earlier_outcome, order_of, outcome_of
from fleet_tui.features.routines.rules.positions import fits
from fleet_tui.features.routines.rules.stepping import step
from fleet_tui.model.commands import Command, CommandRecord, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request
from fleet_tui.state.store import Store
from fleet_tui.text.errors import CommandError, RoutineError
from fleet_tui.text.language import EMPTY, Message, message_of

Give = Callable[[Request], OrderEnded | OrderWithheld | None]
"""Checks and sends the single command of a request. Returns the objection, None if it was sent."""


class RunParts(NamedTuple):
    """The doors of a run: `give` sends an order, `note` is called with each change of a robot's lane, `log`
    writes to the audit log, `save` keeps the progress."""

    store: Store
    give: Give
    note: Callable[[str, LaneNote], None]
    log: Callable[[str, str], None]
    save: Callable[[RoutineProgress], None]


class RoutineRun:
    """Leads the robots of a routine. Nothing waits in it: `tick` is called several times a second."""

    def __init__(
        self, file: RoutineFile, parts: RunParts, operator: str, before: RoutineProgress | None = None
    ) -> None:
        """`before` is the progress to go on from. Raises RoutineError if it does not fit the file."""
        self.file = file
        self._parts = parts
        self._operator = operator
        state = parts.store.state
        lanes = {find_robot(lane.robot, state).name: lane for lane in file.parsed.routine.lanes}
        self.plans: Mapping[str, LanePlan] = lanes
        known = {lane.robot: resumed(lane) for lane in before.lanes} if before else {}
        if not all(fits(plan, known[name]) for name, plan in lanes.items() if name in known):
            raise RoutineError(
                Message("{name}: its progress does not match the file: start it again", name=file.name)
            )
        now = time.time()
        self.lanes = {name: known.get(name, Lane(name, since=now)) for name in lanes}
        self._started = before.started if before else now
        self._given: dict[str, Command] = {}
        self._programs: dict[str, ProgramRun] = {}
        self._saved: dict[str, Lane] = {}
        parts.log(f"routine {'resumed' if before else 'started'}", f"{file.name}: {', '.join(lanes)}")
        self._save()

    @property
    def is_over(self) -> bool:
        """Tell whether every robot has ended."""
        return all(lane.is_over for lane in self.lanes.values())

    @property
    def progress(self) -> RoutineProgress:
        """Return the progress to save."""
        lanes = tuple(self.lanes.values())
        return RoutineProgress(self.file.digest, lanes, self._started, time.time(), self._operator)

    def no_link(self, robot: str) -> Message:
        """Return the reason that commands do not reach a robot, empty if they do."""
        state = self._parts.store.state
        found = no_link(state, state.robots[robot], ResumeRobot(robot))
        return next((problem.text for problem in found), EMPTY)

    def request(self, event: LaneRequest, robot: str = "") -> None:
        """Carry out the request of a person, for one robot or for all."""
        for name in [robot] if robot else list(self.lanes):
            self._apply(name, event)
        self._save()

    def tick(self) -> None:
        """Go on as far as the fleet and the programs allow."""
        state = self._parts.store.state
        for name, lane in self.lanes.items():
            if lane.is_over:
                continue
            ended = self._ended(state, lane)
            if ended is not None:
                self._apply(name, ended)
            holds = partial(condition_holds, state, state.robots[name])
            self._apply(name, Ticked(LaneFacts(time.time(), self.no_link(name), holds, next_time)))
        self._save()

    def close(self) -> None:
        """End the programs that run. Running orders go on."""
        for program in self._programs.values():
            program.end()
        for program in self._programs.values():
            program.join()

    def _ended(self, state: FleetState, lane: Lane) -> OrderEnded | ProgramEnded | None:
        """Return the outcome of an order or a program, None while it runs."""
        if lane.phase is LanePhase.PROGRAM:
            return self._programs[lane.robot].ended
        if lane.phase is not LanePhase.ORDERED:
            return None
        record = self._record(state, lane.robot)
        if record is None:
            robot = state.robots[lane.robot]
            return earlier_outcome(robot, lane.order_id) if lane.order_id else None
        if record.order_id and record.order_id != lane.order_id:
            self.lanes[lane.robot] = replace(lane, order_id=record.order_id)
        return outcome_of(record)

    def _record(self, state: FleetState, robot: str) -> CommandRecord | None:
        given = self._given.get(robot)
        return next((record for record in reversed(state.commands) if record.command is given), None)

    def _apply(self, robot: str, event: LaneEvent) -> None:
        """Apply an event, and those that its effects lead to."""
        events: list[LaneEvent] = [event]
        while events:
            before = self.lanes[robot]
            lane, actions = step(self.plans[robot], before, events.pop(0))
            if lane is not before:
                moved = (lane.path, lane.phase, lane.gate) != (before.path, before.phase, before.gate)
                self.lanes[robot] = replace(lane, since=time.time()) if moved else lane
            for action in actions:
                followed = self._do(robot, action)
                events += [followed] if followed else []

    def _do(self, robot: str, action: LaneAction) -> LaneEvent | None:
        """Carry out an effect; return the event that it leads to at once."""
        match action:
            case GiveOrder():
                return self._give(robot, action)
            case StartProgram(block):
                self._parts.log("routine program", f"{self.file.name} {robot}: {block.text}")
                self._programs[robot] = ProgramRun(self.file.path.parent, block, robot)
            case EndProgram():
                self._programs[robot].end()
            case LaneNote():
                self._note(robot, action)
            case _:
                assert_never(action)
        return None

    def _give(self, robot: str, action: GiveOrder) -> OrderEnded | OrderWithheld | None:
        try:
            request = order_of(self._parts.store.state.robots[robot], action.block)
        except CommandError as problem:
            return OrderEnded(False, message_of(problem))
        if request is None:
            return OrderEnded(True, Message("there already"))
        (self._given[robot],) = request.commands
        self._save()  # before it is sent: after a crash it is asked about, not given twice
        return self._parts.give(request)

    def _note(self, robot: str, note: LaneNote) -> None:
        self._parts.note(robot, note)
        # The audit log has orders and programs already; a skip is the decision of a person.
        if not note.line or note.change == SKIPPED:
            said = ": ".join(part for part in (f"{self.file.name} {robot}", note.text, note.detail) if part)
            self._parts.log(Message("routine {change}", change=note.change), said)

    def _save(self) -> None:
        """Keep the progress if it has changed."""
        if any(lane is not self._saved.get(name) for name, lane in self.lanes.items()):
            self._saved = dict(self.lanes)
            self._parts.save(self.progress)
