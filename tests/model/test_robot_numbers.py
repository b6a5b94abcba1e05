"""The numbers of robots on the map: those of their names, where these tell all apart."""

import pytest

from fleet_tui.commands.language.words import find_robot
from fleet_tui.model.robot_numbers import marks_of
from fleet_tui.text.errors import CommandError
from tests.support.fleets import fleet


@pytest.mark.parametrize(
    ("names", "marks"),
    [
        (("robot_0", "robot_1", "robot_10"), ("0", "1", "10")),
        (("amr-07", "amr-12"), ("07", "12")),
        (("R2D2", "C3PO"), ("1", "2")),
        (("hall2_agv1", "hall3_agv1"), ("1", "2")),
        (("alice", "robot_7"), ("1", "2")),
        (("agv_1", "agv_01"), ("1", "2")),
        (("robot_123456", "robot_7"), ("1", "2")),
        ((), ()),
    ],
)
def test_digits_of_names_count_if_they_tell_all_robots_apart(
    names: tuple[str, ...], marks: tuple[str, ...]
) -> None:
    assert marks_of(names) == marks


def test_a_typed_number_is_the_robot_whose_name_ends_with_it() -> None:
    state = fleet(3)
    assert [find_robot(word, state).name for word in ("0", "1", "2")] == ["robot_0", "robot_1", "robot_2"]
    assert find_robot("robot_1", state).name == "robot_1"
    with pytest.raises(CommandError, match="unknown robot '3'"):
        find_robot("3", state)
