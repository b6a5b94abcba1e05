"""The log file. No output may reach stderr while the screen is open: it would garble it."""

import atexit
import logging
import logging.handlers
import os
import queue
from collections import deque
from contextlib import suppress
from copy import copy
from pathlib import Path
from typing import IO, Any

import platformdirs

from fleet_tui.config.access import hidden
from fleet_tui.config.trust import doubt
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

MAX_BYTES, KEPT = 2 * 2**20, 3
"""A file's maximum size, and the number of older ones."""
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


def _is_named(stream: IO[str], path: Path) -> bool:
    """Tell whether the open file is the one of this name."""
    try:
        return os.path.samestat(os.fstat(stream.fileno()), path.stat())
    except FileNotFoundError:
        return False


class _Private(logging.handlers.RotatingFileHandler):
    """A rotating log of mode 600."""

    def _open(self):  # type: ignore[no-untyped-def]  # the base's own type is not public
        path = Path(self.baseFilename)
        if not path.exists():
            path.touch(0o600)  # at no moment readable by others
        stream = super()._open()
        path.chmod(0o600)
        return stream

    def emit(self, record: logging.LogRecord) -> None:
        """Write it to the file that has the name now: the folder may have been cleared, or another console
        may have rotated the file."""
        path = Path(self.baseFilename)
        with suppress(OSError):  # else this line is lost, and the next one recovers
            if self.stream is not None and not _is_named(self.stream, path):
                self.stream.close()
                self.stream = None
                path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        super().emit(record)


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
    try:
        path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        if path.exists() and not path.is_file():
            raise FileExistsError(path)  # opening a pipe would block until it has a reader
        file = _Private(path, maxBytes=MAX_BYTES, backupCount=KEPT, encoding="utf-8")
    except OSError:
        root.handlers = [TAIL]
        return None
    # A disk may hang, but must not block the screen or the network: a separate thread writes.
    lines: queue.Queue[logging.LogRecord] = queue.Queue(WAITING)
    handler = _LogQueue(lines)
    handler.setFormatter(_Visible(f"%(asctime)s {os.getpid()} %(levelname)s %(name)s: %(message)s"))
    root.handlers = [handler, TAIL]
    listener = _Writing(lines, file)
    listener.start()
    atexit.register(listener.stop)
    for chatty in ("asyncio", "roslibpy", "autobahn", "markdown_it", "PIL"):
        logging.getLogger(chatty).setLevel(logging.DEBUG if debug else logging.WARNING)
    return path
