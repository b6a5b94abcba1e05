"""The log file. Nothing may reach stderr while the screen is open: it would tear it."""

import logging
import logging.handlers
import os
from pathlib import Path
from typing import Any

import platformdirs

from fleet_tui.model.bounds import brief
from fleet_tui.view.text import visible

MAX_BYTES, KEPT = 2 * 2**20, 3
"""A file's size, and how many older ones are kept beside it."""
LONGEST_LINE = 4000
"""Characters of a message."""


class _Visible(logging.Formatter):
    """Who reads the log in a terminal must not be told what a robot has to say to that terminal."""

    def formatMessage(self, record: logging.LogRecord) -> str:  # noqa: N802  # the base's name
        """One line, whatever is in it."""
        return brief(visible(super().formatMessage(record)), LONGEST_LINE)

    def formatException(self, ei: Any) -> str:  # noqa: N802  # the base's name
        """A traceback ends with words that may come from anywhere."""
        return "\n".join(map(visible, super().formatException(ei).split("\n")))


class _Private(logging.handlers.RotatingFileHandler):
    """A rotating log that only its owner reads."""

    def _open(self):  # type: ignore[no-untyped-def]  # the base's own type is not public
        stream = super()._open()
        Path(self.baseFilename).chmod(0o600)
        return stream


def state_folder() -> Path:
    """Where logs and records lie: $XDG_STATE_HOME/fleet-tui, else ~/.local/state/fleet-tui."""
    return platformdirs.user_state_path("fleet-tui")


def log_to_file(debug: bool) -> Path | None:
    """Send logging and warnings to the log file, or nowhere if there can be none."""
    logging.captureWarnings(True)
    logging.raiseExceptions = False  # a line that can't be written must not go to stderr instead
    # A full disk costs the line. Said on stderr it would cost the screen.
    logging.raiseExceptions = False
    root = logging.getLogger()
    root.setLevel(logging.DEBUG if debug else logging.INFO)
    path = state_folder() / "fleet-tui.log"
    handler: logging.Handler
    try:
        path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        handler = _Private(path, maxBytes=MAX_BYTES, backupCount=KEPT, encoding="utf-8")
    except OSError:
        root.handlers = [logging.NullHandler()]
        return None
    handler.setFormatter(_Visible(f"%(asctime)s {os.getpid()} %(levelname)s %(name)s: %(message)s"))
    root.handlers = [handler]
    for chatty in ("asyncio", "roslibpy", "autobahn", "markdown_it", "PIL"):
        logging.getLogger(chatty).setLevel(logging.DEBUG if debug else logging.WARNING)
    return path
