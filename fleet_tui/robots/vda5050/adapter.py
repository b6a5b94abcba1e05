"""The adapter of vehicles of VDA 5050."""

from collections.abc import Iterable, Sequence
from math import inf
from typing import TYPE_CHECKING, assert_never

import msgspec

from fleet_tui.model import commands, events
from fleet_tui.model.kind import CANCEL, CHARGE, CLEAR, ORDER, ORDER_TO, PAUSE, RESUME, Kind
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetUpCommand, StartCharging
from fleet_tui.model.vehicles.vehicle import START_CHARGING, STOP_CHARGING
from fleet_tui.robots.adapter import Feed, Outgoing, Publication, ServiceCall, Site
from fleet_tui.robots.probes import Probe
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.vda5050.orders import (
    BOTH_WAYS,
    NEWEST,
    NeverSeenError,
    action_at,
    cancel,
    instant_action,
    is_charging,
    major_of,
    order,
    seen_of,
)
from fleet_tui.robots.vda5050.settings import VehicleSettings
from fleet_tui.robots.vda5050.topics import INSTANT_ACTIONS, OF_MASTERS, READ, Topics, with_name
from fleet_tui.robots.vda5050.vocabulary import VOCABULARY
from fleet_tui.text.errors import CommandError, WireError
from fleet_tui.text.language import EMPTY, Message

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import StreamValue

OFFLINE_AFTER = 35.0
"""Seconds of silence after which a vehicle is offline: it sends its state at least every 30 s."""
REQUEST = "stateRequest"
REPORTS = ("pose", "battery", "cargo", "paused", "blocked", "queue")
ROLES = {
    "watch": (),
    "pause": (PAUSE, RESUME),
    "master": (ORDER, ORDER_TO, CANCEL, CLEAR, PAUSE, RESUME, CHARGE),
}
"""The requests that each role may make."""


