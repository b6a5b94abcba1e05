"""Requests to programs of the robot servers: asked first, audited, one at a time for each program."""

import asyncio
import logging
import time
from collections.abc import Callable
from functools import partial

from fleet_tui.features.programs.questions import change_question
from fleet_tui.features.programs.table import note
from fleet_tui.model.problem import Right
from fleet_tui.model.programs.program import NOT_CONFIRMED, ChangeOutcome, ProgramState
from fleet_tui.programs.change import VERBS, change
from fleet_tui.programs.watch import ProgramWatch
from fleet_tui.text.language import EMPTY, Message, joined, verbatim
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Entry

LOG = logging.getLogger(__name__)

INTERRUPTED = ChangeOutcome(NOT_CONFIRMED, Message("the console was closed"))


class ProgramRequests:
    """Opens a program's menu, and carries out what is chosen."""

    def __init__(self, watch: ProgramWatch, console: Console) -> None:
        self._watch = watch
        self._dispatch = console.dispatch
        self._notices = console.notices
        self._files = console.files
        self._ask = console.ask
        self._open_menu = console.open_menu
        self.under_way: set[asyncio.Task[None]] = set()

    def menu(self, name: str, show_log: Callable[[str], None]) -> None:
        """List what can be done with a program."""
        row, now = self._watch.rows[name], time.monotonic()
        state = row.state(now)
        verbs: tuple[str, ...] = VERBS
        if state is not ProgramState.UNKNOWN:
            verbs = VERBS[1:] if state in (ProgramState.RUNNING, ProgramState.STARTING) else VERBS[:1]
        if self._dispatch.permissions.refusal(Right.SETUP):
            verbs = ()
        entries: list[Entry] = [
            (Message(verb.capitalize()), partial(self._ask_to, name, verb)) for verb in verbs
        ]
        entries.append((Message("Log"), partial(show_log, name)))
        where = Message(" on {host}", host=row.host) if row.host else ""
        head = Message("{name}{where}: {state}", name=name, where=where, state=Message(state.value))
        lines = [head, note(row, now)]
        self._open_menu(joined("\n", (sanitize(line) for line in lines if line)), entries)

    def _refusal(self, name: str) -> Message:
        if refusal := self._dispatch.set_up_refusal():
            return refusal
        pending = self._watch.rows[name].pending
        return (
            Message("{name}: {pending} is still under way", name=name, pending=pending) if pending else EMPTY
        )

    def _ask_to(self, name: str, verb: str) -> None:
        if refusal := self._refusal(name):
            self._notices.say(sanitize(refusal))
            return
        self._ask(
            lambda: verbatim(change_question(self._watch.rows, name, verb, time.monotonic())),
            partial(self._begin, name, verb),
        )

    def _begin(self, name: str, verb: str) -> None:
        """Begin after the yes; the console may have been disarmed meanwhile."""
        if refusal := self._refusal(name):
            self._notices.say(sanitize(refusal))
            return
        self._watch.set_pending(name, Message(verb))
        self._log(name, verb, "sent")
        self._notices.say(sanitize(Message("{name}: {verb} is under way", name=name, verb=Message(verb))))
        task = asyncio.ensure_future(self._change(name, verb))
        # The loop alone would let it be collected.
        self.under_way.add(task)
        task.add_done_callback(self.under_way.discard)

    async def _change(self, name: str, verb: str) -> None:
        outcome = INTERRUPTED
        try:
            outcome = await change(self._watch.programs[name], verb, self._watch.folder)
            await self._watch.look(name)
        except Exception as problem:
            LOG.exception("program %s", name)
            outcome = ChangeOutcome(NOT_CONFIRMED, Message("internal error: {problem}", problem=problem))
        finally:
            self._watch.set_pending(name, EMPTY)
            self._log(name, verb, outcome.text)
        self._notices.note(
            sanitize(Message("{name}: {verb} {text}", name=name, verb=Message(verb), text=outcome.text))
        )

    def _log(self, name: str, verb: str, outcome: str) -> None:
        host = self._watch.rows[name].host
        where = Message(" on {host}", host=host) if host else ""
        self._files.log(Message("program {verb}", verb=Message(verb)), f"{name}{where}: {outcome}")
