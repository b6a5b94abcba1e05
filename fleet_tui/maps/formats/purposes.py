"""The words of several robot stacks for the type of a vertex, by what it is for."""

from collections.abc import Mapping
from enum import Enum

from fleet_tui.model.graph import Role
from fleet_tui.model.graphs.live import role_of


class Purpose(Enum):
    """The purpose of a vertex."""

    PLAIN = "plain"
    LIFT = "lift"
    CHARGER = "charger"
    PARKING = "parking"
    HOLDING = "holding"
    PASSTHROUGH = "passthrough"
    OTHER = "other"


_PURPOSES: Mapping[str, Purpose] = {
    "": Purpose.PLAIN,
    "plain": Purpose.PLAIN,
    "halt_position": Purpose.PLAIN,
    "parking": Purpose.PARKING,
    "parking_spot": Purpose.PARKING,
    "park_position": Purpose.PARKING,
    "holding_point": Purpose.HOLDING,
    "passthrough_point": Purpose.PASSTHROUGH,
}
_OF_ROLES = {Role.ELEVATOR: Purpose.LIFT, Role.DOCKING: Purpose.CHARGER, Role.PLAIN: Purpose.OTHER}


def purpose_of(type_: str) -> Purpose:
    """Return the purpose of a vertex of this type; docking stations are chargers, as in the roles."""
    return _PURPOSES.get(type_.lower()) or _OF_ROLES[role_of(type_.lower())]
