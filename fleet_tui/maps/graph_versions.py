"""Graphs that robots had before others were sent to them: the last versions, as files."""

from datetime import UTC, datetime
from pathlib import Path
from urllib.parse import quote

from fleet_tui.storage.whole_file import write_whole

KEPT = 20
"""Versions of one floor of one robot."""


def keep_version(folder: Path, robot: str, floor: str, text: str) -> Path:
    """Write a robot's graph of a floor to a file in `graphs`, drop the oldest, and return its path; the same
    graph again is not written again. The time in its name is UTC. Raises OSError."""
    # Names of robots and floors have no dash: no pair of them is mistaken for another.
    stem = f"{quote(robot, safe='')}-{quote(floor, safe='')}-"
    graphs = folder / "graphs"
    graphs.mkdir(parents=True, exist_ok=True, mode=0o700)
    older = sorted(graphs.glob(f"{stem}[0-9]*.yaml"))
    if older and older[-1].read_text() == text:
        return older[-1]
    path = graphs / f"{stem}{datetime.now(UTC):%Y%m%dT%H%M%S.%fZ}.yaml"
    write_whole(path, text.encode())
    # Only those before it: a clock that was put back must not cost the new one.
    for version in older[: -(KEPT - 1)]:
        version.unlink(missing_ok=True)
    return path