class VehicleAdapter:
    """Vehicles that drive one order of one master control at a time."""

    def __init__(self, profile: Profile, site: Site) -> None:
        self.names = Names(VOCABULARY, profile, site.table)
        self.settings = msgspec.convert(profile.settings.get("vda5050", {}), VehicleSettings)
        self.topics = Topics(self.settings.topic, self.settings.interface)
        self.site = site
        accepts = ROLES[site.role]
        reason = Message("{role_key} is {role}", role_key=site.role_key, role=site.role)
        self.kind = Kind(
            "vda5050",
            REPORTS,
            accepts,
            {"queue": OFFLINE_AFTER, "factsheet": inf, **profile.silence},
            withheld={one: reason for one in ROLES["master"] if one not in accepts},
            offline_after=OFFLINE_AFTER,
            optional=REPORTS,
            reports_ends=True,
            keeps_goals=True,
            takes_stops=True,
            changes_floors=False,
        )

    def vehicle(self, robot: str) -> tuple[str, str]:
        """Return manufacturer and serial number of a robot: the manufacturer is empty for any, the number its
        name if not configured."""
        manufacturer, serial = self.site.vehicles.get(robot, ("", ""))
        return manufacturer, serial or robot

    def owns(self, order_id: str) -> bool:
        """Tell whether a console of this operator on this computer gave an order."""
        return bool(self.site.console) and order_id.endswith(self.site.console)

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        """Return the topics to subscribe to."""
        vehicle = self.vehicle(robot)
        for name in READ:
            address = self.topics.filter(name, *vehicle)
            is_of_masters = name in OF_MASTERS
            yield Feed(
                name,
                (robot,),
                "",
                address,
                f"vda5050/{name}",
                latched=name in ("connection", "factsheet"),
                fast=name == "visualization",
                silent=is_of_masters or name in ("visualization", "factsheet", "connection"),
                queue_length=2,
            )

    def read(self, feed: Feed, msg: object, at: float) -> Iterable[events.Event]:
        """Raise WireError: messages of a broker are read with their topics."""
        raise WireError(f"{feed.address} is no topic of a bridge")

    def stream(self, feed: Feed, msg: object) -> "StreamValue":
        """Raise WireError: such vehicles have no streams."""
        raise WireError(f"{feed.address} is no stream")

    def services(self, robot: str) -> Iterable[tuple[str, str, str]]:
        """Return nothing: a broker has no services."""
        return ()

    def publications(self, robot: str) -> Iterable[tuple[str, str]]:
        """Return nothing: a broker needs no advertisement."""
        return ()

    def probes(self, robot: str) -> Iterable[Probe]:
        """Return nothing: the doctor has checks of its own for brokers."""
        return ()

    def outgoing(
        self, command: commands.Command, command_id: int, robot: Robot, unique: str = ""
    ) -> Sequence[Outgoing]:
        """Return the message of a command, without its header, of a pause for a vehicle of which nothing has
        arrived one for each way to write it. Raises CommandError for one that must not be sent."""
        unique = unique[: -len(self.site.console)] + self.site.console if self.site.console else unique
        return [self._addressed(one, robot) for one in self._messages(command, robot, unique)]

    def state_request(self, robot: Robot, unique: str) -> Sequence[Publication]:
        """Return the messages that ask a vehicle for its state now: by itself it sends one every 30 s. There
        are none if its factsheet lists its actions without that. Raises CommandError."""
        if robot.features is not None and robot.features.instant and REQUEST not in robot.features.instant:
            return ()
        return [self._addressed(one, robot) for one in self._to_unseen(robot, REQUEST, unique)]

    def stop_charging(self, robot: Robot, unique: str) -> Publication | None:
        """Return the message that ends the charging of a vehicle before an order, None if it does not charge
        or its factsheet offers no such instant action. Raises CommandError."""
        if not is_charging(robot) or robot.features is None or STOP_CHARGING not in robot.features.instant:
            return None
        return self._addressed(instant_action(self.settings, robot, STOP_CHARGING, unique), robot)

    def _to_unseen(self, robot: Robot, type_: str, unique: str) -> Sequence[Publication]:
        """Return an instant action, in both ways to write it where nothing of the vehicle has arrived that
        tells which it reads."""
        try:
            return [instant_action(self.settings, robot, type_, unique)]
        except NeverSeenError:
            manufacturer, serial = self.vehicle(robot.name)
            seen = seen_of(robot)
            if not manufacturer and seen is None:
                raise
            if seen is not None:
                topic = with_name(seen.address, INSTANT_ACTIONS)
                topics = dict.fromkeys(BOTH_WAYS, topic)
            else:
                whose = {"manufacturer": manufacturer, "serial": serial}
                topics = {
                    version: self.topics.filter(
                        INSTANT_ACTIONS, **whose, interface=interface, version=f"v{major_of(version)}"
                    )
                    for version, interface in NEWEST.items()
                }
            return [
                action_at(self.settings, topic, version, type_, unique) for version, topic in topics.items()
            ]

    def _addressed(self, message: Publication, robot: Robot) -> Publication:
        """Add whose message it is."""
        address = self.topics.parse(message.address)
        if address is None:
            raise CommandError(
                Message("{address} is not a topic of {name}", address=f"{message.address!r}", name=robot.name)
            )
        whose = {"manufacturer": address.manufacturer, "serialNumber": address.serial}
        return message._replace(message={**whose, **message.message})

    def _messages(self, command: commands.Command, robot: Robot, unique: str) -> Sequence[Publication]:
        match command:
            case commands.PlaceOrder(_, stops):
                return [order(self.settings, self.site.frames, robot, stops, unique)]
            case commands.CancelOrder(_, order_id):
                return [cancel(self.settings, robot, order_id, unique)]
            case commands.ClearOrders():
                return [instant_action(self.settings, robot, "cancelOrder", unique)]
            case commands.PauseRobot():
                return self._to_unseen(robot, "startPause", unique)
            case commands.ResumeRobot():
                return [instant_action(self.settings, robot, "stopPause", unique)]
            case StartCharging():
                return [instant_action(self.settings, robot, START_CHARGING, unique)]
            case SetUpCommand():
                raise CommandError(self.kind.lack(command.ability))
            case _:
                assert_never(command)

    def outcome(
        self, command: commands.Command, values: object, result: bool, status: int | None = None
    ) -> tuple[commands.Stage, Message]:
        """Return an unknown outcome: a broker answers nothing, the vehicle's states do."""
        return commands.Stage.UNKNOWN, EMPTY

    def learned(
        self, call: ServiceCall, values: object, robot: Robot, sent_at: float, at: float
    ) -> Iterable[events.Event]:
        """Return nothing: states report everything."""
        return ()


ADAPTER = VehicleAdapter
