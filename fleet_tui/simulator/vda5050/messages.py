"""Messages of simulated vehicles, version 2.0."""

from collections.abc import Mapping
from typing import Any

from fleet_tui.simulator.vda5050.vehicle import SimVehicle

VERSION = "2.0.0"
MANUFACTURER = "fleet-tui"


def header(vehicle: SimVehicle, number: int, stamp: str) -> dict[str, Any]:
    whose = {"manufacturer": MANUFACTURER, "serialNumber": vehicle.name}
    return {"headerId": number, "timestamp": stamp, "version": VERSION, **whose}


def position(vehicle: SimVehicle) -> Mapping[str, Any]:
    """Return the pose."""
    return {
        "x": round(vehicle.x, 3),
        "y": round(vehicle.y, 3),
        "theta": round(vehicle.theta, 4),
        "mapId": vehicle.map_id,
        "positionInitialized": vehicle.localised,
    }


def state(vehicle: SimVehicle) -> dict[str, Any]:
    """Return the whole state, without its header."""
    nodes = [
        {key: node[key] for key in ("nodeId", "sequenceId", "released", "nodePosition") if key in node}
        for node in vehicle.nodes
    ]
    return {
        "orderId": vehicle.order_id,
        "orderUpdateId": vehicle.update_id,
        "lastNodeId": vehicle.last_node,
        "lastNodeSequenceId": vehicle.last_sequence,
        "driving": vehicle.driving,
        "paused": vehicle.paused,
        "operatingMode": vehicle.mode,
        "nodeStates": nodes,
        "edgeStates": [],
        "agvPosition": position(vehicle),
        "actionStates": vehicle.actions,
        "batteryState": {"batteryCharge": round(vehicle.battery, 1), "charging": vehicle.charging},
        "errors": vehicle.errors,
        "information": [],
        "loads": [{"loadType": "EPAL"}] if vehicle.loaded else [],
        "safetyState": {"eStop": vehicle.e_stop, "fieldViolation": vehicle.field},
    }


def factsheet() -> dict[str, Any]:
    """Return the properties, without a header."""
    return {
        "typeSpecification": {"seriesName": "simulated", "agvKinematic": "DIFF", "agvClass": "CARRIER"},
        "physicalParameters": {"speedMin": 0.1, "speedMax": 1.2, "width": 0.6, "length": 0.9},
        "protocolFeatures": {
            "agvActions": [
                {"actionType": "startCharging", "actionScopes": ["NODE"]},
                {"actionType": "stopCharging", "actionScopes": ["INSTANT"]},
            ]
        },
    }
