"""Follows the audit log of this machine's consoles: what they write from now on."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.reader import decoded
from fleet_tui.storage.handles import open_file


class AuditTail:
    """Begins at the end of the log, and goes on in the next file when it was rotated."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._rest = b""
        self._file = self._opened()
        if self._file is not None:
            self._file.seek(0, os.SEEK_END)

    def new(self) -> Iterator[AuditRecord]:
        """Return the records since the last call. Raises OSError if the log can't be read."""
        yield from self._read()
        newest = self._opened()
        if newest is None:
            return
        if self._file is not None and os.path.sameopenfile(self._file.fileno(), newest.fileno()):
            newest.close()
            return
        yield from self._read()  # what was written before the other one began
        self.close()
        self._file = newest
        self._rest = b""
        yield from self._read()

    def close(self) -> None:
        """Let go of the file."""
        if self._file is not None:
            self._file.close()

    def _opened(self) -> BinaryIO | None:
        try:
            return open_file(self._path)
        except FileNotFoundError:
            return None

    def _read(self) -> Iterator[AuditRecord]:
        """Return the whole lines; half a one waits for its end."""
        if self._file is None:
            return
        *lines, self._rest = (self._rest + self._file.read()).split(b"\n")
        for line in lines:
            if (record := decoded(line)) is not None:
                yield record
