"""Starts, stops and restarts a program. Its state afterwards decides the outcome."""

import asyncio
import os
import time
from pathlib import Path

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.config.rights import own_rights
from fleet_tui.config.withholding import doubt_of_program
from fleet_tui.model.problem import Right
from fleet_tui.model.programs.program import (
    CONFIRMED,
    ENDED,
    FAILED,
    NOT_CONFIRMED,
    REFUSED,
    ChangeOutcome,
    ProgramState,
    ProgramStatus,
)
from fleet_tui.programs import arguments
from fleet_tui.programs.process import EndedProcess, run
from fleet_tui.programs.reasons import SSH_FAILED, failure
from fleet_tui.programs.session_state import stop_session
from fleet_tui.programs.status import look
from fleet_tui.text.language import EMPTY, N_, Message, joined, verbatim

START, STOP, RESTART = VERBS = (N_("start"), N_("stop"), N_("restart"))
WITHIN = 30.0
"""Seconds until an outcome is not confirmed: a launch file takes half of that to stop."""
STEADY = 1.0
"""Seconds that a started program must run: a wrong argument ends it at once."""
LOOK_EVERY = 0.25


async def change(program: ProgramEntry, verb: str, folder: Path, within: float = WITHIN) -> ChangeOutcome:
    """Start, stop or restart a program within seconds, and return the outcome."""
    if refusal := own_rights().refusal(Right.SETUP):
        return ChangeOutcome(REFUSED, refusal)
    if doubt := doubt_of_program(program):  # its files may have changed since the configuration was read
        return ChangeOutcome(REFUSED, verbatim(doubt))
    until = time.monotonic() + within
    # systemd restarts its units itself, in the sequence of their dependencies.
    verbs = (verb,) if program.unit or verb != RESTART else (STOP, START)
    outcome = ChangeOutcome(CONFIRMED)
    for one in verbs:
        before = await look(program, folder)
        if _is_so(one, before):
            outcome = ChangeOutcome(CONFIRMED, Message("already {state}", state=Message(before.state.value)))
            continue
        outcome = await _change(program, one, folder, before, until)
        if not outcome.is_confirmed:
            break
    return outcome


def _is_so(verb: str, status: ProgramStatus) -> bool:
    if verb == START:
        return status.state is ProgramState.RUNNING
    return verb == STOP and status.state in ENDED


async def _change(
    program: ProgramEntry, verb: str, folder: Path, before: ProgramStatus, until: float
) -> ChangeOutcome:
    ended = await _ask(program, verb, folder, before, until)
    if ended.code != 0:
        # What ssh lost on the way may have been carried out, and so may what took too long.
        unclear = ended.is_late or (program.host and ended.code == SSH_FAILED)
        return ChangeOutcome(NOT_CONFIRMED if unclear else REFUSED, failure(program, ended))
    return await _outcome(program, verb, folder, before, until)


async def _ask(
    program: ProgramEntry, verb: str, folder: Path, before: ProgramStatus, until: float
) -> EndedProcess:
    """Run the process that starts, stops or restarts it."""

    async def ask(asked: list[str]) -> EndedProcess:
        return await run(asked, max(0.1, until - time.monotonic()))

    if program.status:
        return await ask(arguments.on_host(program, program.start if verb == START else program.stop))
    if program.unit or (before.has_systemd and verb == STOP):
        return await ask(arguments.change_unit(program, verb))
    if before.has_systemd or program.host:
        # systemd keeps the unit of a command that failed, and its name.
        await ask(arguments.change_unit(program, "reset-failed"))
        return await ask(arguments.start_kept(program, os.environ))
    if verb == START:
        return await ask(arguments.start_session(program, folder))
    problem = await asyncio.to_thread(stop_session, folder, program.name)
    return EndedProcess(None if problem else 0, problem=problem)


async def _outcome(
    program: ProgramEntry, verb: str, folder: Path, before: ProgramStatus, until: float
) -> ChangeOutcome:
    """Look at the program until its state is as asked for."""
    steady: tuple[str, float] | None = None
    while True:
        now = await look(program, folder)
        is_new = now.instance != before.instance
        if verb == STOP and now.state in ENDED:
            return ChangeOutcome(CONFIRMED, now.detail if now.state is ProgramState.FAILED else EMPTY)
        if verb != STOP and now.state is ProgramState.FAILED and (is_new or before.state is not now.state):
            return ChangeOutcome(FAILED, Message("{detail}: see its log", detail=now.detail))
        if now.state is not ProgramState.RUNNING or (verb == RESTART and now.instance and not is_new):
            steady = None
        elif steady is None or steady[0] != now.instance:
            steady = now.instance, time.monotonic()
        elif verb != STOP and time.monotonic() - steady[1] >= STEADY:
            return ChangeOutcome(CONFIRMED)
        if time.monotonic() >= until:
            return ChangeOutcome(
                NOT_CONFIRMED,
                joined(
                    " ", filter(None, (Message("is {state}", state=Message(now.state.value)), now.detail))
                ),
            )
        await asyncio.sleep(LOOK_EVERY)
