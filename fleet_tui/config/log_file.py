"""The log file. No output may reach stderr while the screen is open: it would garble it."""

import atexit
import logging
import logging.handlers
import os
import queue
from collections import deque
from copy import copy
from pathlib import Path
from typing import Any

import platformdirs

from fleet_tui.config.access import hidden
from fleet_tui.config.trust import doubt
from fleet_tui.storage.line_file import LineFile
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

MAX_BYTES = 2 * 2**20
KEPT = 4
"""The number of files including the current one."""
TAIL_LINES = 500
"""Number of lines that are kept in memory, too."""
LONGEST_LINE = 4000
"""Maximum characters of a message."""
NOWHERE = Path("/dev/null/fleet-tui")
WAITING = 10_000
"""Messages that wait for a hanging disk; more are dropped, and counted."""


class _Visible(logging.Formatter):
    """A formatter that keeps a robot's control characters from the terminal that shows the log."""

    def formatMessage(self, record: logging.LogRecord) -> str:  # noqa: N802  # the base's name
        """Return one line, with any content."""
        return truncate(sanitize(_hidden(super().formatMessage(record))), LONGEST_LINE)

    def formatException(self, ei: Any) -> str:  # noqa: N802  # the base's name
        """Return a sanitized traceback: its last words may be from anywhere."""
        return "\n".join(map(sanitize, _hidden(super().formatException(ei)).split("\n")))


def _hidden(text: str) -> str:
    """Return a text without secrets: libraries log what a server says, which may repeat one."""
    return hidden(text.encode(errors="surrogatepass")).decode(errors="surrogatepass")


class Tail(logging.Handler):
    """The newest lines, for the diagnostics screen, also if no file can be written."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: deque[str] = deque(maxlen=TAIL_LINES)

    def emit(self, record: logging.LogRecord) -> None:
        """Keep a line; a traceback is in the file."""
        record = copy(record)
        record.exc_info = record.exc_text = record.stack_info = None
        self.lines.append(self.format(record))


TAIL = Tail()


class _LogFile(logging.Handler):
    """Appends each message to a file that other consoles write to as well."""

    def __init__(self, file: LineFile) -> None:
        super().__init__()
        self._file = file

    def emit(self, record: logging.LogRecord) -> None:
        """Write it; a full disk costs the line, and the next one recovers."""
        try:
            self._file.append(f"{self.format(record)}\n".encode(errors="backslashreplace"))
        except Exception:  # noqa: BLE001  # as logging's own handlers do: the thread must not end by it
            self.handleError(record)


class _LogQueue(logging.handlers.QueueHandler):
    """Messages queued for the file; the number of dropped ones is logged as soon as there is space again."""

    lost = 0

    def enqueue(self, record: logging.LogRecord) -> None:
        """Queue it, if possible. Under the handler's lock."""
        try:
            if self.lost:
                message = f"{self.lost} messages before this one lost: disk not responding"
                about = {"name": __name__, "levelno": logging.WARNING, "levelname": "WARNING", "msg": message}
                super().enqueue(self.prepare(logging.makeLogRecord(about)))
                self.lost = 0
            super().enqueue(record)
        except queue.Full:
            self.lost += 1


class _Writing(logging.handlers.QueueListener):
    """Writes them, on its own thread."""

    def enqueue_sentinel(self) -> None:
        """Queue the end when there is space; the process exits in time without it."""
        self.queue.put(self._sentinel)  # type: ignore[attr-defined]  # public, and its documented use


def state_folder() -> Path:
    """Return the folder of logs and records: $XDG_STATE_HOME/fleet-tui, else ~/.local/state/fleet-tui; or one
    that can't be made, where somebody else could lay links into it."""
    return NOWHERE if state_problem() else platformdirs.user_state_path("fleet-tui")


def state_problem() -> str:
    """Return why nothing is kept in the folder of this user, with the remedy; empty if it is one's own."""
    folder = platformdirs.user_state_path("fleet-tui")
    places = (folder, *folder.parents)
    found = doubt(next(one for one in places if os.path.isdir(one)))  # noqa: PTH112  # that of Path raises
    return f"nothing is kept, no log, no audit log: {found}" if found else ""


def log_to_file(debug: bool) -> Path | None:
    """Send logging and warnings to the log file, or nowhere if there can be none."""
    logging.captureWarnings(True)
    # A full disk costs the line. A message on stderr would cost the screen.
    logging.raiseExceptions = False
    root = logging.getLogger()
    root.setLevel(logging.DEBUG if debug else logging.INFO)
    path = state_folder() / "fleet-tui.log"
    TAIL.setFormatter(_Visible("%(asctime)s %(levelname)s %(name)s: %(message)s", "%H:%M:%S"))
    file = LineFile(path, MAX_BYTES, KEPT)
    try:
        file.append(b"")
    except OSError:
        root.handlers = [TAIL]
        return None
    # A disk may hang, but must not block the screen or the network: a separate thread writes.
    lines: queue.Queue[logging.LogRecord] = queue.Queue(WAITING)
    handler = _LogQueue(lines)
    handler.setFormatter(_Visible(f"%(asctime)s {os.getpid()} %(levelname)s %(name)s: %(message)s"))
    root.handlers = [handler, TAIL]
    listener = _Writing(lines, _LogFile(file))
    listener.start()
    atexit.register(listener.stop)
    for chatty in ("asyncio", "roslibpy", "autobahn", "markdown_it", "PIL"):
        logging.getLogger(chatty).setLevel(logging.DEBUG if debug else logging.WARNING)
    return path
