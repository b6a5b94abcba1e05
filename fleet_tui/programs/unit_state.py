"""The state of a systemd unit, from the output of `systemctl show` in UTC and English."""

from collections.abc import Mapping
from datetime import MAXYEAR, MINYEAR, UTC, datetime

from fleet_tui.model.programs.program import ProgramState, ProgramStatus
from fleet_tui.text.limits import truncate

MOST_DEPENDENTS = 50
_STATES = {
    "active": ProgramState.RUNNING,
    "reloading": ProgramState.RUNNING,
    "activating": ProgramState.STARTING,
    "deactivating": ProgramState.STOPPING,
    "inactive": ProgramState.STOPPED,
    "failed": ProgramState.FAILED,
}
_RESULTS = {
    "exit-code": "exit status {status}",
    "signal": "killed by signal {status}",
    "core-dump": "crashed with signal {status}",
    "timeout": "ended after its time limit",
    "oom-kill": "killed for lack of memory",
    "start-limit-hit": "started too often: systemd gave up",
}


def unit_status(output: str, unit: str, at: float) -> ProgramStatus | None:
    """Return the state of a unit, None if the output is none of `systemctl show`."""
    found = dict(line.split("=", 1) for line in output.splitlines() if "=" in line)
    state = _STATES.get(found.get("ActiveState", ""))
    if state is None:
        return None
    if found.get("LoadState") == "not-found" and state is ProgramState.STOPPED:
        return ProgramStatus(ProgramState.UNKNOWN, at, detail=f"no unit {unit}: check its name, and `user`")
    return ProgramStatus(
        state,
        at,
        _seconds(found.get("StateChangeTimestamp", "")),
        _count(found.get("NRestarts", "")),
        found.get("InvocationID", ""),
        tuple(_dependents(found)),
        _detail(state, found),
    )


def _detail(state: ProgramState, found: Mapping[str, str]) -> str:
    if state is ProgramState.FAILED:
        result = found.get("Result", "")
        return truncate(_RESULTS.get(result, result).replace("{status}", found.get("ExecMainStatus", "?")))
    if found.get("LoadState") in ("masked", "bad-setting", "error"):
        return f"its unit file is {found['LoadState']}"
    sub = found.get("SubState", "")
    return truncate(sub) if sub in ("auto-restart", "exited", "start-pre", "stop-sigterm") else ""


def _dependents(found: Mapping[str, str]) -> list[str]:
    units = [unit for key in ("RequiredBy", "BoundBy", "ConsistsOf") for unit in found.get(key, "").split()]
    return list(dict.fromkeys(map(truncate, units)))[:MOST_DEPENDENTS]


def _seconds(text: str) -> float | None:
    """Return a time as systemctl writes it, `Mon 2024-05-06 08:00:00 UTC`, in Unix seconds."""
    try:
        _, date, time, *_ = text.split()
        found = datetime.strptime(f"{date} {time}", "%Y-%m-%d %H:%M:%S").replace(tzinfo=UTC)
    except ValueError:
        return None
    # A day from either end of the calendar there is no local time.
    return found.timestamp() if MINYEAR < found.year < MAXYEAR else None


def _count(text: str) -> int | None:
    return int(text) if text.isdecimal() and len(text) < 10 else None
