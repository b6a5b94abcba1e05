"""Completion: what a line can become."""

import pytest

from fleet_tui.commands.language.completion import complete
from fleet_tui.model.kind import PAUSE, Kind
from tests.support.fleets import R0, labels, reduced
from tests.support.kinds import FULL, MUTE, moved
from tests.support.typed import known


def test_only_accepted_verbs_and_robots_complete_a_line() -> None:
    state = reduced(moved(MUTE, Kind("p", accepts=(PAUSE,))), labels({1: "Base"}))
    assert complete("p", state) == ["pause ", "pause all "]
    assert complete("cl", state) == complete("clear ", state) == []
    assert complete("pause ", state) == ["pause all", "pause robot_1"]
    assert complete("robot_0 ", state) == []
    assert complete("robot_0 ", reduced(moved(FULL), labels({1: "Base"}))) == ["robot_0 Base "]


@pytest.mark.parametrize(
    ("line", "completed"),
    [
        ("", []),
        ("ro", ["robot_0 ", "robot_1 "]),
        ("cl", ["clear "]),
        ("pause ", ["pause all", "pause robot_0", "pause robot_1"]),
        ("clear ", ["clear robot_0", "clear robot_1"]),
        ("clear r", ["clear robot_0", "clear robot_1"]),
        ("cancel ", ["cancel 12", "cancel 13", "cancel robot_0 ", "cancel robot_1 "]),
        ("cancel 2 ", []),
        ("cancel robot_0 1", ["cancel robot_0 12", "cancel robot_0 13"]),
        ("cancel robot_0 12 ", []),
        ("robot_0 cons", ["robot_0 Consumidores "]),
        ("robot_0 Consumidores ", ["robot_0 Consumidores > "]),
        ("robot_0 Dock", ["robot_0 Dock 7 "]),
        ("robot_0 Dock 7", ["robot_0 Dock 7 "]),
        ("robot_0 Base > Dock ", ["robot_0 Base > Dock 7 "]),
        ("robot_0 Base >lab", ['robot_0 Base > "Lab > base" ']),
        ("robot_0 Base > sumi", ["robot_0 Base > Consumidores "]),
        ("order ro", ["order robot_0 ", "order robot_1 "]),
        ("order robot_0 Do", ['order robot_0 "Dock 7" ']),
        ('order robot_0 "Do', ['order robot_0 "Dock 7" ']),
        ("order robot_0 Base > Do", ["order robot_0 Base > Dock 7 "]),
        ("nobody Ba", []),
        ("order nobody Ba", []),
    ],
)
def test_what_a_line_can_become(line: str, completed: list[str]) -> None:
    assert complete(line, known(), R0) == completed


def test_completed_lines_lead_to_an_order_without_typing_a_label() -> None:
    """The last destinations first."""
    line = "robot_0 "
    for _ in range(3):
        line = complete(line, known(), R0)[0]
    assert line == "robot_0 Base > Base "
    assert complete("robot_0 Base > ", known(), R0)[:2] == [
        "robot_0 Base > Base ",
        "robot_0 Base > Consumidores ",
    ]
