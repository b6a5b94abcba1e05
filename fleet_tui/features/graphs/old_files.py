"""The graph files to go back to: one that no robot has loaded is none."""

from pathlib import Path

from fleet_tui.maps.graph_storage import graph_text, save_graph_file
from fleet_tui.storage.whole_file import BACKUP
from fleet_tui.text.errors import GraphError


class OldFiles:
    """Keeps the last file that a robot has loaded as `.bak`, or the file as it was found, until a robot has
    loaded another one."""

    def __init__(self) -> None:
        self._attempts: dict[Path, str] = {}
        """What was written for a robot that has not loaded it, by path."""

    def save(self, path: Path, text: str, is_sent: bool = False) -> Path | None:
        """Write a file, for a robot that loads it if `is_sent`; return the name of the old one, if there is
        one. Raises GraphError."""
        before, place = _text(path), path.resolve()
        is_attempt = before is not None and before == self._attempts.get(place)
        if before == text:
            return _backup(path) if is_attempt else None
        kept = save_graph_file(path, text, keep=not is_attempt)
        if is_sent or is_attempt:
            self._attempts[place] = text
        return _backup(path) if is_attempt else kept

    def is_kept(self, path: Path, text: str) -> bool:
        """Tell whether there is an old file once this text is written."""
        before = _text(path)
        if before is not None and before == self._attempts.get(path.resolve()):
            return _backup(path) is not None
        return path.exists() and before != text

    def loaded(self, path: Path, text: str) -> None:
        """Note that a robot has loaded a file: the next one is kept beside it."""
        if self._attempts.get(path.resolve()) == text:
            del self._attempts[path.resolve()]


def _text(path: Path) -> str | None:
    """Return the content of a file, None for a missing or unreadable one."""
    try:
        return graph_text(path)
    except GraphError:
        return None


def _backup(path: Path) -> Path | None:
    place = path.resolve()
    backup = place.with_name(place.name + BACKUP)
    return backup if backup.exists() else None
