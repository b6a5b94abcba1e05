"""Reads lines from a gzip file, member by member, also truncated or damaged."""

import os
import stat
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from fleet_tui.records.recording.records import RecordingError
from fleet_tui.text.language import Message

READ = 2**16
UNPACKED = 2**20
"""Bytes to read, and to unpack, at a time: packed, a thousand bytes may be one."""
LONGEST_LINE = 2**28
"""Maximum bytes of a record."""


def open_plain(path: Path) -> BinaryIO:
    """Open a regular file; a pipe would block. Raises RecordingError."""
    try:
        fd = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    except FileNotFoundError:
        made = "record one with `fleet-tui record FILE`"
        raise RecordingError(Message("{path}: no such file: {made}", path=path, made=made)) from None
    except (OSError, ValueError) as problem:
        raise RecordingError(
            Message("{path}: unreadable: {problem}", path=path, problem=getattr(problem, "strerror", problem))
        ) from None
    if not stat.S_ISREG(os.fstat(fd).st_mode):
        os.close(fd)
        raise RecordingError(Message("{path}: not a file", path=path))
    return os.fdopen(fd, "rb")


@dataclass(slots=True)
class Lines:
    """The whole lines of a gzip file from a member on. After the last one, `note` describes an irregular end;
    `done` is the number of bytes read so far."""

    file: BinaryIO
    note: str = ""
    done: int = 0

    def __iter__(self) -> Iterator[tuple[int, bytes]]:
        """Yield each line, with the offset of the member in which it began. Raises RecordingError for a line
        that is too long, or unreadable data."""
        pieces: list[bytes] = []
        member = length = 0
        for offset, chunk in self._chunks():
            *lines, rest = chunk.split(b"\n")
            for line in lines:
                yield (member if pieces else offset), b"".join([*pieces, line])
                pieces, length = [], 0
            if rest:
                member = member if pieces else offset
                pieces.append(rest)
                length += len(rest)
                if length > LONGEST_LINE:
                    raise RecordingError(
                        Message(
                            "line longer than {longest_line} bytes: not a recording",
                            longest_line=f"{LONGEST_LINE:,}",
                        )
                    )
        if pieces and not self.note:
            self.note = "last record incomplete"

    def _chunks(self) -> Iterator[tuple[int, bytes]]:
        offset = self.file.tell()
        unpack, packed = zlib.decompressobj(wbits=31), b""
        started = False
        try:
            while packed := packed or self.file.read(READ):
                self.done = self.file.tell()
                started = True
                chunk = unpack.decompress(packed, UNPACKED)
                packed = unpack.unconsumed_tail
                if chunk:
                    yield offset, chunk
                if unpack.eof:
                    packed = unpack.unused_data
                    offset = self.file.tell() - len(packed)
                    unpack, started = zlib.decompressobj(wbits=31), False
            if started:
                self.note = "incomplete: truncated or still being written"
        except zlib.error:
            self.note = f"damaged: unreadable data after byte {offset:,} left out"
        except OSError as problem:
            raise RecordingError(Message("unreadable: {strerror}", strerror=problem.strerror)) from None
