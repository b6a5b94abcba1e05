"""Settings of this kind alone: `[profile.vda5050]`."""

from typing import Annotated, Any, Literal

import msgspec

from fleet_tui.robots.vda5050.topics import TEMPLATE


class VehicleSettings(msgspec.Struct, frozen=True):
    """`interface`: the first level of topics, empty for any. `topic`: the template of a broker that has other
    levels. `instant_actions`: the field of an instantActions message that such vehicles read, empty for that
    of their version. `deviation`: metres within which a node counts as reached, 0 for the vehicle's own.
    `actions`: those with which a load is picked at the first stop of an order, and dropped at the last, as in
    messages, without an id."""

    interface: str = ""
    topic: str = TEMPLATE
    instant_actions: Literal["", "actions", "instantActions"] = ""
    deviation: Annotated[float, msgspec.Meta(ge=0, le=100)] = 0.0
    actions: dict[Literal["pick", "drop"], dict[str, Any]] = {}


SETTINGS = VehicleSettings
