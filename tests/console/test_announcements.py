"""Announcements: by the terminal always, by the operator's program only of a live fleet."""

import sys
from pathlib import Path

import msgspec
import pytest

from fleet_tui.config.schema import Alarms, Config, Notify
from fleet_tui.config.start import initial_state
from fleet_tui.console.app import announcing
from fleet_tui.state.store import Store
from fleet_tui.ui.backend import LiveBackend
from tests.support.desk import CollectingBackend
from tests.support.fleets import T0, battery, fleet, link_up, reduced, tick
from tests.support.polling import eventually

KEEP = "import sys; open('given', 'w').write(sys.stdin.read())"


@pytest.mark.parametrize("is_live", [True, False])
def test_a_recording_rings_the_bell_and_starts_no_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_live: bool
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    config = msgspec.structs.replace(
        Config(),
        alarms=Alarms(bell=["medium"]),
        notify=Notify([sys.executable, "-c", KEEP], ["battery"]),
        path=tmp_path / "config.toml",
    )
    sent: list[str] = []

    def send(given: str) -> bool:
        sent.append(given)
        return True

    state = initial_state(config, T0)
    backend = LiveBackend(config, Store(state)) if is_live else CollectingBackend()
    look = announcing(config, backend, send, print)
    look(reduced(fleet(1), link_up(T0), battery(T0, 5.0), tick(T0)))
    assert sent == ["\a"]
    if is_live:
        eventually((tmp_path / "given").exists)
    assert (tmp_path / "state").exists() == is_live
