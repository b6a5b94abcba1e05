"""The same ROS type in the spelling of either ROS."""

import pytest

from fleet_tui.robots.adapter import Feed
from fleet_tui.robots.ros.type_names import plain_type, same_type, type_problem


@pytest.mark.parametrize(
    ("one", "other", "is_same"),
    [
        ("std_msgs/Bool", "std_msgs/msg/Bool", True),
        ("OH_ressources/Cancel_order", "oh_ressources/srv/CancelOrder", True),
        ("nav2_msgs/action/Spin", "nav2_msgs/Spin", True),
        ("std_msgs/Bool", "std_msgs/Int8", False),
        ("std_msgs/Bool", "example/Bool", False),
    ],
)
def test_spelling_alone_makes_no_other_type(one: str, other: str, is_same: bool) -> None:
    assert same_type(one, other) is same_type(other, one) is is_same


def test_the_middle_part_is_left_out() -> None:
    assert plain_type("std_msgs/msg/Bool") == plain_type("std_msgs/Bool") == "std_msgs/Bool"


def test_a_wrong_type_is_named_with_the_keys_that_correct_it() -> None:
    feed = Feed("cargo", ("r1",), "", "/r1/cargo", "std_msgs/Bool")
    assert type_problem(feed, {"/r1/cargo": "std_msgs/Int8"}, "profiles.old") == (
        "/r1/cargo has type std_msgs/Int8, not std_msgs/Bool: correct profiles.old.topics.cargo"
        " or profiles.old.types.cargo"
    )
    assert type_problem(feed, {"/r1/cargo": "std_msgs/msg/Bool"}) == ""
    assert type_problem(feed, {}) == "", "a bridge that does not tell is believed"
