"""A console that is killed as soon as its command reaches the robot: the audit log has the command."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.simulator.ros.errors import NodeDiedError
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import config_file, run_alone
from tests.support.fault_report import report
from tests.support.warm_cli import STARVED

KILLS = int(os.environ.get("FLEET_TUI_KILLS", "20"))
"""`make kills` has 500."""
ORDER = "/robot_0/Application_layout/Execute_order"
BUSY = "while True: pass"
OTHERS = 2
"""Busy processes that share one processor with the console."""


@pytest.fixture
def processor() -> Iterator[int]:
    """A processor that others keep busy."""
    number = min(os.sched_getaffinity(0))
    busy = [subprocess.Popen([sys.executable, "-c", BUSY]) for _ in range(OTHERS)]
    try:
        for process in busy:
            os.sched_setaffinity(process.pid, {number})
        yield number
    finally:
        for process in busy:
            process.kill()
            process.wait()


@pytest.mark.timeout(240 + 5 * KILLS)
async def test_killed_while_its_command_arrives(
    server: RosbridgeServer, tmp_path: Path, processor: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its line was written before, on a machine that is busy with other things."""
    monkeypatch.setenv(STARVED, "fleet-tui-audit")
    config_file(tmp_path, server.url, 1)
    pid, asked = 0, list[int]()

    def starve(started: int) -> None:
        nonlocal pid
        pid = started
        with suppress(ProcessLookupError):
            os.sched_setaffinity(pid, {processor})

    def kill(args: dict[str, Any]) -> dict[str, Any]:
        asked.append(args["request_id"])
        os.kill(pid, signal.SIGKILL)
        raise NodeDiedError

    server.bridge.services.answers[ORDER] = kill
    for number in range(KILLS):
        ended = await run_alone(tmp_path, "order", "robot_0", "Base", "Consumidores", on_start=starve)
        assert ended.code == -signal.SIGKILL, ended
        assert len(asked) == number + 1
    records = list(AuditReader(tmp_path / "fleet-tui" / "audit.jsonl").newest_first())
    written = {record.id for record in records if record.change == "checked"}
    assert [request for request in asked if request not in written] == []
    seen = f"{KILLS} of {KILLS} commands are in the audit log"
    made_by = f"SIGKILL as the call arrives; {OTHERS} busy processes on its processor, its log's thread last"
    report("killed during a command", made_by, seen, None, None)
