"""Messages in ROS's own encoding."""

import pytest
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from fleet_tui.simulator.ros.definitions import MESSAGES, Fields
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.ros.encoding import encode
from fleet_tui.simulator.ros.filling import fill
from fleet_tui.simulator.ros.ros2 import ROS2


def definition(fields: Fields) -> str:
    """The lines of a .msg file."""
    length = {key: "" if field.length is None else f"[{field.length or ''}]" for key, field in fields.items()}
    return "\n".join(
        f"{field.type}{length[key]} {key}".replace("OH_", "oh_") for key, field in fields.items()
    )


def bag_type(short: str) -> str:
    """The library's name of a type: no capital letters in a package."""
    return short.replace("OH_", "oh_").replace("/", "/msg/")


@pytest.mark.parametrize(("dialect", "store"), [(ROS1, Stores.ROS1_NOETIC), (ROS2, Stores.ROS2_JAZZY)])
def test_every_message_is_encoded_as_ros_reads_it(dialect: Dialect, store: Stores) -> None:
    """Against an implementation of others: a bag library reads what was encoded, and writes it the same."""
    types = get_typestore(store)
    shorts = {dialect.short(dialect.message_type(name)) for name in MESSAGES}
    messages = {short: fields for short in shorts if (fields := dialect.fields(short)) is not None}
    for short, fields in messages.items():
        type_ = bag_type(short)
        if type_ not in types.types:
            types.register(get_types_from_msg(definition(fields), type_))
    order = {"id": 7, "start": 1, "end": 2, "status": "W"}
    for short, fields in messages.items():
        given = {"orders": [order, order]} if short.endswith("ActionQueue") else {}
        data = encode(dialect, short, fill(dialect, short, fields, given, now=1.5))
        type_ = bag_type(short)
        if dialect.version == 1:
            assert bytes(types.serialize_ros1(types.deserialize_ros1(data, type_), type_)) == data, short
        else:
            assert bytes(types.serialize_cdr(types.deserialize_cdr(data, type_), type_)) == data, short
