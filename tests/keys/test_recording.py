"""Keys of a recording: each pair moves by the same step in opposite directions."""

import pytest

from fleet_tui.keys.key import Pane
from fleet_tui.keys.recording import RECORDING
from tests.support.key_calls import calls

CALLS = calls(RECORDING)


@pytest.mark.parametrize(
    ("back", "on", "step"),
    [
        ("skip_back", "skip_on", "skip(10)"),
        ("previous_mark", "next_mark", "to_mark(1)"),
        ("step_back", "step_on", "step(1)"),
        ("record_back", "record_on", "step_record(1)"),
        ("slower", "faster", "change_speed(1)"),
        ("to_beginning", "to_the_end", "to_end(1)"),
    ],
)
def test_a_pair_of_keys_moves_both_ways(back: str, on: str, step: str) -> None:
    assert CALLS[on] == f"player.{step}"
    assert CALLS[back] == f"player.{step.replace('(', '(-')}"


def test_the_others_play_return_to_the_original_speed_and_ask_for_a_time() -> None:
    assert CALLS["play"] == "player.toggle()"
    assert CALLS["usual_speed"] == "player.change_speed(0)"
    assert CALLS["go_to_time"] == "view.go_to_time()"
    assert {key.pane for key in RECORDING} == {Pane.RECORDING}
