"""The routines that this console leads: one run each, with the locks of its robots and its saved progress."""

import os
import threading
from functools import partial
from pathlib import Path

from fleet_tui.features.routines.files import RoutineFile
from fleet_tui.features.routines.folder import RoutinePlace, bridge_urls, plans_of
from fleet_tui.features.routines.lane import (
    Gate,
    LaneNote,
    LaneRequest,
    LaneResumed,
    LaneSkipped,
    LaneStepped,
    OrderEnded,
    OrderWithheld,
)
from fleet_tui.features.routines.owner import RobotLocks
from fleet_tui.features.routines.progress import RoutineProgress, progress_path, resumable, save_progress
from fleet_tui.features.routines.rules.orders import objection
from fleet_tui.features.routines.run import RoutineRun, RunParts
from fleet_tui.model.problem import Right
from fleet_tui.model.request import Request
from fleet_tui.text.errors import RoutineError
from fleet_tui.text.language import EMPTY, Message, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console

UNTOLD = ("resumed", "step")
"""Changes that a person has just asked for."""


class LedRoutines:
    """Starts runs, leads them with every tick, and leaves them so that they can be continued."""

    def __init__(self, place: RoutinePlace, console: Console) -> None:
        self.runs: dict[str, RoutineRun] = {}
        self._place = place
        self._store = console.store
        self._dispatch = console.dispatch
        self._notices = console.notices
        self._files = console.files
        self._in_background = console.in_background
        self._locks: dict[str, RobotLocks] = {}
        self._saving = threading.Lock()
        self._newest: dict[Path, RoutineProgress] = {}

    def start(self, file: RoutineFile, is_left: bool) -> None:
        """Start a routine, or continue it where it left off. Raises RoutineError."""
        # It may have been disarmed during the question.
        if refusal := self._dispatch.set_up_refusal(Right.DISPATCH):
            raise RoutineError(refusal)
        urls = bridge_urls(self._store.state, plans_of(self._store.state, file))
        owner = Message(
            "{operator} (process {pid}, routine {name})",
            operator=self._files.operator or Message("a console"),
            pid=os.getpid(),
            name=file.name,
        )
        path = progress_path(self._place.state, file.path)
        before = resumable(path, file) if is_left else None
        locks = RobotLocks(self._place.state, urls, owner)
        locks.claim()
        note, save = partial(self._note, file.name), partial(self._save, path)
        parts = RunParts(self._store, self._give, note, self._files.log, save)
        try:
            self.runs[file.name] = RoutineRun(file, parts, self._files.operator, before)
        except RoutineError:
            locks.release()
            raise
        self._locks[file.name] = locks

    def tick(self) -> bool:
        """Lead the robots; tell whether a routine has ended."""
        for run in self.runs.values():
            run.tick()
        ended = [name for name, run in self.runs.items() if run.is_over]
        for name in ended:
            self.runs.pop(name).close()
            self._locks.pop(name).release()
        return bool(ended)

    def request(self, run: RoutineRun, event: LaneRequest, robot: str) -> None:
        """Carry out a request for a robot, or for all. Without permission or link nothing goes on, but it can
        always be paused and stopped."""
        for name, lane in list(run.lanes.items()):
            if robot not in ("", name) or lane.is_over:
                continue
            goes_on = isinstance(event, LaneResumed | LaneStepped | LaneSkipped)
            if goes_on and lane.gate not in (Gate.PAUSED, Gate.HELD):
                continue
            if goes_on and (refusal := self._dispatch.set_up_refusal(Right.DISPATCH) or run.no_link(name)):
                self._notices.say(
                    sanitize(
                        Message(
                            "{name} {robot}: not resumed: {refusal}",
                            name=run.file.name,
                            robot=name,
                            refusal=refusal,
                        )
                    )
                )
                continue
            run.request(event, name)

    def _give(self, request: Request) -> OrderEnded | OrderWithheld | None:
        return objection(self._dispatch.give_unasked(request))

    def _note(self, name: str, robot: str, note: LaneNote) -> None:
        """Tell what a person must know: the list has the rest."""
        if not note.line and note.change not in UNTOLD:
            detail = Message(": {detail}", detail=note.detail) if note.detail else EMPTY
            self._notices.note(
                sanitize(
                    Message(
                        "{name} {robot} {change}{detail}",
                        name=name,
                        robot=robot,
                        change=translate(note.change),
                        detail=translate(detail),
                    )
                )
            )

    def _save(self, path: Path, progress: RoutineProgress) -> None:
        self._newest[path] = progress
        self._in_background(partial(self._write, path), self._tell)

    def _write(self, path: Path) -> str:
        """Write the newest progress; return the reason if that failed. In a thread."""
        with self._saving:
            try:
                save_progress(path, self._newest[path])
            except OSError as problem:
                return Message(
                    "{path}: not written: {strerror}: can't be resumed", path=path, strerror=problem.strerror
                )
        return ""

    def _tell(self, problem: Message) -> None:
        if problem:
            self._notices.note(sanitize(problem))

    @property
    def losses(self) -> Message:
        """Return the question before they are left, empty if nothing is led here."""
        if not self.runs:
            return EMPTY
        names = sanitize(", ".join(self.runs))
        return Message(
            "Leave {names}? Running orders continue, nothing new starts.\n"
            "In the next console B continues it.",
            names=names,
        )

    def close(self) -> None:
        """Leave the routines, so that they can be continued."""
        for name, run in self.runs.items():
            run.close()
            path = progress_path(self._place.state, run.file.path)
            self._newest[path] = run.progress
            self._write(path)
            self._files.log("routine held", Message("{name}: the console was closed", name=name))
            self._locks[name].release()
        self.runs.clear()
