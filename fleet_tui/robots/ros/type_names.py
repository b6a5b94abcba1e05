"""Names of ROS types: the same type has several spellings."""

from collections.abc import Mapping

from fleet_tui.robots.adapter import Feed
from fleet_tui.text.language import EMPTY, Message

_MIDDLES = ("/msg/", "/srv/", "/action/")


def plain_type(name: str) -> str:
    """Return a ROS type without ROS 2's middle part: `std_msgs/msg/Bool` as `std_msgs/Bool`."""
    for middle in _MIDDLES:
        name = name.replace(middle, "/")
    return name


def same_type(one: str, other: str) -> bool:
    """Tell whether two names mean the same type, by their spelling.

    ROS 2 has a middle part (`std_msgs/msg/Bool`), lower-case packages and CamelCase names:
    `OH_ressources/Cancel_order` is `oh_ressources/srv/CancelOrder` there.
    """
    return _folded(one) == _folded(other)


def _folded(name: str) -> str:
    return plain_type(name).replace("_", "").lower()


def type_problem(feed: Feed, types: Mapping[str, str], table: str = "profile") -> Message:
    """Return the reason not to subscribe to a topic: with a wrong type it would be lost for every client.
    `types` by topic, as a bridge reports them; `table`: the config table of the profile."""
    found = types.get(feed.address)
    if found is None or same_type(found, feed.type):
        return EMPTY
    keys = f"{table}.topics.{feed.key} or {table}.types.{feed.key}"
    return Message(
        "{address} has type {actual}, not {type}: correct {keys}",
        address=feed.address,
        actual=found,
        type=feed.type,
        keys=keys,
    )
