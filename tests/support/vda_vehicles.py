"""Vehicles that share no code with the console: of vda5050-sdk (PyPI) and of vda-5050-lib (npm)."""

import asyncio
import fcntl
import shutil
import subprocess
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest

from tests.support.broker import RealBroker

LIBRARY = "vda-5050-lib@1.4.0"
FOLDER = Path(__file__).parents[2] / ".venv" / "vehicles"
PROGRAM = """
const vda = require("vda-5050-lib");
const [url, version, serial, x, tolerance, charging] = process.argv.slice(2);
const vehicle = new vda.AgvController(
  { manufacturer: "KIT", serialNumber: serial },
  { interfaceName: "uagv", transport: { brokerUrl: url }, vdaVersion: version },
  { agvAdapterType: vda.VirtualAgvAdapter, publishStateInterval: 1000, publishVisualizationInterval: 200 },
  {
    initialPosition: { x: Number(x), y: 0, theta: 0, mapId: "hall", lastNodeId: "n0" },
    agvNormalDeviationXyTolerance: Number(tolerance),
    initialBatteryCharge: 50,
    vehicleSpeed: 2,
  },
);
vehicle.start().then(() => {
  if (charging === "true") vehicle.updateBatteryState({ batteryCharge: 50, charging: true }, true);
});
"""


def library() -> Path:
    """The folder of the npm library, installed once; skips where that can't be."""
    if not (shutil.which("node") and shutil.which("npm")):
        pytest.skip("node and npm are not installed")
    FOLDER.mkdir(parents=True, exist_ok=True)
    with (FOLDER / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (FOLDER / "node_modules" / "vda-5050-lib").is_dir():
            (FOLDER / "package.json").write_text("{}")
            command = ["npm", "install", "--no-audit", "--no-fund", LIBRARY]
            try:
                subprocess.run(command, cwd=FOLDER, check=True, capture_output=True, timeout=45)
            except (subprocess.SubprocessError, OSError):
                pytest.skip(f"npm can't install {LIBRARY}")
        written = FOLDER / "vehicle.new"
        written.write_text(PROGRAM)
        written.replace(FOLDER / "vehicle.js")  # whole: a vehicle of another run may be reading it
    return FOLDER


@asynccontextmanager
async def npm_vehicle(
    broker: RealBroker,
    version: str,
    serial: str = "0001",
    x: float = 0.0,
    tolerance: float = 0.5,
    charging: bool = False,
) -> AsyncIterator[None]:
    """A vehicle of vda-5050-lib at (x, 0), which drives 2 m/s, and takes orders that begin within so many
    metres; it is killed, so that its last will comes."""
    options = [version, serial, str(x), str(tolerance), str(charging).lower()]
    command = ["node", "vehicle.js", broker.url, *options]
    process = await asyncio.create_subprocess_exec(*command, cwd=await asyncio.to_thread(library))
    try:
        yield
    finally:
        process.kill()
        await process.wait()


@asynccontextmanager
async def sdk_vehicle(broker: RealBroker, *, x: float = 0.0, map_known: str = "hall") -> AsyncIterator[None]:
    """A vehicle of vda5050-sdk at (x, 0), which jumps from node to node, and has one map."""
    pytest.importorskip("aiomqtt")
    agv = pytest.importorskip("vda5050.client.agv")
    config = pytest.importorskip("vda5050.config")
    model = pytest.importorskip("vda5050.model")
    settings = config.VehicleConfig(
        broker_url=broker.url, manufacturer="KIT", serial_number="0001", state_interval=1.0
    )
    async with agv.VehicleClient(settings) as client:
        client.update_position(x=x, y=0.0, theta=0.0, map_id="hall")
        status = model.MapStatus.ENABLED
        client.publisher.set_maps([model.Map(map_id=map_known, map_version="1", map_status=status)])
        driven = set[asyncio.Task[object]]()

        @client.on_order  # type: ignore[untyped-decorator]  # of a library that may be missing
        def drive(order: object) -> None:
            executor = agv.OrderExecutor(client.publisher, node_delay=0.5)
            driven.add(asyncio.ensure_future(executor.run(order)))

        await client.publish_state()
        yield
        for task in driven:
            task.cancel()
