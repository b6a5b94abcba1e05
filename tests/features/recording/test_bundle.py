"""`fleet-tui doctor --bundle`: what was found, packed for a ticket."""

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import config_file, run


def packed(folder: Path) -> dict[str, str]:
    (path,) = (folder / "fleet-tui" / "incidents").iterdir()
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name).decode() for name in archive.namelist()}


async def test_the_report_is_in_the_archive(server: RosbridgeServer, tmp_path: Path) -> None:
    server.bridge.muted.add("/robot_0/battery")
    config_file(tmp_path, server.url, 1)
    done = await run(tmp_path, "doctor", "--bundle")
    *found, last = done.out.splitlines()
    assert done.code == 1
    assert last.startswith("for the ticket: ") and last.endswith(".zip")
    assert packed(tmp_path)["doctor.txt"].splitlines() == found


async def test_json_stays_json(server: RosbridgeServer, tmp_path: Path) -> None:
    config_file(tmp_path, server.url, 1)
    done = await run(tmp_path, "doctor", "--bundle", "--json")
    assert json.loads(done.out)["exit_code"] == done.code == 0
    assert done.err.startswith("for the ticket: ")
    assert json.loads(packed(tmp_path)["doctor.json"]) == json.loads(done.out)


async def test_without_a_link_it_is_packed_all_the_same(tmp_path: Path) -> None:
    config_file(tmp_path, "ws://127.0.0.1:9", 1)
    done = await run(tmp_path, "doctor", "--bundle")
    assert done.code == 3
    assert "connection refused" in packed(tmp_path)["doctor.txt"]


async def test_where_it_cant_be_written_it_says_so(tmp_path: Path) -> None:
    config_file(tmp_path, "ws://127.0.0.1:9", 1)
    (tmp_path / "fleet-tui").mkdir()
    (tmp_path / "fleet-tui" / "incidents").write_text("in the way")
    done = await run(tmp_path, "doctor", "--bundle")
    assert done.code == 1
    assert done.err.startswith("fleet-tui: cannot write the archive: File exists (")
    assert "Errno" not in done.err and "XDG_STATE_HOME" in done.err


@pytest.mark.nightly
@pytest.mark.parametrize(
    "line",
    ["doctor --bundle --timeout 1", "record night.gz --timeout 1", "run - --dry-run --timeout 1", "audit"],
)
def test_no_screen_is_imported(tmp_path: Path, line: str) -> None:
    config_file(tmp_path, "ws://127.0.0.1:9")
    code = (
        "import sys; from fleet_tui.__main__ import main\n"
        f"sys.argv = ['fleet-tui', *{line.split()}]\n"
        "try: main()\nexcept SystemExit: pass\n"
        "print([name for name in sys.modules if name.split('.')[0] in ('textual', 'rich')])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env={**os.environ, "XDG_STATE_HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        input="pause all\n",
        check=True,
    )
    assert done.stdout.splitlines()[-1] == "[]"
