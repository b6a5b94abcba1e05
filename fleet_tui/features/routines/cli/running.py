"""`fleet-tui routine run`: leads the robots, and prints what happens."""

import json
import os
import select
import sys
import time
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import NamedTuple

import msgspec

from fleet_tui.cli.orders.giving import forbidden, sending, unreachable
from fleet_tui.cli.orders.outcome import DONE, NO_LINK, NOT_DONE
from fleet_tui.cli.orders.sending import How, Sending
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.rights import permissions_of
from fleet_tui.config.schema import Config
from fleet_tui.features.routines.cli.reading import Say, await_robots, named_routine
from fleet_tui.features.routines.clock import clock_text
from fleet_tui.features.routines.files import RoutineFile
from fleet_tui.features.routines.folder import bridge_urls
from fleet_tui.features.routines.lane import (
    Gate,
    Lane,
    LaneNote,
    LanePhase,
    LaneResumed,
    LaneSkipped,
    OrderEnded,
    OrderWithheld,
)
from fleet_tui.features.routines.lines import lane_text, note_text, problem_line
from fleet_tui.features.routines.owner import RobotLocks
from fleet_tui.features.routines.progress import RoutineProgress, progress_path, resumable, save_progress
from fleet_tui.features.routines.rules.orders import objection
from fleet_tui.features.routines.run import RoutineRun, RunParts
from fleet_tui.features.routines.start import problems_of
from fleet_tui.model.request import Request
from fleet_tui.records.audit.log import operator_name
from fleet_tui.text.language import in_english
from fleet_tui.text.sanitize import sanitize

VERSION = 1
EVERY = 0.2
"""Seconds between two ticks."""
WITHIN = 15.0
"""Seconds for the robots' reports."""


class RunOptions(NamedTuple):
    """The options of a run: `held_for`: seconds to wait where nobody can resume it."""

    resume: bool
    skip: bool
    yes: bool
    as_json: bool
    held_for: float


def run_routine(config: Config, name: str, options: RunOptions, say: Say) -> int:
    """Run a routine to its end; return the exit code."""
    file = named_routine(config, name)
    if reason := forbidden(config):
        say(sanitize(f"{file.name}: not started: {reason}"), err=True)
        return NOT_DONE
    path = progress_path(state_folder() / "routines", file.path)
    before = resumable(path, file) if options.resume else None
    how = How(permissions_of(config), WITHIN, options.yes, True)
    with sending(config, how, say) as given:
        robots = await_robots(given, file)
        if reason := unreachable(given.state, robots):
            say(sanitize(f"{file.name}: not started: {reason}"), err=True)
            return NO_LINK
        if problems := problems_of(given.state, file):
            for problem in problems:
                say(problem_line(file.name, problem), err=True)
            say(sanitize(f"{file.name}: not started"), err=True)
            return NOT_DONE
        operator = operator_name(config)
        owner = f"{operator} (process {os.getpid()}, routine {file.name})"
        locks = RobotLocks(path.parent, bridge_urls(given.state, robots), owner)
        locks.claim()
        try:
            return _Running(given, file, options, say).run(path, operator, before)
        finally:
            locks.release()


