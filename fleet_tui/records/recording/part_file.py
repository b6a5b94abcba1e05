"""One file of a recording being written: gzip, of which a kill costs at most the unflushed end."""

import os
import zlib
from pathlib import Path

LEVEL = 1
"""Compression level: higher ones take several times as long, and save a fifth."""


class PartFile:
    """A new file of mode 600. Every method raises OSError if the disk fails."""

    def __init__(self, path: Path, head: bytes) -> None:
        """Create the file, which must not exist yet, with its first lines."""
        path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        # Never through a link placed there.
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
        self._fd = os.open(path, flags, 0o600)
        self.path = path
        self.size = 0
        self._packer = zlib.compressobj(LEVEL, wbits=31)
        self._is_flushed = True
        try:
            self.write(head)
            self.flush()
        except OSError:
            path.unlink(missing_ok=True)
            self.close()
            raise

    def write(self, lines: bytes) -> None:
        """Add lines; they are on the disk after the next flush."""
        self._is_flushed = False
        self._put(self._packer.compress(lines))

    def flush(self) -> None:
        """Make everything so far readable."""
        if not self._is_flushed:
            self._put(self._packer.flush(zlib.Z_SYNC_FLUSH))
            self._is_flushed = True

    def begin_member(self) -> None:
        """Start a new gzip member, so that readers can seek here."""
        self._put(self._packer.flush())
        self._packer = zlib.compressobj(LEVEL, wbits=31)
        self._is_flushed = True

    def is_there(self) -> bool:
        """Tell whether the file still has its name: else its content would never be found."""
        try:
            return os.path.samestat(os.fstat(self._fd), self.path.stat(follow_symlinks=False))
        except OSError:
            return False

    def end(self) -> None:
        """End the gzip file properly."""
        self._put(self._packer.flush())

    def close(self) -> None:
        """Close the file: it can be read as far as it was written whole."""
        os.close(self._fd)

    def _put(self, packed: bytes) -> None:
        while packed:
            done = os.write(self._fd, packed)
            self.size += done
            packed = packed[done:]
