"""`fleet-tui metrics`: what a Prometheus would read, from a process of its own."""

import asyncio
import signal
import urllib.request
from pathlib import Path

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import run, started
from tests.support.polling import eventually


def read(address: str) -> str:
    with urllib.request.urlopen(address, timeout=10) as answer:
        return str(answer.read().decode())


async def answers(address: str, part: str) -> str:
    """Return the first answer with a text in it."""
    text = ""

    def has_it() -> bool:
        nonlocal text
        text = read(address)
        return part in text

    await asyncio.to_thread(eventually, has_it)
    return text


async def test_it_answers_until_it_is_told_to_end(server: RosbridgeServer, folder: Path) -> None:
    service = await started(folder, "metrics", "--port", "0")
    assert service.stdout is not None and service.stderr is not None
    told = (await service.stdout.readline()).decode().split()
    address = told[-1]
    assert told[:-1] == ["metrics", "for", "Prometheus", "at"] and address.startswith("http://127.0.0.1:")
    text = await answers(address, 'link="rosbridge",robot="robot_1"} 1.0')
    assert 'fleet_link_up{link="rosbridge"} 1.0' in text
    assert (await run(folder, "order", "robot_0", "1", "2")).code == 0
    await answers(address, 'fleet_commands_total{command="order",stage="confirmed"} 1.0')
    await server.stop()
    await answers(address, 'fleet_link_up{link="rosbridge"} 0.0')
    service.send_signal(signal.SIGTERM)
    assert await service.wait() == 0
    assert await service.stderr.read() == b""


async def test_a_port_that_is_taken_is_named(server: RosbridgeServer, folder: Path) -> None:
    port = server.url.rpartition(":")[2]
    done = await run(folder, "metrics", "--port", port)
    assert done.code == 1 and f"127.0.0.1:{port}: Address already in use: choose another --port" in done.err
