"""Of several consoles of a site one notifies."""

import sys
from pathlib import Path

import msgspec
import pytest

from fleet_tui.config.schema import Config, Notify
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.history.notifying import alarm_program
from tests.support.fleets import T0, battery, fleet, link_up, reduced, tick
from tests.support.polling import eventually

KEEP = "import sys; open('given', 'a').write(sys.stdin.read())"
PROGRAM = Notify([sys.executable, "-c", KEEP], ["battery"])


def low(at: float) -> FleetState:
    return reduced(fleet(1), link_up(T0), battery(at, 5.0), tick(at))


def site(folder: Path) -> Config:
    folder.mkdir()
    return msgspec.structs.replace(Config(), notify=PROGRAM, path=folder / "config.toml")


@pytest.fixture(autouse=True)
def own_state_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


def test_one_console_of_a_site_notifies_and_other_sites_have_their_own(tmp_path: Path) -> None:
    first, other = site(tmp_path / "first"), site(tmp_path / "other")
    programs = [alarm_program(config, print) for config in (first, first, other)]
    for program in programs:
        assert program is not None
        program.look(low(T0))
    given = [tmp_path / name / "given" for name in ("first", "other")]
    eventually(lambda: all(path.exists() and path.read_text() for path in given))
    assert [path.read_text().count("robot_0") for path in given] == [2, 2]  # robot and source


def test_without_a_command_there_is_none() -> None:
    assert alarm_program(Config(), print) is None
