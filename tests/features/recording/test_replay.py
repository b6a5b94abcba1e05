"""A console on a recording: its time is never taken for now, and what is typed goes to a time."""

from pathlib import Path

import pytest

from fleet_tui.features.recording.replay import Replay
from fleet_tui.keys import BY_ID, Pane
from fleet_tui.model.events import TimePassed
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.play.player import Player
from fleet_tui.text.language import Message
from fleet_tui.ui.view.roles import StyleRole
from tests.support.desk import Desk
from tests.support.fleets import R0, T0, WALL
from tests.support.replay_times import at
from tests.support.tapes import MadeUp
from tests.support.watched_store import config_of


class Played:
    """A recording of a hundred seconds, stopped, and the controller on it."""

    def __init__(self, folder: Path) -> None:
        made = MadeUp(config_of("ws://site:9090"))
        for second in range(100):
            made.tell(second, TimePassed(T0 + second, WALL + second))
        self.player = Player(open_recording(made.written(folder / "x.jsonl.gz").path))
        self.player.toggle()
        desk = Desk(self.player.state)
        self.store, self.notices = desk.store, desk.notices
        self.has_map, self.jumps = True, 0
        self.replay = Replay(self.player, desk.console(), self._jumped)

    def _jumped(self) -> bool:
        self.jumps += self.has_map
        return self.has_map


@pytest.fixture
def played(tmp_path: Path) -> Played:
    return Played(tmp_path)


def test_the_headline_begins_with_the_recorded_time(played: Played) -> None:
    (first, role), *_ = played.replay.headline(played.store.state, R0, 120)[0]
    assert (first.strip(), role) == (at(0), StyleRole.WARN)


def test_a_jump_forgets_the_notice_once_there_is_a_map(played: Played) -> None:
    played.player.enter(T0 + 50)
    played.notices.note(Message("old"))
    played.has_map = False
    played.replay.headline(played.store.state, R0, 120)
    assert played.notices.text == "old" and played.jumps == 0
    played.has_map = True
    for _ in range(2):
        played.replay.headline(played.store.state, R0, 120)
    assert played.notices.text == "" and played.jumps == 1


@pytest.mark.parametrize(
    ("line", "says"),
    [("@", "enter a time: "), ("@noon", "'noon' is not a time"), ("+9h", "+9h"), ("pause", None)],
)
def test_what_is_typed_is_a_time_or_none(played: Played, line: str, says: str | None) -> None:
    found = played.replay.typed(line)
    assert (found is None) if says is None else (found is not None and says in found.problem)


def test_a_time_is_gone_to_when_it_is_chosen(played: Played, monkeypatch: pytest.MonkeyPatch) -> None:
    sought: list[float] = []
    monkeypatch.setattr(played.player, "seek", sought.append)
    found = played.replay.typed("@ +1m5s")
    assert found is not None
    ((text, do),) = found.entries
    do()
    played.replay.pick_time(0, 80)
    assert text == "Go to +1m5s" and sought[0] == T0 + 65 and sought[1] <= T0 + 1


def test_actions_of_the_player_may_say_why_not(played: Played, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(played.player, "to_mark", lambda _step: Message("no mark there"))
    played.replay.actions["next_mark"]()
    assert played.notices.text == "no mark there"


@pytest.mark.parametrize(
    ("back", "on", "step"),
    [
        ("skip_back", "skip_on", ("skip", 10)),
        ("previous_mark", "next_mark", ("to_mark", 1)),
        ("step_back", "step_on", ("step", 1)),
        ("record_back", "record_on", ("step_record", 1)),
        ("slower", "faster", ("change_speed", 1)),
        ("to_beginning", "to_the_end", ("to_end", 1)),
        ("usual_speed", "usual_speed", ("change_speed", 0)),
    ],
)
def test_a_pair_of_keys_moves_both_ways(
    played: Played, monkeypatch: pytest.MonkeyPatch, back: str, on: str, step: tuple[str, int]
) -> None:
    name, by = step
    told: list[float] = []
    monkeypatch.setattr(played.player, name, told.append)
    played.replay.actions[on]()
    played.replay.actions[back]()
    assert told == [by, -by]


def test_keys_of_live_consoles_are_not_offered(played: Played) -> None:
    assert not played.replay.offers(BY_ID["arm"]) and played.replay.offers(BY_ID["play"])
    assert Pane.RECORDING in played.replay.panes
