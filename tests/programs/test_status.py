"""Looks at programs of every form."""

from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.model.programs.program import ProgramState
from fleet_tui.programs import status as looking
from fleet_tui.programs.status import look
from tests.support.stand_ins import BRIDGE, KEPT, REMOTE, StandIns, with_status

RUNNING, STOPPED, UNKNOWN = ProgramState.RUNNING, ProgramState.STOPPED, ProgramState.UNKNOWN


async def test_a_unit_here_and_on_another_host(stand_ins: StandIns, tmp_path: Path) -> None:
    stand_ins.unit("rosbridge.service", LoadState="loaded", ActiveState="active", NRestarts="4")
    for program in (BRIDGE, REMOTE):
        found = await look(program, tmp_path)
        assert (found.state, found.restarts) == (RUNNING, 4)
    assert [call.split()[0] for call in stand_ins.calls] == ["systemctl", "ssh", "systemctl"]


async def test_a_unit_that_is_not_there_is_unknown_but_a_command_is_stopped(
    stand_ins: StandIns, tmp_path: Path
) -> None:
    found = await look(BRIDGE, tmp_path)
    assert found.state is UNKNOWN and "no unit rosbridge.service" in found.detail
    assert (await look(KEPT, tmp_path)).state is STOPPED


async def test_a_host_that_can_not_be_reached_is_told(stand_ins: StandIns, tmp_path: Path) -> None:
    (stand_ins.folder / "unreachable").touch()
    found = await look(REMOTE, tmp_path)
    assert found.state is UNKNOWN and "server can't be reached" in found.detail
    own = replace(with_status(tmp_path), host="server")
    found = await look(own, tmp_path)
    assert found.state is UNKNOWN and "server can't be reached" in found.detail


async def test_without_systemd_a_command_is_stopped_and_a_unit_unknown(
    stand_ins: StandIns, tmp_path: Path
) -> None:
    stand_ins.without_systemd()
    found = await look(KEPT, tmp_path)
    assert found.state is STOPPED and not found.has_systemd
    found = await look(BRIDGE, tmp_path)
    assert found.state is UNKNOWN and "use start, stop and status" in found.detail


@pytest.mark.parametrize(
    ("code", "state"), [(0, RUNNING), (1, STOPPED), (3, STOPPED), (4, UNKNOWN), (127, UNKNOWN)]
)
async def test_a_status_of_the_site_tells_by_its_exit_code(
    tmp_path: Path, code: int, state: ProgramState
) -> None:
    program = ProgramEntry("p", start=["a"], stop=["b"], status=["sh", "-c", f"exit {code}"])
    assert (await look(program, tmp_path)).state is state


async def test_a_status_that_hangs_is_unknown(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(looking, "LOOK_WITHIN", 0.2)
    program = ProgramEntry("p", start=["a"], stop=["b"], status=["sleep", "60"])
    found = await look(program, tmp_path)
    assert found.state is UNKNOWN and found.detail.startswith("no answer within")
