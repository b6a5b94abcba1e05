"""Messages of vehicles as the standard has them, written for tests; versions differ as in its branches."""

import json
from typing import Any

BASE = "uagv/v2/KIT/0001"


def message(version: str = "2.0.0", **fields: Any) -> bytes:
    header = {
        "headerId": 1,
        "timestamp": "2026-01-02T03:04:05.678Z",
        "version": version,
        "manufacturer": "KIT",
        "serialNumber": "0001",
    }
    return json.dumps({**header, **fields}).encode()


def position(x: float = 1.0, y: float = 2.0, map_id: str = "hall", **more: Any) -> dict[str, Any]:
    return {"x": x, "y": y, "theta": 0.5, "mapId": map_id, "positionInitialized": True, **more}


def node(
    id_: str, number: int, released: bool = True, x: float | None = None, y: float = 0.0
) -> dict[str, Any]:
    place = {} if x is None else {"nodePosition": {"x": x, "y": y, "mapId": "hall"}}
    return {"nodeId": id_, "sequenceId": number, "released": released, **place}


def state(version: str = "2.0.0", **fields: Any) -> bytes:
    usual = {
        "orderId": "",
        "orderUpdateId": 0,
        "lastNodeId": "n0",
        "lastNodeSequenceId": 0,
        "driving": False,
        "paused": False,
        "operatingMode": "AUTOMATIC",
        "nodeStates": [],
        "edgeStates": [],
        "agvPosition": position(),
        "actionStates": [],
        "batteryState": {"batteryCharge": 80.5, "charging": False},
        "errors": [],
        "information": [],
        "safetyState": {"eStop": "NONE", "fieldViolation": False},
    }
    return message(version, **{**usual, **fields})


def state_3(**fields: Any) -> bytes:
    """A state of 3.0, whose fields have other names."""
    usual = {
        "orderId": "",
        "lastNodeId": "n0",
        "driving": False,
        "operatingMode": "TEACH_IN",
        "nodeStates": [],
        "edgeStates": [],
        "mobileRobotPosition": {"x": 1.0, "y": 2.0, "theta": 0.5, "mapId": "hall", "localized": False},
        "actionStates": [],
        "instantActionStates": [],
        "powerSupply": {"stateOfCharge": 42.0, "charging": True},
        "errors": [],
        "safetyState": {"activeEmergencyStop": "REMOTE", "fieldViolation": True},
    }
    return message("3.0.0", **{**usual, **fields})


def error(
    level: str = "WARNING", type_: str = "motorError", text: str = "", hint: str = "", **ids: str
) -> dict[str, Any]:
    references = [{"referenceKey": key, "referenceValue": value} for key, value in ids.items()]
    found: dict[str, Any] = {"errorType": type_, "errorLevel": level, "errorReferences": references}
    return {**found, **({"errorDescription": text} if text else {}), **({"errorHint": hint} if hint else {})}
