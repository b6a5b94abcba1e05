"""Twists on the wire and back."""

import json
import math

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.robots.ros.set_up.twists import is_stamped, read_twist, twist_message
from fleet_tui.text.errors import WireError

SPEED = st.floats(-10, 10)


@given(st.builds(Speeds, SPEED, SPEED, SPEED), st.booleans())
def test_speeds_survive_the_wire(speeds: Speeds, stamped: bool) -> None:
    encoded = msgspec.Raw(msgspec.json.encode(twist_message(speeds, stamped)))
    assert read_twist(encoded, stamped) == speeds


def test_the_bridge_fills_in_the_stamp() -> None:
    assert twist_message(Speeds(), True)["header"] == {"frame_id": "base_link"}


@pytest.mark.parametrize(
    ("type_", "stamped"),
    [
        ("geometry_msgs/Twist", False),
        ("geometry_msgs/msg/Twist", False),
        ("geometry_msgs/msg/TwistStamped", True),
        ("std_msgs/String", None),
        ("", None),
    ],
)
def test_types_of_both_generations_are_known(type_: str, stamped: bool | None) -> None:
    assert is_stamped(type_) is stamped


@pytest.mark.parametrize("value", [None, "fast", math.inf, 1e999])
def test_a_twist_that_is_none_is_refused(value: object) -> None:
    message = {"linear": {"x": value, "y": 0, "z": 0}, "angular": {"x": 0, "y": 0, "z": 0}}
    with pytest.raises(WireError):
        read_twist(msgspec.Raw(json.dumps(message).encode()), False)


def test_one_with_missing_values_is_refused() -> None:
    with pytest.raises(WireError):
        read_twist(msgspec.Raw(b'{"linear": {"x": 1}, "angular": {}}'), False)
