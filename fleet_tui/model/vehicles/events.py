"""Events of vehicles that a master control moves over nodes. `at` is the monotonic second at which the event
reached this console."""

from collections.abc import Mapping

from msgspec import Struct

from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.vehicles.vehicle import Vehicle, VehicleConnection, VehicleFeatures


class VehicleReported(Struct, frozen=True, tag=True):
    """The whole state of a vehicle, beside pose, charge and order."""

    robot: str
    at: float
    vehicle: Vehicle


class ConnectionReported(Struct, frozen=True, tag=True):
    """A vehicle's connection. `is_kept`: the broker had kept the message, so that anything else is newer."""

    robot: str
    at: float
    connection: VehicleConnection
    is_kept: bool = False


class NodesReported(Struct, frozen=True, tag=True):
    """The nodes of a vehicle's order, and the edges between them, with their places where they are known, on
    the map of this frame."""

    robot: str
    at: float
    frame_id: str
    graph: RouteGraph


class FactsheetReported(Struct, frozen=True, tag=True):
    """The properties of a vehicle, as texts by name, and what it takes."""

    robot: str
    at: float
    facts: Mapping[str, str]
    features: VehicleFeatures = VehicleFeatures()


class MasterSeen(Struct, frozen=True, tag=True):
    """A master control gave an order or an instant action: another one than this console. `what` describes
    it, `ids` are those that it used."""

    robot: str
    at: float
    what: str
    ids: tuple[str, ...] = ()


class MessageKept(Struct, frozen=True, tag=True):
    """The broker had kept a message of a vehicle, or to it, whose age nothing tells; `text` says so."""

    robot: str
    at: float
    text: str


VehicleFact = (
    VehicleReported | ConnectionReported | NodesReported | FactsheetReported | MasterSeen | MessageKept
)
