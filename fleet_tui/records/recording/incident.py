"""An incident as one archive, for a ticket: the recording and its environment.

Missing parts are listed in it; it contains no secrets.
"""

import itertools
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time
import zipfile
from collections.abc import Callable
from contextlib import suppress
from datetime import datetime
from importlib import metadata
from itertools import takewhile
from pathlib import Path
from typing import IO

from fleet_tui import __version__
from fleet_tui.config.access import without_secrets
from fleet_tui.config.saving import as_toml
from fleet_tui.config.schema import Config
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.log import encode
from fleet_tui.records.audit.reader import AuditReader

LOG_BYTES = 2**20
"""Maximum bytes of the end of the log."""
EARLIEST = (1980, 1, 1, 0, 0, 0)
"""The earliest time in a ZIP; an unset clock may be before it."""
SPAN = 3600.0
"""Seconds of the audit log."""
RECORDING = "recording.jsonl.gz"
FOLDER = "incidents"
"""Of the state folder."""
DOCTOR = 10.0
"""Maximum seconds for a doctor."""
POLL = 0.1
GRACE = 5.0
"""Seconds between checks of the doctor, and the extra time for its end."""

README = """\
An incident of a robot fleet, packed by fleet-tui {version} on {host} at {time}.

{contents}
All files are text or gzipped text. They contain no secrets, but names of hosts, robots and operators.
"""


class Incident:
    """Collects the parts. Not on a screen's loop: it reads files and waits for a doctor."""

    def __init__(self) -> None:
        self._parts: dict[str, bytes] = {}
        self._recordings: dict[str, tuple[list[Path], int]] = {}
        self._about: list[tuple[str, str]] = []

    def add(self, name: str, about: str, made: Callable[[], bytes]) -> None:
        """Add a part. An error while it is made is recorded instead."""
        try:
            self._parts[name] = made()
        except (OSError, ValueError) as problem:
            about = f"missing: {about} ({problem})"
        self._about.append((name, about))

    def add_recording(self, name: str, files: list[Path]) -> None:
        """Add a recording of these files, oldest first: together they are one, too."""
        about = f"last minutes of a console: fleet-tui replay {name}"
        if files:
            # Of the last one only its current content: it grows, and is whole at this moment alone.
            size = 0
            with suppress(FileNotFoundError):
                last = files[-1].stat()
                size = last.st_size
                about += f" (up to {time.strftime('%F %T', time.localtime(last.st_mtime))})"
            self._recordings[name] = files, size
        else:
            about = "missing: last minutes (no console keeps them; start one with fleet-tui record FILE)"
        self._about.append((name, about))

    def _contents(self) -> str:
        width = max((len(name) for name, _ in self._about), default=0) + 2
        return "".join(f"{name:<{width}}{about}\n" for name, about in self._about)

    def write(self, folder: Path) -> Path:
        """Write the archive of mode 600, whole or not at all. Raises OSError."""
        now = time.localtime()
        message = {"version": __version__, "host": platform.node(), "time": time.strftime("%F %T %z", now)}
        made = max(now[:6], EARLIEST)
        text = README.format(contents=self._contents(), **message)
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        fd, part = tempfile.mkstemp(dir=folder, prefix=".incident-")
        try:
            with os.fdopen(fd, "wb") as file, zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
                for name, content in {"README.txt": text.encode(), **self._parts}.items():
                    archive.writestr(zipfile.ZipInfo(name, made), content, zipfile.ZIP_DEFLATED)
                for name, (files, size) in self._recordings.items():
                    with archive.open(zipfile.ZipInfo(name, made), "w") as recording:
                        _join(files, size, recording)
            path = _taken(folder, f"incident-{time.strftime('%Y%m%d-%H%M%S', now)}")
            Path(part).replace(path)
        finally:
            Path(part).unlink(missing_ok=True)
        return path


def _join(files: list[Path], last_size: int, into: IO[bytes]) -> None:
    for path in files:
        # The oldest may have been deleted meanwhile.
        with suppress(FileNotFoundError), path.open("rb") as file:
            if path == files[-1]:
                into.write(file.read(last_size))
            else:
                shutil.copyfileobj(file, into)


def pack(config: Config, folder: Path, shot: str, recent: list[Path], is_over: Callable[[], bool]) -> Path:
    """Pack a console's files: a screenshot (SVG), the files of the last minutes, and everything else. Raises
    OSError."""
    incident = Incident()
    incident.add_recording(RECORDING, recent)
    incident.add("screen.svg", "screenshot of the console", shot.encode)
    incident.add("doctor.txt", "doctor report", lambda: examined(config, DOCTOR, is_over))
    collect(incident, config, folder, time.time() - SPAN)
    return incident.write(folder / FOLDER)


def collect(incident: Incident, config: Config, folder: Path, since: float) -> None:
    """Collect everything in a state folder from Unix time `since` on, and the software versions."""
    incident.add("config.toml", "effective settings", lambda: as_toml(without_secrets(config)).encode())
    incident.add("versions.txt", "versions of the program and its dependencies", lambda: versions().encode())
    incident.add("fleet-tui.log", "end of the log", lambda: _end_of(folder / "fleet-tui.log"))
    incident.add(FILE_NAME, "commands and alarms, oldest first", lambda: _audit(folder / FILE_NAME, since))


def versions() -> str:
    """Return a line for the program, the interpreter, the system, and each package that is installed."""
    lines = [f"fleet-tui {__version__}", f"Python {sys.version}", platform.platform()]
    packages = {f"{one.name} {one.version}" for one in metadata.distributions()}
    return "\n".join([*lines, *sorted(packages, key=str.lower)]) + "\n"


def _end_of(path: Path) -> bytes:
    with path.open("rb") as file:
        file.seek(max(0, file.seek(0, os.SEEK_END) - LOG_BYTES))
        return file.read()


def _audit(path: Path, since: float) -> bytes:
    def is_recent(record: AuditRecord) -> bool:
        return datetime.fromisoformat(record.time).timestamp() >= since

    newest = takewhile(is_recent, AuditReader(path).newest_first())
    return b"".join(map(encode, reversed(list(newest))))


def examined(config: Config, within: float, is_over: Callable[[], bool]) -> bytes:
    """Return the output of `fleet-tui doctor` within a time limit, from a separate process, which is ended by
    `is_over`. Raises OSError without output."""
    with tempfile.NamedTemporaryFile("w", suffix=".toml", encoding="utf-8") as file:
        file.write(as_toml(config.whole()))
        file.flush()
        command = [
            sys.executable,
            "-P",
            "-m",
            "fleet_tui",
            "doctor",
            "--config",
            file.name,
            "--timeout",
            f"{within:g}",
        ]
        out = subprocess.PIPE
        with subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT
        ) as child:
            until = time.monotonic() + within + GRACE
            while time.monotonic() < until and not is_over():
                try:
                    found: bytes = child.communicate(timeout=POLL)[0]
                    return found
                except subprocess.TimeoutExpired:
                    continue
            child.kill()
    raise OSError("doctor did not finish")


def _taken(folder: Path, stem: str) -> Path:
    """Create an empty archive under a free name and return it: two incidents may be of the same second."""
    for number in itertools.count(1):
        path = folder / f"{stem}{f'-{number}' if number > 1 else ''}.zip"
        with suppress(FileExistsError):
            path.touch(mode=0o600, exist_ok=False)
            return path
    raise AssertionError  # numbers have no end
