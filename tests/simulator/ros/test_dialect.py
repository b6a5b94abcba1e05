"""The dialect of ROS 1: names, times, integers and error texts."""

import pytest

from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.simulator.ros.errors import ServiceError


def test_names_are_those_of_the_packages() -> None:
    name = "geometry_msgs/PoseStamped"
    assert ROS1.message_type(name) == ROS1.short(name) == name
    assert ROS1.part("std_srvs/Trigger", "Request") == "std_srvs/TriggerRequest"
    assert ROS1.rosapi_type("Topics") == "rosapi/Topics"
    assert ROS1.importable(name) and not ROS1.importable("geometry_msgs/No") and ROS1.importable("other/Any")


def test_times_have_seconds_and_nanoseconds_and_headers_count() -> None:
    assert ROS1.time(7.25) == {"secs": 7, "nsecs": 250_000_000}
    assert ROS1.header(3, 7.25, "map") == {"seq": 3, "stamp": ROS1.time(7.25), "frame_id": "map"}


@pytest.mark.parametrize(
    ("bits", "signed", "fits", "beyond"),
    [(8, True, (-128, 127), (-129, 128)), (16, False, (0, 65535), (-1, 65536))],
)
def test_an_integer_that_does_not_fit_is_refused(
    bits: int, signed: bool, fits: tuple[int, ...], beyond: tuple[int, ...]
) -> None:
    assert [ROS1.integer("data", value, bits, signed) for value in fits] == list(fits)
    for value in beyond:
        with pytest.raises(ServiceError, match=rf"\[{'' if signed else 'u'}int{bits}\]"):
            ROS1.integer("data", value, bits, signed)


def test_an_unknown_parameter_is_the_default_or_null() -> None:
    assert ROS1.got_param("7", {"default": "8"}) == {"value": "7"}
    assert ROS1.got_param(None, {"default": "8"}) == {"value": "8"}
    assert ROS1.got_param(None, {"default": ""}) == {"value": "null"}
