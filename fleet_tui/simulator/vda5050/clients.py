"""Simulated vehicles on a broker: one client each, with a last will of its own."""

import json
import time
from collections.abc import Mapping, Sequence
from itertools import count
from typing import Any

import paho.mqtt.client as mqtt
from paho.mqtt.enums import CallbackAPIVersion

from fleet_tui.simulator.vda5050.messages import MANUFACTURER, factsheet, header, position, state
from fleet_tui.simulator.vda5050.vehicle import SimVehicle

STATE_EVERY = 1.0
"""Seconds between two states without news: a vehicle may take 30."""


class VehicleClient:
    """The connection of one vehicle. Messages arrive on a thread of paho's: `take` keeps them for `step`."""

    def __init__(self, vehicle: SimVehicle, port: int) -> None:
        self.vehicle = vehicle
        self._base = f"uagv/v2/{MANUFACTURER}/{vehicle.name}"
        self._numbers = count()
        self._waiting: list[tuple[str, bytes]] = []
        self._stated_at = self._shown_at = 0.0
        self._client = mqtt.Client(CallbackAPIVersion.VERSION2, clean_session=True)
        will = self._text({"connectionState": "CONNECTIONBROKEN"})
        self._client.will_set(f"{self._base}/connection", will, 1, True)
        self._client.on_message = lambda _client, _data, message: self._waiting.append(
            (message.topic, bytes(message.payload))
        )
        self._client.on_connect = lambda *_: self._announce()
        self._client.connect("127.0.0.1", port, keepalive=15)
        self._client.loop_start()

    def _announce(self) -> None:
        self._client.subscribe([(f"{self._base}/order", 0), (f"{self._base}/instantActions", 0)])
        self._publish("connection", {"connectionState": "ONLINE"}, 1, True)
        self._publish("factsheet", factsheet(), 0, True)

    def _text(self, fields: Mapping[str, Any]) -> str:
        now = time.time()
        stamp = time.strftime("%Y-%m-%dT%H:%M:%S", time.gmtime(now)) + f".{int(now % 1 * 1000):03}Z"
        return json.dumps({**header(self.vehicle, next(self._numbers), stamp), **fields})

    def _publish(self, name: str, fields: Mapping[str, Any], qos: int = 0, retain: bool = False) -> None:
        self._client.publish(f"{self._base}/{name}", self._text(fields), qos, retain)

    def step(self, dt: float, now: float, visualization_every: float) -> None:
        """Take what arrived, drive on, and tell it; `now` is monotonic."""
        waiting, self._waiting = self._waiting, []
        for topic, payload in waiting:
            self._take(topic, payload)
        self.vehicle.step(dt)
        if self.vehicle.silent:
            return
        if self.vehicle.is_news or now - self._stated_at >= STATE_EVERY:
            self.vehicle.is_news = False
            self._stated_at = now
            self._publish("state", state(self.vehicle))
        if now - self._shown_at >= visualization_every:
            self._shown_at = now
            self._publish("visualization", {"agvPosition": position(self.vehicle)})

    def _take(self, topic: str, payload: bytes) -> None:
        try:
            message = json.loads(payload)
            if topic.endswith("/order"):
                self.vehicle.take_order(message)
            else:
                actions: Sequence[Mapping[str, Any]] = message.get("actions") or message["instantActions"]
                for action in actions:
                    self.vehicle.take_action(action)
        except (ValueError, KeyError, TypeError, AttributeError):
            return  # as a vehicle that can't read it

    def close(self) -> None:
        """Sign off."""
        self._publish("connection", {"connectionState": "OFFLINE"}, 1, True)
        self._client.disconnect()
        self._client.loop_stop()
