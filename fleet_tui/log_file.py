"""The log file. Nothing may reach stderr while the screen is open: it would tear it."""

import logging
import logging.handlers
import os
from pathlib import Path

import platformdirs

MAX_BYTES, KEPT = 2 * 2**20, 3


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
    handler.setFormatter(logging.Formatter(f"%(asctime)s {os.getpid()} %(levelname)s %(name)s: %(message)s"))
    root.handlers = [handler]
    for chatty in ("asyncio", "roslibpy", "autobahn", "markdown_it", "PIL"):
        logging.getLogger(chatty).setLevel(logging.DEBUG if debug else logging.WARNING)
    return path
