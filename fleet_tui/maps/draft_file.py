"""Drafts of graphs on disk: each step is written as it is taken, so that a draft survives a crash."""

import os
from errno import EBUSY, EROFS
from hashlib import sha256
from pathlib import Path
from typing import BinaryIO
from urllib.parse import quote

import msgspec
from msgspec import Struct

from fleet_tui.config.schema import Config
from fleet_tui.model.graphs.document import DocumentFloor
from fleet_tui.model.graphs.draft import Change, GraphDraft
from fleet_tui.storage.handles import open_private
from fleet_tui.storage.lock import lock
from fleet_tui.text.language import as_written, in_english

SUFFIX = ".draft.jsonl"
LARGEST = 256 * 2**20
"""Bytes of a file that are read."""


class Begun(Struct, frozen=True, tag="begun"):
    """The first line: the floor before all steps."""

    floor: DocumentFloor


class Done(Struct, frozen=True, tag="done"):
    """A step was taken."""

    change: Change


class Undone(Struct, frozen=True, tag="undone"):
    """The last step was undone."""


class Redone(Struct, frozen=True, tag="redone"):
    """The step that was undone last was taken again."""


def draft_of(folder: Path, config: Config, demo: bool, floor: str) -> "DraftFile":
    """Return the file of a floor's draft; floors of the same name at other sites have others."""
    places = [str(config.path), *(link.url for link in config.bridges.values())]
    site = "demo" if demo else sha256("\n".join(places).encode()).hexdigest()[:8]
    return DraftFile(folder / "drafts", site, floor)


Line = Begun | Done | Undone | Redone


class DraftFile:
    """The draft of one floor in a folder. Methods raise OSError."""

    def __init__(self, folder: Path, site: str, floor: str) -> None:
        """`site` keeps floors of the same name apart."""
        self.path = folder / f"{quote(floor, safe=' ')[:80]}-{site}{SUFFIX}"
        self._file: BinaryIO | None = None
        self._readable = 0
        """Bytes of the lines that were read."""
        self._lost = ""
        """The reason that the file still has an earlier draft."""

    def load(self) -> GraphDraft | None:
        """Return the draft as it was when it was last written, None for a new floor. A line that was cut
        off by a crash is left out."""
        try:
            lines = self._read().splitlines(keepends=True)
        except FileNotFoundError:
            return None
        decoder, draft = msgspec.json.Decoder(Line, dec_hook=as_written), None
        self._readable = 0
        for text in lines:
            if not text.endswith(b"\n"):
                break
            try:
                line = decoder.decode(text)
            except msgspec.MsgspecError:
                break
            if isinstance(line, Begun):
                draft = GraphDraft(line.floor)
            elif draft is None:
                break
            elif isinstance(line, Done):
                draft.do(line.change)
            elif isinstance(line, Undone):
                draft.undo()
            else:
                draft.redo()
            self._readable += len(text)
        return draft

    def _read(self) -> bytes:
        with self.path.open("rb") as file:
            return file.read(LARGEST)

    def begin(self, draft: GraphDraft) -> None:
        """Start the file with a draft and its steps. A draft with steps that was in it is kept as `.bak`."""
        self.close()
        try:
            self._begin()
        except OSError as problem:
            folder = "" if problem.errno == EBUSY else f"{self.path.parent}: "
            self._lost = f"{folder}{problem.strerror}"
            raise OSError(problem.errno, self._lost) from None
        self._lost = ""
        self.write(Begun(draft.base), *map(Done, draft.done))

    def _begin(self) -> None:
        if self.path.exists():
            with self.path.open("r+b") as before:
                _lock(before)
                if before.read().count(b"\n") > 1:
                    self.path.replace(self.path.with_suffix(".bak"))
        handle = open_private(self.path, os.O_RDWR | os.O_CREAT)
        self._own(os.fdopen(handle, "r+b"), 0)

    def _own(self, file: BinaryIO, kept: int) -> None:
        """Write after the first bytes of a file that no other console writes to. Raises OSError."""
        try:
            _lock(file)
        except OSError:
            file.close()
            raise
        file.truncate(kept)
        file.seek(kept)
        self._file = file

    def write(self, *lines: Line) -> None:
        """Write steps: they survive this process."""
        if self._lost:
            raise OSError(EROFS, self._lost)
        if self._file is None:
            self._own(self.path.open("r+b"), self._readable)
        assert self._file is not None
        self._file.write(b"".join(msgspec.json.encode(line, enc_hook=in_english) + b"\n" for line in lines))
        self._file.flush()

    def close(self) -> None:
        """Close the file; the draft stays."""
        if self._file is not None:
            self._file.close()
            self._file = None


def _lock(file: BinaryIO) -> None:
    """Lock a draft, until it is closed. Raises OSError if another console writes to it."""
    if not lock(file.fileno()):
        raise OSError(EBUSY, "another console edits this floor")
