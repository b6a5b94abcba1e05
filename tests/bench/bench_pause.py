"""P13: `fleet-tui pause --all`, from the start of the process to the last call on the wire.

Run: python -m tests.bench.bench_pause
"""

import asyncio
import statistics
import sys
import tempfile
import time
from pathlib import Path

from fleet_tui.simulator.calls import Call
from fleet_tui.simulator.frames import Frame
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.bench.rows import Row, row
from tests.support.cli import config_file, started

STARTS = 9
IMPORT = "import roslibpy, roslibpy.comm.comm_asyncio"
RATIO = 2.0


async def importing() -> float:
    """Seconds that an interpreter takes that only imports roslibpy with its asyncio transport."""
    begun = time.monotonic()
    process = await asyncio.create_subprocess_exec(sys.executable, "-c", IMPORT)
    await process.wait()
    return time.monotonic() - begun


async def pausing(robots: int, folder: Path) -> float:
    """Seconds until the last robot's service was called."""
    server = RosbridgeServer(OhFleet(robots=robots, floors=2, seed=1, quiet=True))
    called: list[float] = []

    def deliver(call: Call, frame: Frame) -> None:
        called.append(time.monotonic())
        call.reply(frame)

    for robot in server.world.robots:
        server.bridge.services.deliveries[f"/{robot}/Application_layout/Pause"] = deliver
    await server.start()
    config_file(folder, server.url, robots, 2)
    begun = time.monotonic()
    process = await started(folder, "pause", "--all")
    await process.communicate()
    await server.stop()
    if process.returncode or len(called) != robots:
        raise AssertionError(f"{len(called)} of {robots} were paused, exit code {process.returncode}")
    return called[-1] - begun


async def measure() -> list[Row]:
    with tempfile.TemporaryDirectory() as name:
        imports, few, many = [], [], []
        for _ in range(STARTS):
            imports.append(await importing())
            few.append(await pausing(3, Path(name)))
            many.append(await pausing(100, Path(name)))
    least = statistics.median(imports)
    against = "import roslibpy and its asyncio transport"
    what = "pause --all: start -> last call on the wire"
    rows = [
        row(
            "P13",
            f"{what}, {robots} robots",
            statistics.median(taken) * 1000,
            "ms",
            None,
            least * 1000,
            against,
        )
        for robots, taken in ((3, few), (100, many))
    ]
    ratio = statistics.median(few) / least
    return [*rows, row("P13", f"{what}, 3 robots, times that import", ratio, "x", RATIO)]


def main() -> list[Row]:
    return asyncio.run(measure())


if __name__ == "__main__":
    main()
