"""The states of all programs, as lines or JSON."""

import asyncio
import json
import time
from collections.abc import Callable, Sequence
from datetime import UTC, datetime

from fleet_tui.cli.orders.outcome import DONE, NOT_DONE
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.programs import ProgramEntry
from fleet_tui.features.programs.table import program_table
from fleet_tui.model.programs.program import ProgramRow, ProgramState
from fleet_tui.programs.watch import ProgramWatch

VERSION = 1
AT_ONCE = 8
"""Looks at the same time, of all hosts."""
_BAD = (ProgramState.FAILED, ProgramState.UNKNOWN)


async def looked_at(programs: Sequence[ProgramEntry]) -> dict[str, ProgramRow]:
    """Look at every program once."""
    watch, free = ProgramWatch(programs, state_folder() / "programs"), asyncio.Semaphore(AT_ONCE)

    async def look(name: str) -> None:
        async with free:
            await watch.look(name)

    await asyncio.gather(*map(look, watch.programs))
    return watch.rows


async def list_programs(programs: Sequence[ProgramEntry], as_json: bool, say: Callable[[str], None]) -> int:
    """Print the programs; return the exit code."""
    rows = list((await looked_at(programs)).values())
    now = time.monotonic()
    if as_json:
        say(json.dumps({"version": VERSION, "programs": [_values(row, now) for row in rows]}))
    else:
        table = program_table(rows, _local, now)
        for runs in (table.head, *(row.runs for row in table.rows)):
            say("".join(text for text, _ in runs).rstrip())
    return NOT_DONE if any(row.state(now) in _BAD for row in rows) else DONE


def _values(row: ProgramRow, now: float) -> dict[str, object]:
    status = row.status
    assert status is not None
    since = None if status.since is None else datetime.fromtimestamp(status.since, UTC).isoformat()
    return {
        "name": row.name,
        "host": row.host,
        "state": row.state(now).value,
        "since": since,
        "restarts": status.restarts,
        "detail": status.detail,
        "stops_with_it": list(status.dependents),
        "needs": list(row.needs),
    }


def _local(wall: float) -> str:
    return f"{datetime.fromtimestamp(wall):%m-%d %H:%M}"
