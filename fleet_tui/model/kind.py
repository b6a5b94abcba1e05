"""Kinds of robots: the parts of the model that a robot can report and accept."""

from collections.abc import Mapping
from math import inf

from msgspec import Struct, field

from fleet_tui.text.language import Message, verbatim

ORDER = "order"
ORDER_TO = "order to"
CANCEL = "cancel"
CLEAR = "clear"
PAUSE = "pause"
RESUME = "resume"
"""Requests that a robot may accept: an order from one place to another, one to a place alone, and so on."""

POSE = "pose"
LOCALISE = "localise"
SETTLE = "settle"
GOAL = "goal"
MAPPING = "mapping"
GOAL_CANCEL = "goal cancel"
CHARGE = "charge"
GRAPH = "graph"
DRIVE = "drive"
MAP_SAVE = "map save"
POSE_GRAPH_SAVE = "pose graph save"
"""Set-up requests that a robot may accept."""
ORDER_ANY = "order any"
"""An order that a dispatcher gives to any of its robots."""
SCAN = "scan"
PATH = "path"
CAMERA = "camera"
"""Streams of a robot that can be watched."""
FRAMES = "frames"
"""The fixed frames of a robot, a stream that is read to place its scans."""

_NOUNS = {
    ORDER: Message("order with a start"),
    ORDER_TO: Message("order without a start"),
    ORDER_ANY: Message("orders to any robot"),
    POSE: Message("setting of the pose"),
    LOCALISE: Message("global localisation"),
    SETTLE: Message("refinement of the pose"),
    GOAL: Message("goals beside orders"),
    GOAL_CANCEL: Message("cancellation of goals"),
    CHARGE: Message("start of a charge"),
    MAPPING: Message("switch of the mapping mode"),
    MAP_SAVE: Message("saving of maps on the robot"),
    POSE_GRAPH_SAVE: Message("saving of pose graphs on the robot"),
    GRAPH: Message("sending of graphs"),
    DRIVE: Message("driving by hand"),
    SCAN: Message("laser scan"),
    PATH: Message("planned path"),
    CAMERA: Message("camera"),
}


def noun_of(ability: str) -> Message:
    """Return the name of an ability in a sentence."""
    return _NOUNS.get(ability) or verbatim(ability)


class Kind(Struct, frozen=True):
    """Capabilities of a robot by its kind and profile. `reports` are the values it can report, by the names
    of Robot's fields; `accepts` the requests it takes. `silence`: seconds after which a missing value is old,
    infinite for one sent only on change; for others `offline_after` counts, after which a silent robot is
    offline, 0: as configured. `optional`: reported values that not every such robot has. By unaccepted
    request `unset` is the key of the profile that is empty, `withheld` the reason that this console must not
    make it. `frames_are_floors`: the frame of its poses names the floor. `reports_ends`: it lists how an
    order ended. `keeps_goals`: it drives one goal at a time and has no queue: this console keeps it. `holds`:
    a pause cancels its goal, which this console keeps and sends again. `takes_stops`: one order leads to any
    number of stops; `gives_stops`: this console sends those one by one. `changes_floors`: an order can lead
    it to another floor. `may_lock`: a second pause locks the motors of a robot that moves on.
    `spares_others`: a clear cancels only the orders of this console. `is_told_changes`: its orders are listed
    as they change, so that a late console does not know all. `names_places`: orders name vertices by their
    labels. `streams` can be watched. `loads_graphs`: a graph reaches it as the file of its floor, which it
    loads by its path. `pose_topic`, `odometry_topic`: the names of these topics, with {robot}, empty if
    unknown."""

    name: str = ""
    reports: tuple[str, ...] = ()
    accepts: tuple[str, ...] = ()
    silence: Mapping[str, float] = field(default_factory=dict)
    unset: Mapping[str, str] = field(default_factory=dict)
    withheld: Mapping[str, str] = field(default_factory=dict)
    offline_after: float = 0.0
    optional: tuple[str, ...] = ()
    frames_are_floors: bool = True
    reports_ends: bool = field(default=False, name="tells_ends")  # as recordings have it
    keeps_goals: bool = False
    holds: bool = False
    may_lock: bool = False
    takes_stops: bool = False
    gives_stops: bool = False
    changes_floors: bool = True
    spares_others: bool = False
    names_places: bool = False
    is_told_changes: bool = False
    streams: tuple[str, ...] = ()
    loads_graphs: bool = False
    pose_topic: str = ""
    odometry_topic: str = ""

    def can(self, verb: str) -> bool:
        """Tell whether it accepts the request of a verb; an order with or without a start, a goal also as an
        order."""
        orders = verb == ORDER or (verb == GOAL and self.keeps_goals)
        return verb in self.accepts or (orders and ORDER_TO in self.accepts)

    def lack(self, asked: str) -> Message:
        """Return the text for a request that it does not accept."""
        if asked in self.withheld:
            return Message(
                "{reason}: no {noun}",
                reason=self.withheld[asked],
                noun=Message("orders") if asked in (ORDER, ORDER_TO) else noun_of(asked),
            )
        if asked in self.unset:
            return Message("{key} is empty: no {noun}", key=self.unset[asked], noun=noun_of(asked))
        noun = noun_of(asked)
        if asked in (ORDER, ORDER_TO) and not self.can(ORDER):
            noun = Message("orders")
        return Message("this kind has no {noun}", noun=noun)

    @property
    def brings_cargo(self) -> bool:
        """Tell whether an order to one place alone is for the cargo on board."""
        return "cargo" in self.reports and not self.keeps_goals

    @property
    def lists_orders(self) -> bool:
        """Tell whether such a robot ever reports its orders."""
        return "queue" in self.reports

    @property
    def clears_own(self) -> bool:
        """Tell whether a clear cancels only the orders of this console."""
        return self.keeps_goals or self.spares_others

    def silence_of(self, value: str, usual: float) -> float:
        """Return the seconds after which a value is old."""
        return self.silence.get(value, self.offline_after or usual)

    def expects(self, value: str) -> bool:
        """Tell whether a value must arrive regularly: each robot reports it, and not only on change."""
        is_certain = value in self.reports and value not in self.optional
        return is_certain and self.silence_of(value, 0.0) < inf