class _Running:
    """A run in a terminal or a service."""

    def __init__(self, given: Sending, file: RoutineFile, options: RunOptions, say: Say) -> None:
        self._given = given
        self._file = file
        self._options = options
        self._say = say
        self._can_ask = sys.stdin.isatty() and not options.as_json
        self._asked = False
        self._not_saved = ""

    def run(self, path: Path, operator: str, before: RoutineProgress | None) -> int:
        """Lead the robots until all have ended, or nobody can resume them; return the exit code."""

        def save(progress: RoutineProgress) -> None:
            try:
                save_progress(path, progress)
            except OSError as problem:
                self._warn(f"{path}: not written: {problem.strerror}: can't be resumed")

        parts = RunParts(self._given.store, self._give, self._note, self._given.log, save)
        run = RoutineRun(self._file, parts, operator, before)
        if not self._options.as_json:
            verb = "started" if before is None else "continued"
            self._say(sanitize(f"{clock_text(time.time())} {self._file.name} {verb}: {', '.join(run.lanes)}"))
        try:
            if before is not None:
                self._take_up(run, before)
            return self._follow(run)
        except KeyboardInterrupt:
            self._say_what_goes_on(run)
            raise
        finally:
            run.close()

    def _take_up(self, run: RoutineRun, before: RoutineProgress) -> None:
        """Let the robots go on. Whether an order is given once more is asked where that is possible."""
        run.tick()
        sent = {lane.robot for lane in before.lanes if lane.phase is LanePhase.ORDERED}
        for lane in self._decisions(run):
            is_unclear = lane.robot in sent and lane.phase is LanePhase.READY
            if not (is_unclear and self._can_ask):
                self._go_on(run, lane, is_unclear and self._options.skip)

    def _go_on(self, run: RoutineRun, lane: Lane, skips: bool) -> None:
        """Resume a lane with its instruction, or after it unless that runs."""
        can_skip = lane.phase is not LanePhase.ORDERED
        run.request(LaneSkipped() if skips and can_skip else LaneResumed(), lane.robot)

    def _follow(self, run: RoutineRun) -> int:
        held_since = time.monotonic()
        while not run.is_over:
            run.tick()
            waits = [lane for lane in run.lanes.values() if not lane.is_over]
            if not all(lane.gate is Gate.HELD for lane in waits):
                held_since = time.monotonic()
            elif not self._can_ask and time.monotonic() - held_since > self._options.held_for:
                self._say_what_goes_on(run)
                return NO_LINK if any(run.no_link(lane.robot) for lane in waits) else NOT_DONE
            self._wait(run)
        ended = [lane.phase for lane in run.lanes.values()]
        return DONE if all(phase is LanePhase.DONE for phase in ended) else NOT_DONE

    def _decisions(self, run: RoutineRun) -> Iterator[Lane]:
        """Yield the held lanes that can go on now, as far as their orders have ended."""
        for lane in list(run.lanes.values()):
            if not lane.is_over and lane.gate is Gate.HELD and not run.no_link(lane.robot):
                yield lane

    def _wait(self, run: RoutineRun) -> None:
        """Wait for the next tick, and for a person at the terminal."""
        ready = list(self._decisions(run))
        if not self._can_ask or not ready:
            self._asked = False
            self._given.store.wait(lambda _: False, EVERY)
            return
        if not self._asked:
            self._asked = True
            for lane in ready:
                where = lane_text(run.plans[lane.robot], lane)
                self._say(f"held: {sanitize(lane.robot)} {where}", err=True)
            skip = "" if all(lane.phase is LanePhase.ORDERED for lane in ready) else "; s Enter: skip it"
            self._say(f"Enter: resume with this instruction{skip}", err=True)
        if not select.select([sys.stdin], [], [], EVERY)[0]:
            return
        typed = sys.stdin.readline()
        if not typed:
            self._can_ask = False  # the terminal was closed
            return
        self._asked = False
        for lane in ready:
            self._go_on(run, lane, typed.strip().casefold() == "s")

    def _give(self, request: Request) -> OrderEnded | OrderWithheld | None:
        """Send an order, or return the objection."""
        held = objection(self._given.objections(request))
        if held is None:
            for command in request.commands:
                self._given.link.submit(command)
        return held

    def _note(self, robot: str, note: LaneNote) -> None:
        if not self._options.as_json:
            self._say(f"{clock_text(time.time())} {sanitize(robot)} {note_text(note)}")
            return
        now = datetime.now(UTC).isoformat(timespec="milliseconds")
        known = {"version": VERSION, "time": now, "routine": self._file.name, "robot": robot}
        self._say(json.dumps(known | msgspec.to_builtins(note, enc_hook=in_english)))

    def _warn(self, text: str) -> None:
        if text != self._not_saved:
            self._not_saved = text
            self._say(sanitize(text), err=True)

    def _say_what_goes_on(self, run: RoutineRun) -> None:
        for lane in run.lanes.values():
            if lane.phase is LanePhase.ORDERED:
                order = f"order {lane.order_id}" if lane.order_id else "its order"
                self._say(sanitize(f"{lane.robot}: {order} goes on, nothing follows"), err=True)
        self._given.log("routine held", f"{self._file.name}: the command has ended")
        again = f"fleet-tui routine run {self._file.name} --resume"
        self._say(sanitize(f"{self._file.name}: held; go on with: {again}"), err=True)
