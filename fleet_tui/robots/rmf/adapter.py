"""The adapter of robots in fleets of Open-RMF."""

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, assert_never

from fleet_tui.model import commands, events, kind
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.robots.adapter import Feed, Outgoing, ServiceCall, Site
from fleet_tui.robots.probes import Probe
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.rmf import facilities, requests
from fleet_tui.robots.rmf.answers import read_dispatches, read_responses
from fleet_tui.robots.rmf.fleets import Read, read_fleets, read_statuses
from fleet_tui.robots.rmf.graphs import read_graphs
from fleet_tui.robots.rmf.probes import probes
from fleet_tui.robots.rmf.tasks import read_tasks
from fleet_tui.robots.rmf.vocabulary import VOCABULARY
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.errors import CommandError, WireError
from fleet_tui.text.language import Message

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import StreamValue

EACH = 100
"""Messages that a bridge keeps for this console: each is of another fleet or task."""
LATCHED = frozenset({"statuses", "tasks", "graphs", "lanes"})
ON_CHANGE = frozenset({"tasks", "responses", "dispatches", *facilities.READERS})
REPORTS = {
    "fleets": ("pose", "battery", "member"),
    "statuses": ("pose", "battery", "member"),
    "tasks": ("queue", "paused", "progress"),
    "graphs": ("graph", "labels"),
    "building": ("map",),
}
"""The values in each topic."""
ABILITIES = (kind.ORDER, kind.ORDER_TO, kind.ORDER_ANY, kind.CANCEL, kind.CLEAR, kind.PAUSE, kind.RESUME)
SILENCE = dict.fromkeys(("queue", "paused", "progress"), math.inf)


class Rmf:
    """Robots that take tasks from a dispatcher: all topics are those of the whole site."""

    def __init__(self, profile: Profile, site: Site) -> None:
        self.names = names = Names(VOCABULARY, profile, site.table)
        self._readers: dict[str, Read] = {
            "fleets": read_fleets(),
            "statuses": read_statuses(),
            "tasks": read_tasks(),
            "responses": read_responses(),
            "dispatches": read_dispatches(),
            "graphs": read_graphs(),
            **{key: make() for key, make in facilities.READERS.items()},
        }
        reported = [value for key, values in REPORTS.items() if names.topic(key, "") for value in values]
        self.kind = kind.Kind(
            "rmf",
            tuple(dict.fromkeys(reported)),
            ABILITIES if names.topic("requests", "") else (),
            {**SILENCE, **names.profile.silence},
            dict.fromkeys(() if names.topic("requests", "") else ABILITIES, f"{site.table}.topics.requests"),
            reports_ends=True,
            takes_stops=True,
            spares_others=True,
            names_places=True,
            is_told_changes=True,
        )

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        """Return the topics to subscribe to. Never throttled: one message would hide another's."""
        for key in self._readers:
            if topic := self.names.topic(key, robot):
                yield Feed(
                    key,
                    (robot,),
                    "",
                    topic,
                    self.names.type(key),
                    latched=key in LATCHED,
                    silent=key in ON_CHANGE,
                    is_shared=True,
                    queue_length=EACH,
                )
        if topic := self.names.topic("building", robot):
            # Other stacks publish an OccupancyGrid by that name: the link compares the types.
            pictures = Feed("building", (robot,), "", topic, self.names.type("building"), latched=True)
            yield pictures._replace(silent=True, wanted_for="map", is_shared=True, has_pictures=True)

    def read(self, feed: Feed, msg: object, at: float) -> Iterable[events.Event]:
        """Return the events of a message. Raises WireError."""
        return self._readers[feed.key](frozenset(feed.robots), msg, at)

    def stream(self, feed: Feed, msg: object) -> "StreamValue":
        """Such robots have no streams. Raises WireError."""
        raise WireError(f"{feed.address} is no stream")

    def services(self, robot: str) -> Iterable[tuple[str, str, str]]:
        """Return nothing: requests are messages."""
        return ()

    def publications(self, robot: str) -> Iterable[tuple[str, str]]:
        """Return the topic of requests."""
        topic = self.names.topic("requests", robot)
        return ((topic, self.names.type("requests")),) if topic else ()

    def probes(self, robot: str) -> Iterable[Probe]:
        """Return the checks of its fleet."""
        return probes(self.names)

    def outgoing(
        self, command: Command, command_id: int, robot: Robot, unique: str = ""
    ) -> Sequence[Outgoing]:
        """Return the messages of a command. Raises CommandError for one that must not be sent."""
        names = self.names
        match command:
            case commands.PlaceOrder():
                return requests.order(names, robot, command, unique)
            case commands.CancelOrder(_, order_id):
                return requests.cancel(names, [order_id], unique)
            case commands.ClearOrders():
                return requests.cancel(names, requests.own_tasks(robot), unique)
            case commands.PauseRobot():
                return requests.interrupt(names, robot, unique)
            case commands.ResumeRobot():
                return requests.resume(names, robot, unique)
            case SetUpCommand():
                raise CommandError(self.kind.lack(command.ability))
            case _:
                assert_never(command)

    def outcome(
        self, command: Command, values: object, result: bool, status: int | None = None
    ) -> tuple[Stage, Message]:
        """Return the stage for an answer to a call: there are none."""
        return Stage.UNKNOWN, Message("unrecognised reply")

    def learned(
        self, call: ServiceCall, values: object, robot: Robot, sent_at: float, at: float
    ) -> Iterable[events.Event]:
        """Return nothing: topics report everything."""
        return ()


ADAPTER = Rmf
