"""The option `--fault`: every fault of every kind is in the help and is offered."""

from pathlib import Path

import pytest

from fleet_tui.simulator.kinds import KINDS
from tests.support.command_line import run


@pytest.mark.parametrize("kind", KINDS)
def test_the_help_of_the_simulator_lists_every_fault(tmp_path: Path, kind: str) -> None:
    text = " ".join(run("sim", "--help", cwd=tmp_path).stdout.split())
    assert all(f" {name} {' '.join(what.split())}" in text for name, (what, _) in KINDS[kind].faults.items())


@pytest.mark.parametrize("kind", KINDS)
def test_the_faults_of_the_typed_kind_are_offered(tmp_path: Path, kind: str) -> None:
    line = f"fleet-tui sim --kind {kind} --fault "
    asked = {"_FLEET_TUI_COMPLETE": "bash_complete", "COMP_WORDS": line, "COMP_CWORD": "5"}
    offered = run(cwd=tmp_path, **asked).stdout.split()
    assert offered == [f"plain,{name}" for name in KINDS[kind].faults]
