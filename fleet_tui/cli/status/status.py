"""The `status` command: the fleet as a table, as JSON or as one line."""

import json
import shutil
import time
from collections.abc import Callable

import msgspec

from fleet_tui.cli.session import WaitingStore, has_link, is_known, session
from fleet_tui.cli.status.report import attention, changes, report, untried
from fleet_tui.config.schema import Config
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.lines.status import status_line
from fleet_tui.ui.view.tables.alarms import alarm_table
from fleet_tui.ui.view.tables.fleet import fleet_table
from fleet_tui.ui.view.tables.table import Run

FINE = 0
ATTENTION = 1
NO_LINK = 3
WATCH_EVERY = 1.0
RIPENS = 0.5
ONE_LINE = 79

Say = Callable[[str], None]


def _text(runs: tuple[Run, ...]) -> str:
    return "".join(text for text, _ in runs).rstrip()


def table(state: FleetState) -> str:
    """Return the fleet as text: the same rows as the console's, then the things that need attention."""
    width = max(60, shutil.get_terminal_size((120, 24)).columns)
    first = next(iter(state.robots))
    fleet = fleet_table(state, first, width)
    lines = [_text(status_line(state, "")), *(_text(row.runs) for row in fleet.rows)]
    alarms = alarm_table(state, lambda wall: time.strftime("%H:%M:%S", time.localtime(wall)))
    lines += [_text(row.runs) for row in alarms.rows]
    wrong = attention(state)
    lines += (
        [f"! {sanitize(line)}" for line in wrong]
        or [f"{sanitize(fact.source)}: {fact.text}" for fact in untried(state)]
        or ["all well"]
    )
    return "\n".join(line.strip() for line in lines)


def one_line(state: FleetState) -> str:
    """Return the text for a status bar: the robots online, and the first thing that needs attention."""
    online = sum(state.is_online(robot) for robot in state.robots.values())
    wrong = attention(state)
    text = f"{online}/{len(state.robots)} online"
    if wrong:
        more = f" +{len(wrong) - 1}" if len(wrong) > 1 else ""
        space = ONE_LINE - len(text) - len(more) - 3
        first = sanitize(wrong[0])
        text += f" ! {first if len(first) <= space else first[: space - 3] + '...'}{more}"
    return text


def verdict(state: FleetState) -> int:
    """Return the exit code for the state of the fleet."""
    if not has_link(state):
        return NO_LINK
    return ATTENTION if attention(state) else FINE


def _watch(store: WaitingStore, state: FleetState, as_json: bool, oneline: bool, say: Say) -> None:
    """Print changes after a state that was printed, until interrupted."""
    before, said = report(state), one_line(state)
    while True:
        time.sleep(WATCH_EVERY)
        state = store.state
        if oneline:
            if (line := one_line(state)) != said:
                say(line)
            said = line
            continue
        after = report(state)
        changed = changes(before, after)
        if changed:
            say(json.dumps(changed) if as_json else table(state) + "\n")
            before = after


def status(config: Config, timeout: float, as_json: bool, oneline: bool, watch: bool, say: Say) -> int:
    """Print the state of the fleet; return the exit code."""
    with session(msgspec.structs.replace(config, watches=True)) as (_, store):
        store.wait(is_known, timeout)
        # Alarms advance at the next tick of the clock.
        known_at = time.monotonic()
        store.wait(lambda state: state.now > known_at, RIPENS)
        state = store.state
        if oneline:
            say(one_line(state))
        else:
            say(json.dumps(report(state)) if as_json else table(state))
        if watch:
            _watch(store, state, as_json, oneline, say)
        return verdict(state)
