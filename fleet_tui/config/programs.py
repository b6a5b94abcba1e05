"""`[[programs]]`: programs of the robot servers, and what is wrong with them."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence

import msgspec

from fleet_tui.text.errors import did_you_mean

MOST_PROGRAMS = 100
_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,63}")
# Not an option, and no pattern: systemctl would match several units with it.
_UNIT = re.compile(r"[A-Za-z0-9_@:][A-Za-z0-9_@:.\\-]{0,250}")
# ssh reads a name that begins with - as an option, and puts names into shell commands of its own settings.
_HOST = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.@:-]{0,250}")


class ProgramEntry(msgspec.Struct, frozen=True):
    """`[[programs]]`: a systemd `unit` (of the `user`'s own systemd if set), or argument lists. `start` alone
    is kept running apart from the console; with `stop` and `status` it ends by itself, and `status` tells by
    its exit code whether the program runs. `log` follows its log. `host` is an alias of ssh, `needs` names
    programs that it needs."""

    name: str
    unit: str = ""
    user: bool = False
    start: list[str] = []
    stop: list[str] = []
    status: list[str] = []
    log: list[str] = []
    host: str = ""
    needs: list[str] = []

    @property
    def is_kept(self) -> bool:
        """Tell whether its command is kept running for the console."""
        return not self.unit and not self.status


def check_programs(programs: Sequence[ProgramEntry]) -> Iterator[str]:
    """Return one line for each problem of the table."""
    if len(programs) > MOST_PROGRAMS:
        yield f"programs: {len(programs)} entries, at most {MOST_PROGRAMS}"
    names = [program.name for program in programs]
    for name, count in Counter(names).items():
        if count > 1:
            yield f"programs: name {name} used {count} times"
    for n, program in enumerate(programs):
        for problem in (*_form(program), *_names(program), *_needs(program, names)):
            yield f"programs[{n}].{problem}"


def _form(program: ProgramEntry) -> Iterator[str]:
    if program.unit and (program.start or program.stop or program.status):
        yield "unit: use unit or start, stop and status, not both"
    elif not program.unit and not program.start:
        yield 'start: missing: set unit = "NAME.service" or start = ["PROGRAM", "ARGUMENT"]'
    elif bool(program.stop) != bool(program.status):
        missing, other = ("status", "stop") if program.stop else ("stop", "status")
        yield f"{missing}: missing: {other} needs it; leave out both to let the console keep the program"
    if program.user and not program.unit:
        yield "user: only for a unit"
    for key in ("start", "stop", "status", "log"):
        arguments: list[str] = getattr(program, key)
        if arguments and not arguments[0]:
            yield f"{key}: begins with an empty text: put the program first"
        if any("\0" in one for one in arguments):
            yield f"{key}: contains a null character"


def _names(program: ProgramEntry) -> Iterator[str]:
    if not _NAME.fullmatch(program.name):
        yield f"name: {program.name!r}: use up to 64 letters, digits, _, . and -, not - or . first"
    if program.unit and not _UNIT.fullmatch(program.unit):
        yield f"unit: {program.unit!r} is not the name of a unit, expected e.g. rosbridge.service"
    if program.host and not _HOST.fullmatch(program.host):
        yield f"host: {program.host!r} is not a host for ssh: use an alias of ~/.ssh/config"


def _needs(program: ProgramEntry, names: Sequence[str]) -> Iterator[str]:
    for need in program.needs:
        if need == program.name:
            yield f"needs: {need} needs itself: remove it"
        elif need not in names:
            yield f"needs: unknown program {need!r}{did_you_mean(need, names)}"
