"""Scans a recording once: its content and positions."""

import math
import os
from collections.abc import Callable, Iterator
from pathlib import Path

import msgspec

from fleet_tui.config.check import checked
from fleet_tui.records.recording.gzip_members import Lines, open_plain
from fleet_tui.records.recording.part_files import parts_beside
from fleet_tui.records.recording.recording import LAST_SECOND, Instant, KeyframeLocation, Recording
from fleet_tui.records.recording.records import (
    VERSION,
    Keyframe,
    Lost,
    Mark,
    RecordingError,
    RecordingHeader,
    decode,
)
from fleet_tui.text.language import Message

MOST_MARKS = 100_000
"""Maximum marks, and losses, in memory."""
LONGEST_UP = 1e11
"""Monotonic seconds: above any machine's uptime."""

# Nearly all records; they are decoded on playing.
_BULK = (b'{"kind":"heard"', b'{"kind":"sent"', b'{"kind":"told"')


class _Stamp(msgspec.Struct):
    """The fields that every record has."""

    kind: str
    at: float = math.nan
    wall: float = math.nan
    version: int = 0


_STAMPS = msgspec.json.Decoder(_Stamp)


def _stamp(line: bytes) -> _Stamp:
    try:
        return _STAMPS.decode(line)
    except (msgspec.MsgspecError, ValueError, RecursionError):
        raise RecordingError(Message("line is not a record")) from None


def open_recording(path: Path, progress: Callable[[float], None] = lambda _share: None) -> Recording:
    """Scan all parts of a file's recording. `progress` is called with the share done, from 0 to 1. Raises
    RecordingError."""
    found, notes = _parts(path)
    recording = Recording(path, found[0][1], notes=notes)
    total = sum(size for _, _, size in found)
    done = 0
    for part, _, size in found:
        for read in _look_through(recording, part):
            progress(min(1.0, (done + read) / total))
        done += size
    if not recording.keyframes:
        raise RecordingError(
            Message("{path}: nothing to play: {note}", path=path, note=recording.note or "just started")
        )
    return recording


def _parts(path: Path) -> tuple[list[tuple[Path, RecordingHeader, int]], list[str]]:
    """Return the parts with their headers and sizes, and the problems of others with such a name."""
    found: dict[Path, tuple[Path, RecordingHeader, int]] = {}
    problems: dict[Path, RecordingError] = {}
    for part in parts_beside(path):
        try:
            found[part] = part, *_header(part)
        except RecordingError as problem:
            problems[part] = problem
    if path in problems:
        raise problems[path]
    if not found:
        found[path] = path, *_header(path)
    # The first ones may be gone: a service keeps a limited number.
    _, wanted, _ = found.get(path) or next(iter(found.values()))
    parts = [part for part in found.values() if part[1].recording == wanted.recording]
    return parts, [str(problem) for problem in problems.values()]


def _header(path: Path) -> tuple[RecordingHeader, int]:
    """Return the header of a file, and its bytes. Raises RecordingError with the file's name."""
    with open_plain(path) as file:
        lines = Lines(file)
        try:
            _, line = next(iter(lines), (0, b""))
            stamp = _stamp(line) if line else None
            if stamp is None or stamp.kind != "header":
                why = lines.note or "wrong header"
                raise RecordingError(Message("is not a fleet-tui recording: {why}", why=why))
            if stamp.version > VERSION:
                raise RecordingError(
                    Message(
                        "was written by a newer fleet-tui (format {version}, this one reads {own_version}):"
                        " update fleet-tui",
                        version=stamp.version,
                        own_version=VERSION,
                    )
                )
            header = decode(line, stamp.version)
            assert isinstance(header, RecordingHeader)
            problems = checked(header.config)
            if problems:
                raise RecordingError(
                    Message("contains an invalid configuration: {problems}", problems=problems[0])
                )
        except RecordingError as problem:
            raise RecordingError(Message("{path}: {problem}", path=path, problem=problem)) from None
        return header, max(1, os.fstat(file.fileno()).st_size)


def header_of(path: Path) -> RecordingHeader:
    """Return the header of a file. Raises RecordingError."""
    return _header(path)[0]


def _look_through(recording: Recording, part: Path) -> Iterator[int]:
    """Add the content of a part to the recording. Yields the bytes read so far."""
    recording.parts.append(part)
    try:
        with open_plain(part) as file:
            lines = Lines(file)
            yield from _take_lines(recording, part, lines)
            if lines.note:
                recording.notes.append(f"{part.name}: {lines.note}")
    except RecordingError as problem:
        message = str(problem).removeprefix(f"{part}: ")
        recording.notes.append(f"{part.name}: {message}: the rest is left out")


def _take_lines(recording: Recording, part: Path, lines: Lines) -> Iterator[int]:
    reported = in_member = nth = 0
    last = b""
    try:
        for member, line in lines:
            if lines.done != reported:
                yield (reported := lines.done)
            if line.startswith(_BULK):
                last = line
                continue
            if last:
                _reach(recording, last)
                last = b""
            nth = nth if member == in_member else 0
            in_member = member
            nth += _take(recording, KeyframeLocation(part, member, nth), line)
    finally:
        if last:
            _reach(recording, last)


def _take(recording: Recording, place: KeyframeLocation, line: bytes) -> bool:
    """Add a record; tell whether it is a keyframe."""
    moment = _reach(recording, line)
    record = decode(line, recording.header.version)
    match record:
        case RecordingHeader():
            _follow(recording, place.path, record)
        case Keyframe():
            recording.keyframes.append(moment)
            recording.places.append(place)
        case Mark() if len(recording.marks) < MOST_MARKS:
            recording.marks.append(record)
        case Lost() if len(recording.lost) < MOST_MARKS:
            recording.lost.append(record)
    return isinstance(record, Keyframe)


def _follow(recording: Recording, path: Path, header: RecordingHeader) -> None:
    """Check the part number. The first parts may have been deleted to save space; one missing in between was
    lost."""
    gone = header.part - recording.part - 1
    if header.recording == recording.header.recording and recording.part >= 0 and gone > 0:
        parts = "part is" if gone == 1 else "parts are"
        recording.notes.append(f"{path.name}: {gone} {parts} missing before it")
    recording.part = header.part


def _reach(recording: Recording, line: bytes) -> Instant:
    """Return the instant of a record, the end of the recording so far."""
    stamp = _stamp(line)
    earliest = max(0.0, recording.end.at)
    if stamp.kind != "header" and not (earliest <= stamp.at < LONGEST_UP and 0.0 <= stamp.wall < LAST_SECOND):
        raise RecordingError(Message("record with an impossible time"))
    moment = Instant(stamp.at, stamp.wall)
    if stamp.kind != "header":
        recording.end = moment
    return moment
