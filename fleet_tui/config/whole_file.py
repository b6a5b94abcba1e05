"""Writes files so that they are whole at any time."""

import os
import shutil
import tempfile
from contextlib import suppress
from pathlib import Path

BACKUP = ".bak"


def write_whole(path: Path, content: bytes, keep: bool = False, is_shared: bool = False) -> Path | None:
    """Write a file whole or not at all, on disk when this returns. With `keep` the file before stays as
    `.bak`, whose path is returned.

    For its owner alone, unless `is_shared`: then with the mode of the file before, else the usual one. Raises
    OSError.
    """
    number, name = tempfile.mkstemp(dir=path.parent, prefix=".fleet-tui-")  # mode 600
    made, kept = Path(name), None
    try:
        with os.fdopen(number, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        exists = path.exists()
        if is_shared and exists:
            shutil.copymode(path, made)
        elif is_shared:
            made.chmod(0o666 & ~_umask())
        if keep and exists:
            kept = _copied(path)
        made.replace(path)
    except OSError:
        with suppress(OSError):
            made.unlink()
        raise
    return kept


def _copied(path: Path) -> Path:
    """Copy a file beside it. What has the copy's name is replaced: a link there may be somebody else's."""
    number, name = tempfile.mkstemp(dir=path.parent, prefix=".fleet-tui-")
    os.close(number)
    made, kept = Path(name), path.with_name(path.name + BACKUP)
    try:
        shutil.copy2(path, made)
        made.replace(kept)
    except OSError:
        with suppress(OSError):
            made.unlink()
        raise
    return kept


def _umask() -> int:
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
