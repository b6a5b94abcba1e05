"""The simulator, which in the end writes how many messages of topics it sent.

Arguments: the file for that, and those of `fleet-tui sim`.
"""

import sys
from pathlib import Path

from websockets.asyncio.server import ServerConnection

from fleet_tui.__main__ import main as fleet_tui

sent = 0


def count() -> None:
    send = ServerConnection.send

    async def counted(self: ServerConnection, frame: str | bytes) -> None:
        global sent
        await send(self, frame)
        sent += ("publish" in frame[:40]) if isinstance(frame, str) else (b"publish" in frame[:40])

    ServerConnection.send = counted  # type: ignore[method-assign,assignment]  # only whole frames are sent here


def main() -> None:
    path, *arguments = sys.argv[1:]
    sys.argv = ["fleet-tui", "sim", *arguments]
    count()
    try:
        fleet_tui()
    finally:
        Path(path).write_text(str(sent))


if __name__ == "__main__":
    main()
