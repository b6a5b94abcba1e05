"""The vehicles on a broker: found by their connection topics, which it keeps; their maps by their poses."""

import asyncio
import time
from collections.abc import Callable, Iterable, Mapping, Sequence

from msgspec.structs import replace

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.links.discovery.config_text import BROKER, UNKNOWN_FLOOR, floor_name
from fleet_tui.links.discovery.questions import Watch
from fleet_tui.links.transports.mqtt.connection import BrokerConnection
from fleet_tui.robots.vda5050.discovery import SeenVehicle, has_header, named
from fleet_tui.robots.vda5050.fields import Fields
from fleet_tui.robots.vda5050.state import pose_of
from fleet_tui.robots.vda5050.topics import Topics
from fleet_tui.text.errors import LinkError, WireError
from fleet_tui.text.language import Message

LISTENED = ("connection", "state", "visualization")
STATE_EVERY = 30.0
"""Seconds within which a vehicle sends its state, by the standard."""
NO_VEHICLE = (
    "no message of a vehicle (+/+/+/+/connection, .../state): start the vehicles, check the user's read"
    " access, or listen longer: fleet-tui config init --from-live ADDRESS --wait 35"
)
WATCH_EVERY = 2.0
"""Seconds between looks for further vehicles: each time the recordings begin anew."""
MOST_VEHICLES = 1000
MOST_FLOORS = 50
"""Beyond these a program makes up names."""
SETTLED = 2.0
"""Seconds without a further vehicle after which all are taken to be there: what the broker has kept comes at
once, and most send a state each second. A vehicle whose connection is not kept may be silent for 30 s."""


class VehicleListener:
    """Collects the vehicles on a broker. Runs on the network loop."""

    def __init__(self, bridge: Link, names: Sequence[str] = LISTENED) -> None:
        """`names` of the topics to listen to."""
        self._names = names
        self.topics = Topics()
        self.connection = BrokerConnection(bridge, self)
        self.seen: dict[tuple[str, str], str] = {}
        """Version by manufacturer and serial number."""
        self.maps: dict[tuple[str, str], str] = {}
        self.heard = set[str]()
        self.newest_at = time.monotonic()
        """When the last vehicle was found."""
        self.opened: asyncio.Future[str] = asyncio.get_running_loop().create_future()
        """The reason that the broker can't be reached, empty if it is."""
        self.refused = set[str]()

    @property
    def vehicles(self) -> list[SeenVehicle]:
        """Return the vehicles so far."""
        return [
            SeenVehicle(*vehicle, version, (self.maps[vehicle],) if self.maps.get(vehicle) else ())
            for vehicle, version in self.seen.items()
        ]

    def on_connecting(self) -> None:
        """Do nothing: an attempt has begun."""

    def on_open(self) -> None:
        """Subscribe to the topics of all vehicles."""
        self.connection.subscribe([self.topics.filter(name) for name in self._names])
        self._decide("")

    def on_lost(self, reason: str, next_try_in: float) -> None:
        """Take the reason that there is no connection."""
        self._decide(reason or "connection lost")

    def _decide(self, reason: str) -> None:
        if not self.opened.done():
            self.opened.set_result(reason)

    def on_message(self, topic: str, payload: bytes, retained: bool) -> None:
        """Note whose topic it is, and the map of a pose."""
        self.heard.add(topic)
        address = self.topics.parse(topic)
        if address is None or address.name not in self._names:
            return
        try:
            message = Fields.of(payload)
        except WireError:
            return
        if not has_header(message):
            return
        vehicle = address.manufacturer, address.serial
        if vehicle not in self.seen:
            self.newest_at = time.monotonic()
        self.seen[vehicle] = message.text("version") or self.seen.get(vehicle, "")
        found = pose_of(message)
        if found is not None:
            self.maps[vehicle] = found[1]

    def on_subscribed(self, pattern: str, granted: bool) -> None:
        """Note what this user must not read."""
        if not granted:
            self.refused.add(pattern)

    def on_answer(self, seconds: float) -> None:
        """Do nothing: the broker lives."""

    def on_sent(self, topic: str, payload: bytes) -> None:
        """Do nothing: nothing is sent."""

    def on_too_large(self, topic: str, size: int) -> None:
        """Do nothing: no vehicle is found by such a message."""


async def vehicles_on(
    bridge: Link, until: float, wait: float, watch: Watch
) -> tuple[Mapping[str, SeenVehicle], int]:
    """Return the vehicles on a broker by the names of their robots, and the number of topics heard. Listens
    for at least `wait` seconds, and as long as further ones are found or there are none, but not after
    `until` (monotonic). Raises LinkError."""
    listener = VehicleListener(bridge)
    listener.connection.connect()
    try:
        reason = await asyncio.wait_for(asyncio.shield(listener.opened), max(0.1, until - time.monotonic()))
        if reason:
            raise LinkError(Message("{shown}: {reason}", shown=bridge.shown, reason=reason))
        began = listener.newest_at = time.monotonic()
        while (now := time.monotonic()) < until and not (listener.refused and not listener.seen):
            if listener.seen and now >= max(began + wait, listener.newest_at + SETTLED):
                break
            watch(0, 0, Message("waiting for vehicles, {count} so far", count=len(listener.seen)))
            await asyncio.sleep(0.05)
    except TimeoutError:
        raise LinkError(Message("{shown}: connection timed out", shown=bridge.shown)) from None
    finally:
        listener.connection.shut()
    if not listener.seen and listener.refused:
        raise LinkError(
            Message(
                "{shown}: broker refuses {sorted}: grant read access",
                shown=bridge.shown,
                sorted=", ".join(sorted(listener.refused)),
            )
        )
    return named(listener.vehicles), len(listener.heard)


async def watch_vehicles(bridge: Link, take: Callable[[Sequence[SeenVehicle]], None]) -> None:
    """Pass all vehicles on a broker on whenever there is a further one, or one is on another map, until this
    is cancelled. `take` is called in a thread of its own."""
    listener = VehicleListener(bridge, ("connection", "state"))
    listener.connection.connect()
    passed = list[SeenVehicle]()
    try:
        while True:
            await asyncio.sleep(WATCH_EVERY)
            if (vehicles := listener.vehicles) != passed:
                passed = vehicles
                await asyncio.to_thread(take, vehicles)
    finally:
        listener.connection.shut()


def with_vehicles(config: Config, vehicles: Iterable[SeenVehicle]) -> Config:
    """Return a discovered configuration with those vehicles that it lacks, and with their maps as floors: the
    first is that of the floor whose map was not known."""
    known = {(robot.manufacturer, robot.serial) for robot in config.robots}
    further = named((one for one in vehicles if one[:2] not in known), [one.name for one in config.robots])
    robots = [
        RobotEntry(name, link=BROKER, manufacturer=one.manufacturer, serial=one.serial)
        for name, one in further.items()
    ]
    floors = list(config.floors)
    for map_id in sorted({map_id for one in vehicles for map_id in one.maps}):
        if map_id in [floor.frame for floor in floors] or len(floors) >= MOST_FLOORS:
            continue
        if floors == [FloorEntry(UNKNOWN_FLOOR)]:
            floors = [FloorEntry(UNKNOWN_FLOOR, frame_id=map_id)]
            continue
        taken = [floor.name for floor in floors]
        name = floor_name(map_id, len(floors))
        floors.append(FloorEntry(name if name not in taken else f"{name}_{len(floors)}", frame_id=map_id))
    room = max(0, MOST_VEHICLES - len(config.robots))
    return replace(config, robots=[*config.robots, *robots[:room]], floors=floors)
