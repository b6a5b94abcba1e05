"""The file of orders that wait."""

from pathlib import Path

import msgspec

from fleet_tui.client.queue_file import FILE, Kept


def kept(folder: Path) -> list[Kept]:
    path = folder / FILE
    return msgspec.json.decode(path.read_bytes(), type=list[Kept]) if path.exists() else []
