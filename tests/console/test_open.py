"""Opening the console: what is refused before the screen opens, and what a recording may not do."""

from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from fleet_tui.config.load import from_text
from fleet_tui.config.schema import Alarms, Config
from fleet_tui.console import open as console
from fleet_tui.console.app import FleetApp
from fleet_tui.console.open import ask_first, open_console, replaying
from fleet_tui.features.recording.replay import Replay
from fleet_tui.records.recording.play.start import playing
from fleet_tui.state.store import Store
from fleet_tui.text.errors import ConfigError
from fleet_tui.text.language import tr
from fleet_tui.ui.languages import ENGLISH, use_language
from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.terminal.terminal_driver import PlainDriver
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.fleets import T0, tick
from tests.support.tapes import MadeUp
from tests.support.vda_fleet import config_text
from tests.support.watched_store import config_of


@pytest.fixture
def opened(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[LeanApp]:
    """The apps that would run, with folders of their own and no log file."""
    apps: list[LeanApp] = []
    monkeypatch.setattr(LeanApp, "run", lambda app: apps.append(app))
    for name, value in {"need_terminal": None, "log_to_file": tmp_path, "user_folder": tmp_path}.items():
        monkeypatch.setattr(console, name, lambda *_, value=value: value)
    monkeypatch.setattr(console, "state_folder", lambda: tmp_path)
    return apps


def test_a_theme_that_is_not_there_is_refused_before_the_screen_opens(opened: list[LeanApp]) -> None:
    config = config_of("ws://site:9090")
    config = replace(config, ui=replace(config.ui, theme="drak"))
    with pytest.raises(ConfigError, match=r"ui.theme: unknown theme 'drak', did you mean dark\?"):
        open_console(config, False, None, False)
    assert opened == []


@pytest.mark.parametrize("read_only", [True, False])
def test_the_console_watches_where_it_was_told_to_and_names_what_is_wrong_with_a_theme(
    opened: list[LeanApp], tmp_path: Path, read_only: bool
) -> None:
    (tmp_path / "themes").mkdir()
    (tmp_path / "themes" / "mine.toml").write_text("rubbish")
    open_console(config_of("ws://site:9090"), read_only, "ascii", False, demo=True)
    (app,) = opened
    assert isinstance(app, FleetApp) and app.config.operator.read_only is read_only
    assert bool(app.main.files.refusal) is read_only
    assert app.main.notices.text.startswith("theme ")


@pytest.mark.parametrize(
    ("keys", "read_only", "said"),
    [
        ({}, False, "simulated fleet. Try an order: o, type Base, Enter, type Cons, Enter"),
        ({"order": "ctrl+o"}, False, "Try an order: Ctrl-O, type Base"),
        ({}, True, "simulated fleet, read-only"),
    ],
)
def test_a_simulated_fleet_names_the_first_thing_to_try(
    opened: list[LeanApp], keys: dict[str, str], read_only: bool, said: str
) -> None:
    open_console(replace(config_of("ws://site:9090"), keys=keys), read_only, "ascii", False, demo=True)
    (app,) = opened
    assert isinstance(app, FleetApp) and said in app.main.notices.text


@pytest.mark.parametrize(
    ("role", "read_only", "said"),
    [
        ("master", False, "master control on broker: routes from the graph, no traffic control"),
        ("master", True, "1 robot"),
        ("pause", False, "1 robot"),
    ],
)
def test_a_master_control_says_so_when_it_opens(
    opened: list[LeanApp], role: str, read_only: bool, said: str
) -> None:
    open_console(from_text(config_text(role=role)), read_only, "ascii", False)
    (app,) = opened
    assert isinstance(app, FleetApp) and said in app.main.notices.text


def test_the_screen_speaks_the_language_of_the_configuration(opened: list[LeanApp]) -> None:
    config = config_of("ws://site:9090")
    try:
        open_console(replace(config, ui=replace(config.ui, language="de")), False, None, False)
        assert tr("no link") == "keine Verbindung"
        open_console(config, False, None, False)
        assert tr("no link") == "no link"
    finally:
        use_language(ENGLISH)
    assert len(opened) == 2


def test_without_unicode_the_driver_sends_ascii(
    opened: list[LeanApp], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(console, "has_unicode", lambda: False)
    open_console(config_of("ws://site:9090"), False, "ascii", False, demo=True)
    assert ask_first(None, "ascii") is None
    assert [app.driver_class for app in opened] == [PlainDriver, PlainDriver]


def test_a_failure_of_the_app_ends_the_command(
    opened: list[LeanApp], monkeypatch: pytest.MonkeyPatch
) -> None:
    def run(app: Any) -> None:
        app.failure = ValueError("broken")

    monkeypatch.setattr(LeanApp, "run", run)
    with pytest.raises(RuntimeError, match="broken"):
        ask_first(None, None)


def test_a_recording_is_read_only_and_calls_nobody(tmp_path: Path) -> None:
    bells = Alarms(bell=["high"], notify=["high", "medium"])
    made = MadeUp(replace(config_of("ws://site:9090"), alarms=bells))
    for second in range(3):
        made.tell(second, tick(T0 + second))
    player, config = playing(made.written(tmp_path / "x.gz").path, Config(), 1.0, "", lambda _share: None)
    store = Store(player.state)
    app = replaying(config, player, store, load_themes(None)[0], Drawing.BRAILLE)
    assert app.backend.refusal and isinstance(app.main.session, Replay)
    assert app.config.operator.read_only
    assert (app.config.alarms.bell, app.config.alarms.notify) == ([], [])
