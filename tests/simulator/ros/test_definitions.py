"""Definitions of messages and services: every type that is named is defined."""

from collections.abc import Mapping

from fleet_tui.simulator.ros.definitions import ACTIONS, MESSAGES, PACKAGES, SERVICES, Fields
from fleet_tui.simulator.ros.filling import TIMES, ZEROS

BUILT_IN = {*ZEROS, "time", "builtin_interfaces/Time"}


def unknown(fields: Fields) -> set[str]:
    return {field.type for field in fields.values()} - BUILT_IN - MESSAGES.keys()


def test_every_type_in_a_message_a_service_or_an_action_is_defined() -> None:
    assert TIMES
    parts: Mapping[str, Fields] = {
        **MESSAGES,
        **{f"{name} {n}": part for name, both in SERVICES.items() for n, part in enumerate(both)},
        **{f"{name} {n}": part for name, parts in ACTIONS.items() for n, part in enumerate(parts)},
    }
    assert {name: missing for name, fields in parts.items() if (missing := unknown(fields))} == {}


def test_lengths_of_arrays_are_read() -> None:
    covariance = MESSAGES["geometry_msgs/PoseWithCovariance"]["covariance"]
    data = MESSAGES["nav_msgs/OccupancyGrid"]["data"]
    plain = MESSAGES["std_msgs/Bool"]["data"]
    assert [(one.type, one.length) for one in (covariance, data, plain)] == [
        ("float64", 36),
        ("int8", 0),
        ("bool", None),
    ]
    assert {"std_msgs", "nav_msgs", "OH_ressources"} <= set(PACKAGES)
