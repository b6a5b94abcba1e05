"""The file of the audit log: its name and its sizes."""

from pathlib import Path

from fleet_tui.storage.line_file import LineFile

FILE_NAME = "audit.jsonl"
MAX_BYTES = 10 * 2**20
KEPT = 5
"""The number of files including the current one."""


def audit_file(path: Path, max_bytes: int = MAX_BYTES) -> LineFile:
    """Return the log of this name, to be written."""
    return LineFile(path, max_bytes, KEPT)
