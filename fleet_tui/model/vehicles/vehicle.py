"""Vehicles that a master control moves over nodes: their reports beside pose, charge and orders."""

from msgspec import Struct

from fleet_tui.text.language import EMPTY, Message, verbatim

OFFLINE = "OFFLINE"
BROKEN = "CONNECTIONBROKEN"
REMOVED = "REMOVED"
"""Connections of a vehicle that is gone: it said goodbye, the broker says it for it, or somebody has removed
what the broker kept of it."""
HIBERNATING = "HIBERNATING"
DRIVES = frozenset({"AUTOMATIC", "SEMIAUTOMATIC"})
"""Modes in which a vehicle takes orders."""
HIGH = frozenset({"FATAL", "CRITICAL"})
MEDIUM = frozenset({"URGENT"})
"""Levels of errors, by the priority of their alarms; others are low."""
CRAWLS = 0.05
"""Metres per second above which a vehicle drives, also one that says that it does not."""
HEADING = "nodePosition.theta"
START_CHARGING = "startCharging"
STOP_CHARGING = "stopCharging"
CANCEL = "cancelOrder"
INSTANT = frozenset(
    {
        CANCEL,
        "startPause",
        "stopPause",
        "startHibernation",
        "stopHibernation",
        "shutdown",
        "stateRequest",
        "logReport",
        "factsheetRequest",
        "initPosition",
        "updateCertificate",
        "enableMap",
        "downloadMap",
        "deleteMap",
        "enableZoneSet",
        "downloadZoneSet",
        "deleteZoneSet",
        "clearInstantActions",
        "clearZoneActions",
        "trigger",
        "retry",
        "skipRetry",
    }
)
"""Types of actions that are given beside an order."""


class VehicleError(Struct, frozen=True):
    """An error that a vehicle reports. `references` are what it concerns, by their keys: ids of orders and
    actions, the number and the topic of a message."""

    type: str
    level: str = ""
    text: str = ""
    hint: str = ""
    references: tuple[tuple[str, str], ...] = ()

    def concerns(self, id_: str) -> bool:
        """Tell whether it names an order or an action. Numbers and topics of messages could be ids, too."""
        return any(value == id_ for key, value in self.references if key not in ("headerId", "topic"))


class VehicleAction(Struct, frozen=True):
    """The state of an action, by the id that its sender gave it. `is_beside`: it was given beside an order,
    as by its type or by the message that had it."""

    id: str
    status: str
    text: str = ""
    type: str = ""
    is_beside: bool = False

    @property
    def is_carried_out(self) -> bool:
        """Tell whether it is an action of an order that runs now."""
        return self.status in ("INITIALIZING", "RUNNING") and not self.is_beside

    @property
    def is_cancelled(self) -> bool:
        """Tell whether it is the end of a cancellation."""
        return self.type == CANCEL and self.status == "FINISHED"


class CurrentAction(Struct, frozen=True):
    """An action that a vehicle carries out; `since` its first report here (monotonic), which is its begin if
    that was seen."""

    action: VehicleAction
    since: float
    is_begin_seen: bool


class Vehicle(Struct, frozen=True):
    """One state of a vehicle; None: not reported. `address` is the base of its topics, `version` that of its
    messages. `is_placed`: it reports a position. `e_stop` is the word for its emergency stop, empty if it is
    not active. `last_node` is where it was last, `distance` the metres that it drove from there, `nodes_left`
    are the released nodes that it has still to reach, `horizon` the number of those not released; `waits`: it
    may not drive on until its master control releases them, or grants what it `asks` for. `maps` and
    `zone_sets` are those that it has enabled, `map_off` is the map of its position if that is not among them.
    `load`: empty without one. `speed` in m/s."""

    address: str
    version: str
    mode: str = ""
    driving: bool | None = None
    charging: bool | None = None
    localised: bool | None = None
    is_placed: bool = True
    e_stop: str = ""
    field_violation: bool | None = None
    last_node: str = ""
    distance: float | None = None
    nodes_left: tuple[str, ...] = ()
    horizon: int = 0
    waits: bool = False
    asks: tuple[str, ...] = ()
    maps: tuple[str, ...] = ()
    zone_sets: tuple[str, ...] = ()
    map_off: str = ""
    load: str | None = None
    order_id: str = ""
    paused: bool | None = None
    speed: float | None = None
    errors: tuple[VehicleError, ...] = ()
    actions: tuple[VehicleAction, ...] = ()

    @property
    def moves(self) -> bool | None:
        """Tell whether it drives or turns, by either word for it; None if it has none."""
        if self.driving or self.speed is None:
            return self.driving
        return self.speed > CRAWLS

    @property
    def takes_orders(self) -> bool:
        """Tell whether its mode lets a master control drive it; true if unknown."""
        return not self.mode or self.mode in DRIVES

    @property
    def mode_text(self) -> Message:
        """Return its mode in one word, empty for the usual ones."""
        return EMPTY if self.takes_orders else Message(self.mode.lower())

    @property
    def e_stop_text(self) -> Message:
        """Return the text of its emergency stop, empty if it is not active."""
        return Message("e-stop ({mode})", mode=self.e_stop.lower()) if self.e_stop else EMPTY


class VehicleConnection(Struct, frozen=True):
    """A vehicle's connection to its broker, by its own word or its last will; `address` is the base of its
    topics, `version` that of its messages."""

    word: str
    address: str
    version: str

    @property
    def is_gone(self) -> bool:
        """Tell whether the vehicle has left the broker."""
        return self.word in (OFFLINE, BROKEN, REMOVED)

    @property
    def is_asleep(self) -> bool:
        """Tell whether the vehicle saves power, and sends nothing until it is woken."""
        return self.word == HIBERNATING

    @property
    def text(self) -> Message:
        """Return its state in words."""
        words = {
            "ONLINE": Message("connected"),
            OFFLINE: Message("signed off"),
            BROKEN: Message("connection broken"),
            REMOVED: Message("removed from the broker"),
        }
        return words.get(self.word) or (
            verbatim(self.word.lower()) if self.word else Message("connection unknown")
        )


class VehicleFeatures(Struct, frozen=True):
    """What a vehicle takes by its factsheet: `parameters` of orders beside those that all take, by their full
    names, None if it does not say; types of actions at nodes of an order, and of instant ones."""

    parameters: tuple[str, ...] | None = None
    at_nodes: tuple[str, ...] = ()
    instant: tuple[str, ...] = ()

    @property
    def charges(self) -> bool:
        """Tell whether an order can make it charge."""
        return START_CHARGING in self.at_nodes

    @property
    def charges_beside(self) -> bool:
        """Tell whether only an instant action can make it charge."""
        return START_CHARGING in self.instant and not self.charges

    @property
    def refuses_headings(self) -> bool:
        """Tell whether its nodes have no heading: a parameter that is not listed is not supported. An empty
        list says nothing: many send it for want of another."""
        return bool(self.parameters) and not any(one.endswith(HEADING) for one in self.parameters or ())
