"""`fleet-tui history --collect`: a service that writes what it sees, and sends nothing."""

import asyncio
import signal
from pathlib import Path

import pytest

from fleet_tui.config.load import load
from fleet_tui.records.history.database import history_path, is_empty, opened_to_read
from fleet_tui.records.history.reading import History
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import run, started
from tests.support.polling import eventually


@pytest.mark.nightly
async def test_it_writes_until_it_is_told_to_end(server: RosbridgeServer, folder: Path) -> None:
    service = await started(folder, "history", "--collect")
    assert service.stdout is not None and service.stderr is not None
    path = history_path(folder / "fleet-tui", load(folder / "config.toml"))
    first = (await service.stdout.readline()).decode()
    assert first == f"collecting the history in {path}\n"
    while (await service.stdout.readline()).decode() != f"{server.url}: connected\n":
        pass  # "no link" comes before it, unless the first look is late

    def is_written() -> bool:
        if not path.exists():
            return False
        with opened_to_read(path) as database:
            history = History(database)
            return (
                not is_empty(database)
                and bool(history.links(0.0, 1e12))
                and len(history.robots(0.0, 1e12)) == 2
            )

    await asyncio.to_thread(eventually, is_written)
    service.send_signal(signal.SIGTERM)
    assert await service.wait() == 0
    assert await service.stderr.read() == b"" and server.bridge.services.calls == []
    assert path.stat().st_mode & 0o777 == 0o600
    assert "rosbridge link: up" in (await run(folder, "history")).out


async def test_none_is_collected_that_is_switched_off(server: RosbridgeServer, folder: Path) -> None:
    config = folder / "config.toml"
    config.write_text(f"[history]\ndays = 0\n{config.read_text()}")
    done = await run(folder, "history", "--collect")
    assert done.code == 2 and "history.days is 0: no history is kept" in done.err
