"""The robots' services and their types."""

from collections.abc import Mapping
from dataclasses import dataclass

from fleet_tui.simulator.ros.definitions import SERVICES, Fields
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.errors import HandlerError, NodeDiedError, ServiceError

__all__ = ["HandlerError", "NodeDiedError", "ServiceError", "ServiceType", "robot_services", "service_type"]

_ROBOT_SERVICES = {
    "Execute_order": "OH_ressources/Execute_manual_order",
    "Execute_order_with_cargo": "OH_ressources/Execute_manual_order_with_cargo",
    "Cancel_order": "OH_ressources/Cancel_order",
    "Clear_orders": "OH_ressources/Clear_orders",
    "Pause": "std_srvs/Trigger",
    "Resume": "std_srvs/Trigger",
}


@dataclass(frozen=True)
class ServiceType:
    """A service type with the fields of its request."""

    name: str
    fields: Fields


def service_type(dialect: Dialect, name: str) -> ServiceType:
    """A service type by its ROS 1 name."""
    return ServiceType(dialect.service_type(name), SERVICES[name][0])


def robot_services(dialect: Dialect) -> Mapping[str, ServiceType]:
    """A robot's services: the last part of the name -> type."""
    return {verb: service_type(dialect, name) for verb, name in _ROBOT_SERVICES.items()}
