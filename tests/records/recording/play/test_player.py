"""The console on a recording: what it shows, that it moves in time, and that nothing leaves it."""

from pathlib import Path

import pytest

from fleet_tui.model.events import TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.terminal.display_driver import DisplayDriver
from tests.support.console_pilot import console
from tests.support.fleets import R0, T0, WALL
from tests.support.replay_console import replayed
from tests.support.replay_times import at, clock
from tests.support.tapes import MadeUp, shift
from tests.support.watched_store import config_of


@pytest.fixture
def night(tmp_path: Path) -> Path:
    return shift(tmp_path / "night.jsonl.gz").path


def x(state: FleetState) -> float:
    pose = state.robots[R0].pose
    assert pose is not None
    return pose.value.x


@pytest.mark.parametrize("size", [(120, 40), (80, 24), (50, 14)])
async def test_it_is_never_mistaken_for_the_fleet(night: Path, size: tuple[int, int]) -> None:
    async with replayed(night, "+50s", size) as it:
        status, bar, told = it.text.splitlines()[0], it.pane("time-line"), it.text
        assert at(50) in status and ("● rosbridge 0.0 s" in status) is (size[0] >= 80)
        assert "0:50" in bar or " 50 " in bar
        assert "4:59" in bar and "stopped x1  read-only" in told and clock(50) in bar
        await it.press("?")
        assert at(50) in it.text.splitlines()[0]


async def test_it_moves_in_time_by_keys(night: Path) -> None:
    async with replayed(night, "+50s") as it:
        assert x(it.store.state) == 50.0
        await it.press(">")
        await it.shows(at(60))
        await it.press("<", "<")
        await it.shows(at(40))
        await it.press(".")
        await it.shows(at(41))
        await it.press(",", ",")
        await it.shows(at(39))
        assert x(it.store.state) == 39.0
        await it.press("end")
        await it.shows("end of recording")
        await it.shows(at(299))
        await it.press("tab", "home")  # also from a table
        await it.shows(at(0))
        await it.type("@+2m5s")
        await it.shows("Go to +2m5s")
        await it.press("enter")
        await it.shows(at(125))
        await it.type(f"@{clock(30)}")
        await it.press("enter")
        await it.shows(at(30))


async def test_marks_say_what_they_are(night: Path) -> None:
    async with replayed(night) as it:
        await it.press(")")
        await it.shows("▲ robot_0 offline", "time-line")
        await it.shows("offline", "alarms")
        await it.press(")")
        await it.shows("◆ robot_0 pause", "time-line")
        await it.shows(at(200))
        await it.press(")")
        await it.shows("12 records missing here: the disk was full")
        await it.press("(", "(", "(")
        await it.shows(at(105))
        bar = it.pane("time-line").splitlines()[0]
        assert bar.index("●") < bar.index("◆") < bar.index("╳")


async def test_it_plays_at_its_pace_and_stops_at_the_end(night: Path) -> None:
    async with replayed(night, "+296s") as it:
        for _ in range(3):
            await it.press("F")
        await it.shows("stopped x8")
        await it.press("space")
        await it.shows("end of recording")
        assert x(it.store.state) == 299.0
        await it.press("space", "S", "backspace")
        await it.shows("end of recording")
        await it.hides("x8")


async def test_help_and_hints_begin_with_the_recording(night: Path) -> None:
    async with replayed(night) as it:
        footer = it.text.splitlines()[-1]
        assert "play/stop" in footer and " order " not in footer and " pause " not in footer
        await it.press("?")
        await it.shows("The recording")
        assert it.text.index("The recording") < it.text.index("Play or pause")
        assert "Look around on the map" in it.text and "Pause the selected robot" not in it.text


async def test_old_trails_are_forgotten_where_time_jumps(night: Path) -> None:
    async with replayed(night, "+20s") as it:
        await it.press("t", ".", ".")
        assert it.app.main.features.map.picture.scene is not None
        await it.shows(at(22))
        assert len(it.app.main.features.map.picture.trails.of(it.app.main.features.map.picture.scene))
        await it.press("<")
        await it.shows(at(12))
        points = it.app.main.features.map.picture.trails.of(it.app.main.features.map.picture.scene)
        assert points[:, 0].max(initial=0.0) <= 12.0


async def test_space_in_a_text_field_is_a_space(night: Path) -> None:
    async with replayed(night, "+20s") as it:
        await it.type(":pause ")
        await it.shows("stopped")
        assert it.store.state.now == T0 + 20


@pytest.fixture
def damaged(night: Path) -> Path:
    night.write_bytes(night.read_bytes()[:-400])
    return night


async def test_a_damaged_recording_is_played_to_its_last_whole_record(damaged: Path) -> None:
    async with replayed(damaged, "+10s") as it:
        await it.shows("incomplete: truncated", "time-line")
        await it.press("end")
        await it.shows("end of recording")
        assert 250.0 <= x(it.store.state) < 299.0


async def test_a_click_on_the_time_line_goes_there(night: Path) -> None:
    async with replayed(night) as it:
        await it.pilot.click("#time-line", offset=(60, 0))
        await it.shows("REPLAY")
        await it.until(lambda state: 130 < state.now - T0 < 170)


async def test_what_is_said_at_a_command_is_seen(night: Path) -> None:
    async with replayed(night, "+200s") as it:
        await it.press("p")
        await it.shows("not sent: this is a recording")
        await it.press(".")
        await it.shows(at(201))
        await it.shows("not sent: this is a recording")
        await it.press("<")
        await it.hides("not sent: this is a recording")


async def test_before_a_time_is_typed_it_is_said_how_to(tmp_path: Path) -> None:
    async with replayed(shift(tmp_path / "night.jsonl.gz").path) as it:
        await it.press("@")
        await it.shows("enter a time: 12:04:31")
        assert "is not a time" not in it.text
        await it.press(*"noon")
        await it.shows("'noon' is not a time")


async def test_without_a_recording_its_keys_mean_nothing(server: RosbridgeServer) -> None:
    async with console(config_of(server.url)) as it:
        await it.press("space", ".", "@", "end")
        assert it.app.main.session.time_line() is None
        assert not it.app.main.features.palette.is_open
        await it.press("?")
        await it.shows("Send an order")
        assert "The recording" not in it.text


async def test_where_nothing_was_recorded_it_goes_on_and_says_so(tmp_path: Path) -> None:
    made = MadeUp(config_of("ws://site:9090"))
    for second in (0, 1, 2, 602, 603, 604):
        made.tell(second, TimePassed(T0 + second, WALL + second))
    async with replayed(made.written(tmp_path / "gap.jsonl.gz").path, "+2s") as it:
        await it.press("space")
        await it.shows("╳ no records for the 10:00 before this")
        await it.shows(at(604))


async def test_nobody_is_called_to_a_recorded_alarm(night: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    called: list[str] = []
    monkeypatch.setattr(DisplayDriver, "call", lambda _driver, sequence: called.append(sequence))
    async with replayed(night, "+100s") as it:
        await it.press(">")
        await it.shows("robot_0 offline", "alarms")
    assert called == []
