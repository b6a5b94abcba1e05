"""Starts, stops and restarts of programs from a shell: asked, audited, and waited for."""

import asyncio
import sys
import time
from collections.abc import Callable

import click

from fleet_tui.cli.orders.giving import forbidden
from fleet_tui.cli.orders.outcome import DONE, NOT_DONE
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.programs import ProgramEntry
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.features.programs.cli.listing import looked_at
from fleet_tui.features.programs.questions import change_question
from fleet_tui.model.problem import Right
from fleet_tui.model.programs.program import NOT_CONFIRMED, ChangeOutcome
from fleet_tui.programs.change import change
from fleet_tui.records.audit.log import auditing
from fleet_tui.state.store import Store
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize

Say = Callable[..., None]


def change_program(
    config: Config, program: ProgramEntry, verb: str, within: float, yes: bool, say: Say
) -> int:
    """Change a program; return the exit code. Raises click's UsageError if nobody can be asked."""
    if reason := forbidden(config, Right.SETUP):
        say(sanitize(f"{program.name}: {verb} refused ({reason})"), err=True)
        return NOT_DONE
    if not yes and not _is_wanted(config, program, verb):
        return NOT_DONE
    outcome = _audited(config, program, verb, within, say)
    say(sanitize(f"{program.name}: {verb} {outcome.text}"), err=not outcome.is_confirmed)
    return DONE if outcome.is_confirmed else NOT_DONE


def _is_wanted(config: Config, program: ProgramEntry, verb: str) -> bool:
    if not sys.stdin.isatty():
        raise click.UsageError(f"{verb} {program.name}: use --yes where nobody can be asked")
    rows = asyncio.run(looked_at(config.programs))
    return click.confirm(change_question(rows, program.name, verb, time.monotonic()), err=True)


def _audited(config: Config, program: ProgramEntry, verb: str, within: float, say: Say) -> ChangeOutcome:
    where = program.name + (f" on {program.host}" if program.host else "")
    outcome = ChangeOutcome(NOT_CONFIRMED, Message("interrupted"))
    with auditing(state_folder(), config, Store(initial_state(config, time.monotonic()))) as audit:
        audit.log_console(f"program {verb}", f"{where}: sent")
        try:
            outcome = asyncio.run(change(program, verb, state_folder() / "programs", within))
        finally:
            audit.log_console(f"program {verb}", f"{where}: {outcome.text}")
            for line in audit.notes:
                say(sanitize(line), err=True)
    return outcome
