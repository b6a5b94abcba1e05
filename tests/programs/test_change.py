"""Starts, stops and restarts: the state afterwards decides, not the word of who was asked."""

from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.model.programs.program import ProgramState
from fleet_tui.programs.change import change
from fleet_tui.programs.status import look
from tests.support.stand_ins import BRIDGE, KEPT, REMOTE, StandIns, with_status

UNIT = "rosbridge.service"


@pytest.mark.parametrize("program", [BRIDGE, REMOTE])
async def test_a_unit_starts_restarts_and_stops(
    stand_ins: StandIns, tmp_path: Path, program: ProgramEntry
) -> None:
    assert (await change(program, "start", tmp_path)).text == "confirmed"
    before = await look(program, tmp_path)
    assert (await change(program, "start", tmp_path)).text == "confirmed (already running)"
    assert (await change(program, "restart", tmp_path)).text == "confirmed"
    assert (await look(program, tmp_path)).instance != before.instance
    assert (await change(program, "stop", tmp_path)).text == "confirmed"
    assert (await change(program, "stop", tmp_path)).text == "confirmed (already stopped)"
    asked = [
        call.split()[-3] for call in stand_ins.calls if "--no-block" in call and call.startswith("systemctl")
    ]
    assert asked == ["start", "restart", "stop"]


async def test_a_refusal_is_told_with_its_remedy(stand_ins: StandIns, tmp_path: Path) -> None:
    (stand_ins.folder / f"{UNIT}.refuses").write_text("Interactive authentication required.\n")
    outcome = await change(BRIDGE, "start", tmp_path)
    assert outcome.word == "refused" and "polkit" in outcome.detail


async def test_a_unit_that_fails_is_failed_and_one_that_hangs_not_confirmed(
    stand_ins: StandIns, tmp_path: Path
) -> None:
    after = stand_ins.folder / f"{UNIT}.next"
    after.write_text("ActiveState=failed\nResult=exit-code\nExecMainStatus=2\nInvocationID=1\n")
    assert (await change(BRIDGE, "start", tmp_path)).text == "failed (exit status 2: see its log)"
    after.write_text("ActiveState=activating\nInvocationID=2\n")
    assert (await change(BRIDGE, "start", tmp_path, 0.5)).text == "not confirmed (is starting)"


async def test_an_old_failure_is_not_taken_for_a_new_one(stand_ins: StandIns, tmp_path: Path) -> None:
    failed = {"ActiveState": "failed", "Result": "exit-code", "ExecMainStatus": "2", "InvocationID": "1"}
    stand_ins.unit(UNIT, **failed)
    stand_ins.unit(f"{UNIT}.next", **failed)
    assert (await change(BRIDGE, "start", tmp_path, 0.5)).word == "not confirmed"


async def test_a_restart_that_leaves_the_same_process_is_not_confirmed(
    stand_ins: StandIns, tmp_path: Path
) -> None:
    same = {"ActiveState": "active", "InvocationID": "1"}
    stand_ins.unit(UNIT, **same)
    stand_ins.unit(f"{UNIT}.next", **same)
    assert (await change(BRIDGE, "restart", tmp_path, 0.5)).text == "not confirmed (is running)"


async def test_a_host_that_can_not_be_reached_confirms_nothing(stand_ins: StandIns, tmp_path: Path) -> None:
    (stand_ins.folder / "unreachable").touch()
    outcome = await change(REMOTE, "start", tmp_path)
    assert outcome.word == "not confirmed" and "can't be reached" in outcome.detail


async def test_a_command_under_systemd(stand_ins: StandIns, tmp_path: Path) -> None:
    assert (await change(KEPT, "start", tmp_path)).text == "confirmed"
    assert (await look(KEPT, tmp_path)).has_systemd
    assert (await change(KEPT, "restart", tmp_path)).text == "confirmed"
    assert (await change(KEPT, "stop", tmp_path)).text == "confirmed"
    runs = [call for call in stand_ins.calls if call.startswith("systemd-run")]
    assert len(runs) == 2 and all(call.endswith("-- sleep 60") for call in runs)


async def test_a_command_without_systemd(stand_ins: StandIns, tmp_path: Path) -> None:
    stand_ins.without_systemd()
    folder = tmp_path / "programs"
    assert (await change(KEPT, "start", folder)).text == "confirmed"
    before = await look(KEPT, folder)
    assert before.state is ProgramState.RUNNING
    assert (await change(KEPT, "restart", folder)).text == "confirmed"
    assert (await look(KEPT, folder)).instance != before.instance
    assert (await change(KEPT, "stop", folder)).text == "confirmed"


async def test_a_command_that_ends_at_once_is_failed(stand_ins: StandIns, tmp_path: Path) -> None:
    stand_ins.without_systemd()
    broken = ProgramEntry("job", start=["sh", "-c", "exit 3"])
    assert (await change(broken, "start", tmp_path)).text == "failed (exit status 3: see its log)"
    brief = ProgramEntry("brief", start=["sh", "-c", "sleep 0.4; exit 4"])
    assert (await change(brief, "start", tmp_path)).text == "failed (exit status 4: see its log)"
    missing = ProgramEntry("gone", start=["no-such-program"])
    outcome = await change(missing, "start", tmp_path)
    assert outcome.word == "refused" and "no-such-program" in outcome.detail


async def test_programs_of_the_site(stand_ins: StandIns, tmp_path: Path) -> None:
    for program in (with_status(tmp_path), replace(with_status(tmp_path), host="server")):
        assert (await change(program, "start", tmp_path)).text == "confirmed"
        assert (await change(program, "restart", tmp_path)).text == "confirmed"
        assert (await change(program, "stop", tmp_path)).text == "confirmed"
    slow = replace(with_status(tmp_path), start=["sleep", "60"])
    assert (await change(slow, "start", tmp_path, 0.5)).word == "not confirmed"


@pytest.fixture
def view_only(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let nobody do more than view."""
    file = tmp_path / "rights.toml"
    file.touch(0o644)
    monkeypatch.setattr("fleet_tui.config.rights.FILE", file)
    monkeypatch.setattr("fleet_tui.config.rights.OWNER", file.stat().st_uid)
    tmp_path.chmod(0o755)


async def test_who_may_not_set_up_changes_no_program(
    stand_ins: StandIns, tmp_path: Path, view_only: None
) -> None:
    assert (await change(BRIDGE, "start", tmp_path)).text == "refused (not allowed: setup)"
    assert stand_ins.calls == []
