"""From an address to a configuration: queries rosapi, or listens on a broker; commands, advertises and
publishes nothing."""

import asyncio
import time
from collections.abc import Mapping
from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import cached_property

from fleet_tui.config.entries import DEFAULT_LINK
from fleet_tui.config.load import from_text
from fleet_tui.config.schema import Config, Link
from fleet_tui.links.discovery.approach import Approach
from fleet_tui.links.discovery.choices import Answers, Choice, choices_of, decided, lacks, placed
from fleet_tui.links.discovery.config_text import render
from fleet_tui.links.discovery.facts import RosapiFacts
from fleet_tui.links.discovery.finding import Verdict
from fleet_tui.links.discovery.frames import collect_frames
from fleet_tui.links.discovery.messages import sample_messages
from fleet_tui.links.discovery.questions import Watch, listed_by
from fleet_tui.links.discovery.recognition import Found, assigned, claimed
from fleet_tui.links.discovery.rosapi import look_around
from fleet_tui.links.discovery.tools import rosapi_remedy
from fleet_tui.links.discovery.vehicles import NO_VEHICLE, vehicles_on
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.robots.discovery import Discovery
from fleet_tui.text.errors import ConfigError, FleetError, LinkError
from fleet_tui.text.language import Message

WITHIN = 20.0
"""Seconds that discovery may take."""


@dataclass(frozen=True)
class DiscoveredSite:
    """The site behind a bridge. `claims`: the findings of each kind; `frames` of poses by robot; `answers` of
    a person to its choices. `topics`: their number, for the message when no robot is found; `listened`:
    seconds of listening on a broker."""

    bridge: Link
    claims: Found
    frames: Mapping[str, str]
    topics: int
    answers: Answers = field(default_factory=dict)
    listened: float = 0.0

    @cached_property
    def found(self) -> Found:
        """Return the robots, each of one kind."""
        return decided(self.claims, self.answers)

    @cached_property
    def text(self) -> str:
        """Return a configuration, ready to edit."""
        return render(self.bridge, self.found, self.frames, placed(self.answers))

    @cached_property
    def config(self) -> Config:
        """Return the configuration of this text. Raises FleetError if no robot was found, or names are
        ambiguous."""
        if not any(one.robots for one in self.found.values()) and self.bridge.is_broker:
            raise FleetError(
                Message(
                    "{shown}: no vehicle found: {no_vehicle}", shown=self.bridge.shown, no_vehicle=NO_VEHICLE
                )
            )
        if not any(one.robots for one in self.found.values()):
            raise FleetError(
                Message(
                    "{shown}: no robot found among {topics} topics: start the robot nodes,"
                    " or name their topics: fleet-tui config init --from-live {shown}",
                    shown=self.bridge.shown,
                    topics=self.topics,
                )
            )
        try:
            return from_text(self.text)
        except ConfigError as problem:
            edit = f"edit it in a file: fleet-tui config init --from-live {self.bridge.shown}"
            raise FleetError(
                Message(
                    "{shown}: {problems}; {edit}",
                    shown=self.bridge.shown,
                    problems=problem.problems[0],
                    edit=edit,
                )
            ) from None

    @property
    def choices(self) -> list[Choice]:
        """Return the choices with other options."""
        return choices_of(self.claims, self.found, self.frames, self.answers)

    @property
    def unclear(self) -> list[str]:
        """Return robots that need a person's confirmation before commands: those would be in another kind's
        format."""
        how = f"fleet-tui {self.bridge.shown} to choose, then :save"
        return [f"nothing sent: {choice}: {how}" for choice in self.choices if choice.id[0] == "kind"]

    @property
    def warnings(self) -> list[str]:
        """Return the uncertain and missing settings."""
        return [*map(str, self.choices), *self.lacks]

    @property
    def lacks(self) -> list[str]:
        """Return the missing settings, in sentences."""
        return lacks(self.found)

    @property
    def summary(self) -> str:
        """Return the number of robots of each kind and of floors."""
        kinds = {kind: len(one.robots) for kind, one in self.found.items()}
        of = ", ".join(kinds if len(kinds) == 1 else (f"{count} {kind}" for kind, count in kinds.items()))
        robots, floors = sum(kinds.values()), len(self.config.floors)
        return f"{robots} robot{'s' * (robots != 1)} ({of}), {floors} floor{'s' * (floors != 1)}"


def unwatched(_done: int, _total: int, _doing: str) -> None:
    """Ignore progress."""


def start_discovery(
    bridge: Link, timeout: float = WITHIN, watch: Watch = unwatched, wait: float = 0.0
) -> Future[DiscoveredSite]:
    """Discover the site behind a bridge, with at least `wait` seconds of listening on a broker; `watch` is
    called on another thread.

    The result raises LinkError if it can't be reached, FleetError if rosapi fails.
    """
    until = time.monotonic() + max(timeout, wait)
    if bridge.is_broker:
        return asyncio.run_coroutine_threadsafe(
            _discover_vehicles(bridge, until, watch, wait), network_loop()
        )
    return asyncio.run_coroutine_threadsafe(_discover(bridge, until, watch), network_loop())


async def _discover_vehicles(bridge: Link, until: float, watch: Watch, wait: float) -> DiscoveredSite:
    began = time.monotonic()
    vehicles, topics = await vehicles_on(bridge, until, wait, watch)
    found = Discovery({name: [] for name in vehicles})
    found.vehicles = {name: (one.manufacturer, one.serial) for name, one in vehicles.items()}
    frames = {name: one.maps[0] for name, one in vehicles.items() if one.maps}
    return DiscoveredSite(bridge, {"vda5050": found}, frames, topics, listened=time.monotonic() - began)


async def _discover(bridge: Link, until: float, watch: Watch) -> DiscoveredSite:
    wire = BridgeConnection(bridge)
    try:
        watch(0, 0, Message("connecting"))
        async for finding in Approach(DEFAULT_LINK, bridge, wire, "the address").walk():
            if finding.verdict is Verdict.FAIL:
                raise LinkError(
                    Message(
                        "{shown}: {measured}: {remedy}",
                        shown=bridge.shown,
                        measured=finding.measured,
                        remedy=finding.remedy,
                    )
                )
        watch(0, 0, Message("querying rosapi"))
        rosapi = await look_around(wire)
        if rosapi.problem:
            raise FleetError(
                Message(
                    "{shown}: {without_rosapi}", shown=bridge.shown, without_rosapi=_without_rosapi(rosapi)
                )
            )
        listed, rosapi = await listed_by(wire, rosapi, until, watch)
        watch(0, 0, Message("waiting for messages"))
        listed = listed._replace(messages=await sample_messages(wire, rosapi.topics, until))
        claims = claimed(listed)
        watch(0, 0, Message("waiting for poses"))
        frames = await collect_frames(wire, assigned(claims, {}), rosapi.topics, until)
    finally:
        wire.close()
    return DiscoveredSite(bridge, claims, frames, len(rosapi.topics))


def _without_rosapi(rosapi: RosapiFacts) -> str:
    # A bridge whose ROS thread has ended is told apart by its own node alone, which is not asked here.
    half_dead = "; if it runs, restart rosbridge: it may be half dead" if rosapi.is_silent else ""
    remedy = f"{rosapi_remedy(rosapi)}{half_dead}; or edit an example (fleet-tui config init)"
    return f"discovery needs rosapi: {rosapi.problem}: {remedy}"
