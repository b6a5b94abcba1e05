"""Kinds of robots: what of the model a robot ever reports and accepts."""

from collections.abc import Mapping

from msgspec import Struct, field

ORDER, ORDER_TO, CANCEL, CLEAR, PAUSE, RESUME = "order", "order to", "cancel", "clear", "pause", "resume"
"""What a robot may accept: an order from one place to another, one to a place alone, and so on."""


class Kind(Struct, frozen=True):
    """Capabilities of a robot by its kind and profile. `reports` are the values that ever come of it, by the
    names of Robot's fields; `accepts` what can be asked of it. `silence`: seconds after which a value that
    stays away is old, infinite where it comes only when it changes; for others `FleetState.patience`
    counts. `frames_are_floors`: the frame of its poses names the floor. `tells_ends`: it lists how an order
    ended. `keeps_goals`: it drives one goal at a time and keeps no queue: this console does.
    `holds`: to pause it is to cancel its goal, which this console keeps and gives again."""

    name: str = ""
    reports: tuple[str, ...] = ()
    accepts: tuple[str, ...] = ()
    silence: Mapping[str, float] = field(default_factory=dict)
    frames_are_floors: bool = True
    tells_ends: bool = False
    keeps_goals: bool = False
    holds: bool = False
