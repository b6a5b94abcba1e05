"""P14: `fleet-tui status`, from the start of its process to its first words on the wire, and to its end.

Run: python -m tests.bench.bench_status
"""

import asyncio
import statistics
import tempfile
import time
from pathlib import Path

from fleet_tui.simulator.calls import Call
from fleet_tui.simulator.frames import Frame
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.bench.bench_pause import importing
from tests.bench.rows import Row, row
from tests.support.cli import config_file, started

STARTS = 9
ROBOTS = 3
RATIO = 2.0


async def asking(folder: Path) -> tuple[float, float]:
    """Seconds until it asked its first question, and until it had answered ours."""
    server = RosbridgeServer(OhFleet(robots=ROBOTS, floors=2, seed=1, quiet=True))
    asked: list[float] = []

    def deliver(call: Call, frame: Frame) -> None:
        asked.append(time.monotonic())
        call.reply(frame)

    server.bridge.services.deliveries["/rosapi/topics"] = deliver
    await server.start()
    config_file(folder, server.url, ROBOTS, 2)
    begun = time.monotonic()
    process = await started(folder, "status")
    await process.communicate()
    ended = time.monotonic()
    await server.stop()
    if process.returncode:
        raise AssertionError(f"exit code {process.returncode}")
    return asked[0] - begun, ended - begun


async def measure() -> list[Row]:
    imports, first, whole = [], [], []
    with tempfile.TemporaryDirectory() as name:
        for _ in range(STARTS):
            imports.append(await importing())
            words, end = await asking(Path(name))
            first.append(words)
            whole.append(end)
    least = statistics.median(imports)
    against = "import roslibpy and its asyncio transport"
    what = f"status, {ROBOTS} robots: start ->"
    named = {"first words on the wire": statistics.median(first), "end": statistics.median(whole)}
    rows = [
        row("P14", f"{what} {to}", taken * 1000, "ms", None, least * 1000, against)
        for to, taken in named.items()
    ]
    ratio = named["first words on the wire"] / least
    return [*rows, row("P14", f"{what} first words on the wire, times that import", ratio, "x", RATIO)]


def main() -> list[Row]:
    return asyncio.run(measure())


if __name__ == "__main__":
    main()
