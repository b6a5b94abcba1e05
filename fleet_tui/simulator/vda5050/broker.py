"""A broker for simulated vehicles: mosquitto where it is installed, else amqtt, which PyPI has."""

import asyncio
import shutil
import socket
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

NO_BROKER = Message("no broker for the vehicles: apt install mosquitto, or pip install 'fleet-tui[broker]'")
STARTS_WITHIN = 10.0
_PLACES = "/usr/sbin:/usr/local/sbin:/usr/bin:/usr/local/bin:/opt/homebrew/sbin"


def free_port() -> int:
    """Return a port of loopback that is free now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


def _mosquitto_program() -> str | None:
    return shutil.which("mosquitto") or shutil.which("mosquitto", path=_PLACES)


def has_broker() -> bool:
    """Tell whether a broker is installed."""
    return _mosquitto_program() is not None or find_spec("amqtt") is not None


@asynccontextmanager
async def broker(port: int) -> AsyncIterator[None]:
    """Serve MQTT on a port of loopback. Raises FleetError."""
    program = _mosquitto_program()
    if program is not None:
        async with _mosquitto(program, port):
            yield
    elif find_spec("amqtt") is not None:
        async with _amqtt(port):
            yield
    else:
        raise FleetError(NO_BROKER)


@asynccontextmanager
async def _mosquitto(program: str, port: int) -> AsyncIterator[None]:
    with TemporaryDirectory(prefix="fleet-tui-") as folder:
        file = Path(folder) / "mosquitto.conf"
        file.write_text(f"listener {port} 127.0.0.1\nallow_anonymous true\nuser root\n")
        nothing = asyncio.subprocess.DEVNULL
        process = await asyncio.create_subprocess_exec(program, "-c", file, stdout=nothing, stderr=nothing)
        try:
            await _listening(port, process)
            yield
        finally:
            with suppress(ProcessLookupError):
                process.terminate()
            await process.wait()


async def _listening(port: int, process: asyncio.subprocess.Process) -> None:
    """Wait until it accepts connections. Raises FleetError."""
    try:
        async with asyncio.timeout(STARTS_WITHIN):
            while process.returncode is None:
                with suppress(OSError):
                    _, writer = await asyncio.open_connection("127.0.0.1", port)
                    writer.close()
                    return
                await asyncio.sleep(0.02)
    except TimeoutError:
        pass
    raise FleetError(Message("mosquitto did not start on port {port}: choose another --port", port=port))


@asynccontextmanager
async def _amqtt(port: int) -> AsyncIterator[None]:
    settings = {
        "listeners": {"default": {"type": "tcp", "bind": f"127.0.0.1:{port}"}},
        "plugins": {"amqtt.plugins.authentication.AnonymousAuthPlugin": {"allow_anonymous": True}},
    }
    served = import_module("amqtt.broker").Broker(settings)
    await served.start()
    try:
        yield
    finally:
        await served.shutdown()
