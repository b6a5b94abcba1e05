"""The log of a program on standard output."""

import asyncio
from collections.abc import Callable

from fleet_tui.cli.orders.outcome import DONE, NOT_DONE
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.programs import ProgramEntry
from fleet_tui.programs.arguments import log
from fleet_tui.programs.log_tail import LogTail
from fleet_tui.programs.status import look

PRINT_EVERY = 0.1
QUIET = 2.0
"""Seconds of silence that end a log which always follows."""
LONGEST = 10.0
"""Seconds after which a log that is not followed ends in any case."""


async def print_log(
    program: ProgramEntry, follow: bool, say: Callable[[str], None], say_error: Callable[[str], None]
) -> int:
    """Print the lines of a log, and why it ended; return the exit code."""
    folder, tail = state_folder() / "programs", LogTail()
    has_systemd = not program.is_kept or bool(program.log) or (await look(program, folder)).has_systemd
    following = asyncio.ensure_future(tail.follow(log(program, folder, has_systemd, follow)))
    printed, quiet, rounds = 0, 0.0, 0
    while not following.done() and (follow or (quiet < QUIET and rounds * PRINT_EVERY < LONGEST)):
        await asyncio.wait({following}, timeout=PRINT_EVERY)
        before, printed, rounds = printed, _print_new(tail, printed, say), rounds + 1
        quiet = 0.0 if printed > before else quiet + PRINT_EVERY
    _print_new(tail, printed, say)
    following.cancel()
    await asyncio.wait({following})
    if tail.note and not tail.has_ended_well:
        say_error(f"{program.name}: {tail.note}")
        return NOT_DONE
    return DONE


def _print_new(tail: LogTail, printed: int, say: Callable[[str], None]) -> int:
    """Print the lines after that of a number; return the last number."""
    for number, line in list(tail.lines):
        if number > printed:
            say(line)
            printed = number
    return printed
