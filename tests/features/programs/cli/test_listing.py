"""`fleet-tui programs`: a table or JSON, and an exit code for scripts."""

import json
from pathlib import Path

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.features.programs.cli.listing import list_programs
from tests.support.stand_ins import BRIDGE, StandIns, with_status


async def test_all_well_is_0_and_what_is_unknown_1(stand_ins: StandIns, tmp_path: Path) -> None:
    lines: list[str] = []
    programs = [BRIDGE, with_status(tmp_path)]
    assert await list_programs(programs, False, lines.append) == 1
    assert "no unit rosbridge.service" in lines[1] and "stopped" in lines[2]
    stand_ins.unit("rosbridge.service", LoadState="loaded", ActiveState="active", NRestarts="1")
    assert await list_programs(programs, False, lines.append) == 0
    assert lines[4].split()[:4] == ["bridge", "here", "●", "running"]


async def test_json_has_every_field(stand_ins: StandIns) -> None:
    stamp = "Mon 2024-05-06 08:00:00 UTC"
    stand_ins.unit("rosbridge.service", ActiveState="active", StateChangeTimestamp=stamp, BoundBy="a.service")
    lines: list[str] = []
    await list_programs([ProgramEntry("b", unit="rosbridge.service", host="server")], True, lines.append)
    (found,) = json.loads(lines[0])["programs"]
    assert found == {
        "name": "b",
        "host": "server",
        "state": "running",
        "since": "2024-05-06T08:00:00+00:00",
        "restarts": None,
        "detail": "",
        "stops_with_it": ["a.service"],
        "needs": [],
    }
