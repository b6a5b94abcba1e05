"""Many vehicles on a broker, told by one process: states once a second, visualizations five times.

Arguments: the port of the broker, the number of vehicles. Each line of output: the messages sent so far.
"""

import json
import math
import sys
import time
from typing import Any

import paho.mqtt.client as mqtt
from paho.mqtt.enums import CallbackAPIVersion

VISUALIZATIONS = 5
"""Per second and vehicle, beside one state."""
NODES = 10


def header(number: int) -> dict[str, Any]:
    stamp = time.strftime("%Y-%m-%dT%H:%M:%S", time.gmtime()) + ".000Z"
    return {
        "headerId": 1,
        "timestamp": stamp,
        "version": "2.0.0",
        "manufacturer": "KIT",
        "serialNumber": str(number),
    }


def position(number: int, now: float) -> dict[str, Any]:
    angle = now / 5 + number
    x, y = 15 + 12 * math.cos(angle), 10 + 8 * math.sin(angle)
    return {"x": x, "y": y, "theta": angle % 6.28 - 3.14, "mapId": "floor_0", "positionInitialized": True}


def state(number: int, now: float) -> bytes:
    nodes = [
        {
            "nodeId": f"n{n}",
            "sequenceId": 2 * n,
            "released": True,
            "nodePosition": {"x": 3.0 * n, "y": 5.0, "mapId": "floor_0"},
        }
        for n in range(NODES)
    ]
    edges = [{"edgeId": f"e{n}", "sequenceId": 2 * n + 1, "released": True} for n in range(NODES - 1)]
    fields = {
        "orderId": f"order-{number}",
        "orderUpdateId": 0,
        "lastNodeId": "n0",
        "lastNodeSequenceId": 0,
        "driving": True,
        "paused": False,
        "operatingMode": "AUTOMATIC",
        "nodeStates": nodes,
        "edgeStates": edges,
        "agvPosition": position(number, now),
        "actionStates": [],
        "batteryState": {"batteryCharge": 80.0, "charging": False},
        "errors": [],
        "information": [],
        "loads": [],
        "safetyState": {"eStop": "NONE", "fieldViolation": False},
    }
    return json.dumps({**header(number), **fields}).encode()


def visualization(number: int, now: float) -> bytes:
    return json.dumps({**header(number), "agvPosition": position(number, now)}).encode()


def main() -> None:
    port, vehicles = int(sys.argv[1]), int(sys.argv[2])
    client = mqtt.Client(CallbackAPIVersion.VERSION2)
    client.connect("127.0.0.1", port)
    client.loop_start()
    for number in range(vehicles):
        online = json.dumps({**header(number), "connectionState": "ONLINE"}).encode()
        client.publish(f"uagv/v2/KIT/{number}/connection", online, 1, True)
    sent, turn, began = 0, 0, time.monotonic()
    while True:
        # Evenly over each fifth of a second, as vehicles that know nothing of each other are.
        for number in range(vehicles):
            now = time.monotonic()
            base = f"uagv/v2/KIT/{number}"
            client.publish(f"{base}/visualization", visualization(number, now))
            sent += 1
            if turn % VISUALIZATIONS == number % VISUALIZATIONS:
                client.publish(f"{base}/state", state(number, now))
                sent += 1
            due = began + (turn + (number + 1) / vehicles) / VISUALIZATIONS
            if due - now > 0.002:
                time.sleep(due - now)
        turn += 1
        if turn % VISUALIZATIONS == 0:
            print(sent, flush=True)


if __name__ == "__main__":
    main()
