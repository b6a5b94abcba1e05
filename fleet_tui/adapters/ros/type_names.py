"""Names of ROS types: the same type is spelled in more than one way."""

_MIDDLES = ("/msg/", "/srv/", "/action/")


def plain_type(name: str) -> str:
    """Write a ROS type without ROS 2's middle part: `std_msgs/msg/Bool` as `std_msgs/Bool`."""
    for middle in _MIDDLES:
        name = name.replace(middle, "/")
    return name


def same_type(one: str, other: str) -> bool:
    """Tell whether two names mean the same type, as far as their spelling tells.

    ROS 2 has a middle part (`std_msgs/msg/Bool`), lower-case packages and CamelCase names:
    `OH_ressources/Cancel_order` is `oh_ressources/srv/CancelOrder` there.
    """
    return _folded(one) == _folded(other)


def _folded(name: str) -> str:
    return plain_type(name).replace("_", "").lower()
