"""Turns events into records for `part_files`, and counts those that the disk did not take."""

import logging
import secrets
import time
from pathlib import Path
from typing import Any

import msgspec

from fleet_tui import __version__
from fleet_tui.config.schema import Config
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.entries import Origin, alarm_records, command_records
from fleet_tui.records.recording.gzip_members import LONGEST_LINE
from fleet_tui.records.recording.part_files import PartFiles, PartLimits
from fleet_tui.records.recording.records import (
    VERSION,
    EventRecord,
    Keyframe,
    Lost,
    Mark,
    Packer,
    ReceivedFrame,
    Record,
    RecordingHeader,
    SentFrame,
    encode,
    encode_all,
    plain,
    public,
)

LOG = logging.getLogger(__name__)

AT_ONCE = 2**20
"""Bytes of frames that are packed at once."""
LONGEST_ESCAPE = 6
"""Maximum bytes in JSON for one byte of text."""
ENCODING = (ValueError, TypeError, OverflowError, NotImplementedError, msgspec.MsgspecError)


class PartWriter:
    """Runs in one thread. All times are monotonic."""

    def __init__(self, first: Path, config: Config, origin: Origin, limits: PartLimits) -> None:
        """Begin. Raises RecordingError as PartFiles does."""
        self.wants_keyframe = False
        self.records = 0
        self._config = public(config)
        self._origin = origin
        self._id = secrets.token_hex(8)
        self._packer = Packer()
        self._records: list[Any] = []
        self._at = self._offset = 0.0
        self._lost = self._unsure = self._waiting = 0
        self._why = ""
        self.note_time()
        self.files = PartFiles(first, limits, self._head)

    def note_time(self) -> None:
        """Read both clocks: one may have been set."""
        self._offset = time.time() - time.monotonic()

    def received(self, at: float, link: str, channel: str, payload: bytes, binary: bool) -> None:
        """Record a received frame."""
        came = at if at < self._at else None
        text, data = _as_text(payload)
        self._add(ReceivedFrame(*self._times(at), link, channel, text, data, binary, came), len(payload))

    def sent(self, at: float, link: str, channel: str, payload: bytes) -> None:
        """Record a sent frame."""
        self._add(SentFrame(*self._times(at), link, channel, *_as_text(payload)), len(payload))

    def event(self, at: float, event: Event) -> None:
        self._add(EventRecord(*self._times(at), event))

    def changed(self, at: float, before: FleetState, after: FleetState) -> None:
        """Record the change of a command or an alarm."""
        at, wall = self._times(at)
        commands = command_records(self._origin, before, after, lambda then: wall - (at - then))
        for record in (*commands, *alarm_records(self._origin, before, after, wall)):
            self._add(Mark(at, wall, record))

    def missed(self, at: float, records: int, why: str) -> None:
        """Count records lost before they arrived here."""
        self.lose(why, records)
        self._record_loss(at)

    def keyframe(self, at: float, state: FleetState) -> None:
        """Record the whole state. A new file may begin here."""
        self.wants_keyframe = False
        at, wall = self._times(at)
        self._write_lines()
        record = Keyframe.of(at, wall, state, self._packer)
        self._packer.forget()
        # The first one shares a member with the header.
        is_first = not self.records and self.files.is_open
        if is_first or self._keeps(self.files.turn(at)):
            self._unsure = 0
            self._add(record, len(record.state))
            self._record_loss(at)
            self._write_lines()

    def flush(self, whole: bool = False) -> None:
        """Make everything so far readable, if the disk takes it; `whole`: to its very end."""
        self._write_lines()
        if self._keeps(not self.files.is_open or self.files.flush(whole)):
            self._unsure = 0
        self.wants_keyframe = self.files.needs_turn(self._at)

    def close(self) -> None:
        """End the file properly."""
        self._write_lines()
        self.files.close()

    def lose(self, why: str, count: int = 1) -> None:
        """Count a lost record."""
        self._lost += count
        self._why = why

    def _head(self, part: int, at: float) -> bytes:
        at, wall = self._times(at)
        header = RecordingHeader(
            VERSION, __version__, self._id, part, at, wall, self._origin.demo, self._config
        )
        return encode(header, self._packer)

    def _times(self, at: float) -> tuple[float, float]:
        self._at = max(self._at, at)
        return self._at, self._at + self._offset

    def _add(self, record: Record, size: int = 0) -> None:
        """Add a record with `size` bytes of foreign text."""
        if not self.files.is_open:
            self.lose(self.files.problem)
            return
        self._records.append(plain(record, self._packer))
        self._waiting += size
        if self._waiting > AT_ONCE:
            self._write_lines()

    def _record_loss(self, at: float) -> None:
        if self._lost and self.files.is_open:
            LOG.warning("recording: %d records missing: %s", self._lost, self._why)
            self._add(Lost(*self._times(at), self._lost, self._why))
            self._lost = 0

    def _write_lines(self) -> None:
        records, self._records, is_small = self._records, [], self._waiting < LONGEST_LINE // LONGEST_ESCAPE
        self._waiting = 0
        if not records or not self.files.is_open:
            return
        try:
            # Together, packing takes a third of the time.
            lines, count = (encode_all(records, self._packer) if is_small else b""), len(records)
        except ENCODING:
            is_small = False
        if not is_small:
            each = [line for record in records if (line := self._line(record))]
            lines, count = b"".join(each), len(each)
        self._unsure += count
        if self._keeps(self.files.write(lines)):
            self.records += count

    def _line(self, record: Any) -> bytes:
        try:
            line = encode_all([record], self._packer)
        except ENCODING as problem:
            LOG.warning("recording: record not written: %s", problem)
            self.lose(f"record not written: {problem}")
            return b""
        if len(line) > LONGEST_LINE:
            self.lose(f"a record of {len(line):,} bytes is too long")
            return b""
        return line

    def _keeps(self, done: bool) -> bool:
        """Tell whether an operation succeeded. If not, the data packed since the last flush is incomplete on
        the disk."""
        if not done:
            self.lose(self.files.problem, self._unsure)
            self._unsure = 0
        return done


def _as_text(payload: bytes) -> tuple[str, bytes]:
    try:
        return payload.decode(), b""
    except UnicodeDecodeError:
        return "", payload
