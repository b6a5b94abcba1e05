"""`fleet-tui routine list`: the routines with their states."""

import json
from datetime import UTC, datetime

from fleet_tui.cli.orders.outcome import DONE, NOT_DONE
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.features.routines.cli.reading import Say, place_of
from fleet_tui.features.routines.folder import look_at_all
from fleet_tui.features.routines.lines import NEVER, row_word
from fleet_tui.features.routines.row import RoutineRow
from fleet_tui.text.sanitize import sanitize

VERSION = 1


def list_routines(config: Config, as_json: bool, say: Say) -> int:
    """Print the routines; return the exit code."""
    place = place_of(config)
    rows = look_at_all(place, initial_state(config, 0.0))
    if as_json:
        found = {"folder": str(place.folder), "routines": [_values(row) for row in rows]}
        say(json.dumps({"version": VERSION, **found}))
    elif not rows:
        say(
            sanitize(f"no routine in {place.folder}: create NAME.routine there, see: fleet-tui docs routines")
        )
    else:
        width = max(len(row.name) for row in rows)
        for row in rows:
            parts = (", ".join(row.times) or "no time", ", ".join(row.plans), _state(row), row.problem)
            say(sanitize(f"{row.name:<{width}}  " + "; ".join(part for part in parts if part)))
    return NOT_DONE if any(row.problem for row in rows) else DONE


def _values(row: RoutineRow) -> dict[str, object]:
    last = datetime.fromtimestamp(row.at, UTC).isoformat(timespec="seconds") if row.lanes else ""
    state = row_word(row) if row.lanes else ""
    known = {"name": row.name, "times": list(row.times), "robots": list(row.plans), "state": state}
    return {**known, "last": last, "owner": row.owner, "problem": row.problem}


def _state(row: RoutineRow) -> str:
    if not row.lanes:
        return NEVER
    when = datetime.fromtimestamp(row.at)
    return f"{row_word(row)} {when:%m-%d %H:%M}" + (f" by {row.owner}" if row.owner else "")
