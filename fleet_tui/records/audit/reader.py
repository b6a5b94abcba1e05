"""Reads the audit log, newest record first, ignoring foreign lines in its files."""

import os
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import msgspec

from fleet_tui.model.audit_record import VERSION, AuditRecord
from fleet_tui.records.audit.file import KEPT
from fleet_tui.storage.handles import open_file
from fleet_tui.storage.line_file import part

Fields = dict[str, Any]


def upgrade_audit(record: Fields) -> Fields:
    """Upgrade a line of the audit log. Raises KeyError, TypeError, ValueError."""
    if record["version"] >= VERSION:
        return record
    return record | {name: text_id(record[name]) for name in ("start", "end", "order") if name in record}


def text_id(number: object) -> str | None:
    """Return an id as text; None stays None."""
    return None if number is None else str(int(str(number)))


BLOCK = 2**16
LONGEST = 2**20
"""Maximum bytes of a line; longer ones are foreign."""

_DECODER = msgspec.json.Decoder(AuditRecord)


@dataclass(slots=True)
class AuditReader:
    """The records of a log and its older parts. `unreadable` counts the invalid lines so far: cut by a kill
    or a full disk, or foreign."""

    path: Path
    unreadable: int = 0

    @property
    def note(self) -> str:
        """Return a note on the lines so far."""
        if not self.unreadable:
            return ""
        return f"{self.unreadable} unreadable line{'s' * (self.unreadable != 1)}"

    def newest_first(self) -> Iterator[AuditRecord]:
        """Return the records; none without a file. Raises OSError if one can't be read."""
        with ExitStack() as stack:
            # All at once, newest first: a file renamed meanwhile is read twice, never missed.
            files: dict[int, BinaryIO] = {}
            for number in range(KEPT):
                try:
                    file = stack.enter_context(open_file(part(self.path, number)))
                except FileNotFoundError:
                    continue
                files.setdefault(os.fstat(file.fileno()).st_ino, file)
            for file in files.values():
                for line in _lines_backwards(file):
                    record = decoded(line)
                    if record is None:
                        self.unreadable += bool(line.strip())
                    else:
                        yield record


def decoded(line: bytes) -> AuditRecord | None:
    """Return the record of a line, also of an older version; None for another text."""
    try:
        return _DECODER.decode(line)
    except msgspec.ValidationError:
        return _of_older_version(line)
    except (msgspec.MsgspecError, UnicodeError, RecursionError):
        return None


def _of_older_version(line: bytes) -> AuditRecord | None:
    try:
        return msgspec.convert(upgrade_audit(msgspec.json.decode(line)), AuditRecord)
    except (msgspec.MsgspecError, KeyError, TypeError, ValueError, RecursionError):
        return None


def _lines_backwards(file: BinaryIO) -> Iterator[bytes]:
    """Return the lines of a file, the last one first. Half a line, after the last newline, is marked so that
    it is no record even if it looks like one."""
    end = file.seek(0, os.SEEK_END)
    mark = b"?"
    pieces: list[bytes] = []  # of the line whose beginning is not read yet, the last piece first
    while end > 0:
        start = max(0, end - BLOCK)
        file.seek(start)
        first, *lines = file.read(end - start).split(b"\n")
        end = start
        if lines:
            line = b"".join([lines.pop(), *reversed(pieces)])
            yield line and line + mark
            yield from reversed(lines)
            mark, pieces = b"", []
        if sum(map(len, pieces)) < LONGEST:
            pieces.append(first)
    line = b"".join(reversed(pieces))
    yield line and line + mark
