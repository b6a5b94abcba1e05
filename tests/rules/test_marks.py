"""The numbers of robots on the map: those of their names, where these tell all apart."""

import pytest

from fleet_tui.errors import CommandError
from fleet_tui.rules.language.words import find_robot
from fleet_tui.rules.marks import marks_of
from tests.support.fleets import fleet


@pytest.mark.parametrize(
    ("names", "marks"),
    [
        (("robot_0", "robot_1", "robot_10"), ("0", "1", "10")),
        (("amr-07", "amr-12"), ("07", "12")),
        (("R2D2", "C3PO"), ("2", "3")),
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


def test_a_typed_number_that_is_one_robots_key_and_anothers_mark_is_rejected() -> None:
    state = fleet(3)
    with pytest.raises(CommandError, match="ambiguous: robot_0 or robot_1; type the name"):
        find_robot("1", state)
    assert find_robot("0", state).name == "robot_0"
    assert find_robot("3", state).name == "robot_2"
    assert find_robot("robot_1", state).name == "robot_1"
