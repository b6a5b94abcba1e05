"""Unpack the program once into a folder of the user, as a virtual environment, and become it.

A virtual environment, and no path in a variable: whatever the console starts, such as the programs of a
site, must not import what is packed here.
"""

import fcntl
import os
import platform
import shutil
import sys
import tempfile
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

CHOSEN = "SHIV_ROOT"
"""Environment variable with the folder to unpack to: the one that archives of shiv read."""

BASE = str(getattr(sys, "_base_executable", sys.executable))
"""The interpreter outside of any virtual environment."""


def start(name: str, machine: str) -> NoReturn:
    """Replace this process by the unpacked program. Exit code 1: it can't be unpacked, 2: another machine."""
    if platform.machine() != machine:
        _end(2, f"this file is for {machine}; this machine is {platform.machine()}: use the file for it")
    try:
        python = _unpacked(name)
    except KeyboardInterrupt:
        sys.exit(130)
    except (zipfile.BadZipFile, zlib.error, EOFError):
        _end(1, f"{sys.argv[0]} is damaged: copy it again")
    os.execv(python, [str(python), "-P", "-m", "fleet_tui", *sys.argv[1:]])


def _end(code: int, message: str) -> NoReturn:
    sys.stderr.write(f"fleet-tui: {message}\n")
    sys.exit(code)


def _unpacked(name: str) -> Path:
    """Return the interpreter of the unpacked program, in the first folder that can hold it."""
    problems = []
    for root in _roots():
        folder = root / f"{name}-{zlib.crc32(BASE.encode()):08x}"
        try:
            return _unpack(folder)
        except OSError as problem:
            problems.append(f"{folder.parent}: {problem.strerror or problem}")
    advice = f"free some space, or name another folder: {CHOSEN}=FOLDER {sys.argv[0]}"
    _end(1, "\n".join(["cannot unpack", *(f"  {problem}" for problem in problems), advice]))


def _roots() -> Iterator[Path]:
    """Return the chosen folder, or that of the user's caches and, if need be, a private temporary one."""
    if chosen := os.environ.get(CHOSEN):
        yield Path(chosen).absolute()
        return
    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path(os.environ.get("HOME", "/")) / ".cache")
    yield cache / "fleet-tui"
    yield Path(tempfile.gettempdir()) / f"fleet-tui-{os.getuid()}"


def _unpack(folder: Path) -> Path:
    """Unpack unless that was done, one process at a time; return the interpreter. Raises as `_fill`."""
    python = folder / "bin" / "python"
    folder.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
    if CHOSEN not in os.environ and folder.parent.lstat().st_uid != os.getuid():
        raise PermissionError(None, "belongs to another user")
    if python.exists():
        return python
    with folder.with_name(f"{folder.name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not python.exists():
            _fill(folder)
    return python


def _fill(folder: Path) -> None:
    """Unpack beside the folder, then rename: it is whole or absent. Raises OSError, and zipfile's errors."""
    with zipfile.ZipFile(sys.argv[0]) as archive:
        members = [one for one in archive.infolist() if one.filename.startswith("lib/")]
        megabytes = sum(one.file_size for one in members) // 10**6
        sys.stderr.write(
            f"fleet-tui: unpacking {megabytes} MB to {folder} (once; {CHOSEN} chooses another folder) ...\n"
        )
        sys.stderr.flush()
        new = folder.with_name(f"{folder.name}.new")
        shutil.rmtree(new, ignore_errors=True)
        try:
            archive.extractall(new, members)
            (new / "pyvenv.cfg").write_text(f"home = {Path(BASE).parent}\n")
            (new / "bin").mkdir()
            (new / "bin" / "python").symlink_to(BASE)
            shutil.rmtree(folder, ignore_errors=True)  # what a cleaner of caches has left
            new.rename(folder)
        except BaseException:
            shutil.rmtree(new, ignore_errors=True)
            raise
