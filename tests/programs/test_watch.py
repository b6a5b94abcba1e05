"""The watch: every program on its own, only while somebody looks."""

from pathlib import Path

import pytest

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.model.programs.program import ProgramState, ProgramStatus
from fleet_tui.programs import watch as watching
from fleet_tui.programs.watch import ProgramWatch
from fleet_tui.text.language import Message
from tests.support.polling import until
from tests.support.stand_ins import with_status


async def test_one_that_hangs_holds_up_no_other(tmp_path: Path) -> None:
    hangs = ProgramEntry("hangs", start=["a"], stop=["b"], status=["sleep", "60"])
    watch = ProgramWatch([hangs, with_status(tmp_path)], tmp_path)
    watch.open()
    await until(lambda: watch.rows["nav"].state(0.0) is ProgramState.STOPPED)
    (tmp_path / "runs").touch()
    await until(lambda: watch.rows["nav"].state(0.0) is ProgramState.RUNNING)
    assert watch.rows["hangs"].status is None
    watch.close()
    (tmp_path / "runs").unlink()
    seen = watch.rows["nav"]
    await watch.look("nav")
    assert seen.state(0.0) is ProgramState.RUNNING and watch.rows["nav"].state(0.0) is ProgramState.STOPPED


async def test_a_fault_of_our_own_is_told_and_survived(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def fails(program: ProgramEntry, folder: Path) -> ProgramStatus:
        raise RuntimeError("broken")

    monkeypatch.setattr(watching, "look", fails)
    watch = ProgramWatch([with_status(tmp_path)], tmp_path)
    watch.open()
    await until(lambda: watch.rows["nav"].status)
    watch.close()
    status = watch.rows["nav"].status
    assert status is not None and "internal error: broken" in status.detail


async def test_the_last_known_state_outlives_what_is_unknown(tmp_path: Path) -> None:
    watch = ProgramWatch([with_status(tmp_path)], tmp_path)
    watch.put("nav", ProgramStatus(ProgramState.RUNNING, 1.0))
    watch.put("nav", ProgramStatus(ProgramState.UNKNOWN, 5.0))
    known = watch.rows["nav"].last_known
    assert known is not None and (known.state, known.at) == (ProgramState.RUNNING, 1.0)
    watch.set_pending("nav", Message("stop"))
    assert watch.rows["nav"].pending == "stop"
