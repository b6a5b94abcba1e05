"""Argument lists for systemd, for logs, and over ssh."""

import os
import shlex
import sys
from collections.abc import Mapping
from pathlib import Path

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.programs.session import LOG_SUFFIX

CONNECT_WITHIN = 5
"""Seconds until ssh gives up a host."""
PROPERTIES = (
    "LoadState",
    "ActiveState",
    "SubState",
    "Result",
    "ExecMainStatus",
    "NRestarts",
    "StateChangeTimestamp",
    "InvocationID",
    "RequiredBy",
    "BoundBy",
    "ConsistsOf",
)
PASSED_ON = (
    "PATH",
    "PYTHONPATH",
    "LD_LIBRARY_PATH",
    "CMAKE_PREFIX_PATH",
    "AMENT_PREFIX_PATH",
    "COLCON_PREFIX_PATH",
    "RMW_IMPLEMENTATION",
    "CYCLONEDDS_URI",
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "FASTDDS_DEFAULT_PROFILES_FILE",
)
"""Variables of a sourced ROS, beside those that begin with ROS: systemd starts programs without ours."""
LINES = 1000
"""Lines of a log that are shown before the newest."""
_PLAIN = ("env", "TZ=UTC", "LC_ALL=C")


def unit_of(program: ProgramEntry) -> str:
    """Return its unit: its own, or that of its command."""
    return program.unit or f"fleet-tui-program-{program.name}.service"


def on_host(program: ProgramEntry, arguments: list[str]) -> list[str]:
    """Return the arguments that run others on the program's host. Quoted, they are words to its shell."""
    if not program.host:
        return arguments
    options = (
        "BatchMode=yes",
        f"ConnectTimeout={CONNECT_WITHIN}",
        "ServerAliveInterval=5",
        "ClearAllForwardings=yes",
    )
    return ["ssh", *(f"-o{option}" for option in options), "--", program.host, shlex.join(arguments)]


def _systemctl(program: ProgramEntry) -> list[str]:
    own = program.user or program.is_kept
    return [*_PLAIN, "systemctl", *(["--user"] if own else []), "--no-ask-password", "--no-pager"]


def show(program: ProgramEntry) -> list[str]:
    """Return the arguments that print the state of its unit."""
    return on_host(
        program, [*_systemctl(program), "show", f"--property={','.join(PROPERTIES)}", "--", unit_of(program)]
    )


def change_unit(program: ProgramEntry, verb: str) -> list[str]:
    """Return the arguments that start, stop or restart its unit. The unit's state tells the outcome."""
    return on_host(program, [*_systemctl(program), "--no-block", verb, "--", unit_of(program)])


def start_kept(program: ProgramEntry, environment: Mapping[str, str]) -> list[str]:
    """Return the arguments that start its command as a unit of its own. On this machine, with ROS as it is
    sourced here."""
    passed = {} if program.host else environment
    variables = [
        f"--setenv={name}={value}"
        for name, value in passed.items()
        if name.startswith("ROS") or name in PASSED_ON
    ]
    own = ["systemd-run", "--user", "--quiet", f"--unit={unit_of(program)}", *variables]
    return on_host(program, [*own, "--", *program.start])


def start_session(program: ProgramEntry, folder: Path) -> list[str]:
    """Return the arguments that start its command in a session of its own, without systemd."""
    own = [sys.executable, "-P", "-m", "fleet_tui.programs.session"]
    return [*own, str(folder), program.name, *program.start]


def log(program: ProgramEntry, folder: Path, has_systemd: bool, follow: bool = True) -> list[str]:
    """Return the arguments that print the end of its log, and what follows. Its own `log` always follows."""
    if program.log:
        return on_host(program, program.log)
    if program.is_kept and not has_systemd:
        path = os.fspath(folder / f"{program.name}{LOG_SUFFIX}")
        return ["tail", "-n", str(LINES), *(["-F"] if follow else []), path]
    own = "--user-unit" if program.user or program.is_kept else "--unit"
    options = ["--no-pager", "--output=short-iso", f"--lines={LINES}", *(["--follow"] if follow else [])]
    return on_host(program, ["env", "LC_ALL=C", "journalctl", f"{own}={unit_of(program)}", *options])
