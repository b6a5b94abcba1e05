"""Writes files so that they are whole at any time."""

import os
import shutil
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from fleet_tui.storage.handles import share

BACKUP = ".bak"


@contextmanager
def replacing(path: Path, is_synced: bool = True) -> Iterator[BinaryIO]:
    """Provide a file, of mode 600, that takes the place of `path` when the block ends without an error: on
    disk by then, if `is_synced`. What has that name is replaced, not written to: a link there may be somebody
    else's. Raises OSError."""
    number, name = tempfile.mkstemp(dir=path.parent, prefix=".fleet-tui-")
    made = Path(name)
    try:
        with os.fdopen(number, "wb") as file:
            yield file
            file.flush()
            if is_synced:
                os.fsync(number)
        made.replace(path)
    except BaseException:
        with suppress(OSError):
            made.unlink()
        raise


def write_whole(path: Path, content: bytes, keep: bool = False, is_shared: bool = False) -> Path | None:
    """Write a file whole or not at all, on disk when this returns. With `keep` the file before stays as
    `.bak`, whose path is returned.

    For its owner alone, unless `is_shared`: then with the mode of the file before, else the usual one. Raises
    OSError.
    """
    exists = path.exists()
    kept = None
    with replacing(path) as file:
        file.write(content)
        if is_shared:
            os.fchmod(file.fileno(), stat.S_IMODE(path.stat().st_mode) if exists else 0o666 & ~_umask())
        if keep and exists:
            kept = path.with_name(path.name + BACKUP)
            _copy(path, kept)
    return kept


def _copy(path: Path, to: Path) -> None:
    with path.open("rb") as before, replacing(to, is_synced=False) as copy:
        shutil.copyfileobj(before, copy)
        copy.flush()
        status = os.fstat(before.fileno())
        os.fchmod(copy.fileno(), stat.S_IMODE(status.st_mode))
        os.utime(copy.fileno(), ns=(status.st_atime_ns, status.st_mtime_ns))


def replace_shared(path: Path, content: bytes) -> None:
    """Replace a file that several users write: readers see the old one or the new one. Raises OSError."""
    with replacing(path, is_synced=False) as file:
        share(file.fileno(), path.parent)
        file.write(content)


def _umask() -> int:
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
