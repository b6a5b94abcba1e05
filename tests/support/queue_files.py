"""The file of orders that wait."""

from pathlib import Path

import msgspec

from fleet_tui.links.queue_file import FILE, WaitingOrder


def kept(folder: Path) -> list[WaitingOrder]:
    path = folder / FILE
    return msgspec.json.decode(path.read_bytes(), type=list[WaitingOrder]) if path.exists() else []
