"""Routine files: NAME.routine in the folder of the configuration."""

import hashlib
import re
from pathlib import Path

from msgspec import Struct

from fleet_tui.config.small_file import read_text
from fleet_tui.config.trust import doubt_of_content
from fleet_tui.config.withholding import or_trusted
from fleet_tui.features.routines.blocks import ParsedRoutine
from fleet_tui.features.routines.rules.parsing import parse_routine
from fleet_tui.text.errors import RoutineError, did_you_mean
from fleet_tui.text.language import Message

SUFFIX = ".routine"
LARGEST = 100_000
"""Bytes of a file."""
MOST_ROUTINES = 200
NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,63}")
"""Names that the unit of a timer may have, too. None begins like an option or a hidden file."""


class RoutineFile(Struct, frozen=True):
    """A file that was read: `digest` tells whether it is still the same."""

    name: str
    path: Path
    parsed: ParsedRoutine
    digest: str


def routine_names(folder: Path) -> list[str]:
    """Return the names of the routines in a folder; none if it can't be read."""
    try:
        found = sorted(path.name for path in folder.iterdir() if path.suffix == SUFFIX)
    except OSError:
        return []
    return [name.removesuffix(SUFFIX) for name in found[:MOST_ROUTINES]]


def read_routine(folder: Path, name: str) -> RoutineFile:
    """Return a routine by its name. Raises RoutineError, also for one that somebody else could have
    written."""
    name = name.removesuffix(SUFFIX)
    if not NAME.fullmatch(name):
        raise RoutineError(
            Message(
                "routine {name}: use up to 64 letters, digits, _, . and -, not - or . first",
                name=f"{name[:80]!r}",
            )
        )
    path = folder / f"{name}{SUFFIX}"
    try:
        text = read_text(path, LARGEST)
    except FileNotFoundError:
        others = [one for one in routine_names(folder) if one != name]  # a broken link has this very name
        near = did_you_mean(name, others) or Message(": create {path}", path=path)
        raise RoutineError(Message("unknown routine {name}{near}", name=f"{name!r}", near=near)) from None
    except UnicodeDecodeError:
        raise RoutineError(Message("{path}: not UTF-8 text: save it as UTF-8", path=path)) from None
    except (OSError, ValueError) as problem:
        reason = (
            problem.strerror
            if isinstance(problem, OSError)
            else Message("{problem}: divide it", problem=problem)
        )
        raise RoutineError(Message("{path}: {reason}", path=path, reason=reason)) from None
    if found := doubt_of_content(path, text):
        raise RoutineError(or_trusted(found))
    return RoutineFile(name, path, parse_routine(text), hashlib.sha256(text.encode()).hexdigest())
