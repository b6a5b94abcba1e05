"""A real Nav2 without a namespace behind a real bridge, as recorded: what it lists, and its frames."""

import json
from collections.abc import Iterator
from typing import Any

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config, Link
from fleet_tui.config.start import initial_state
from fleet_tui.model.events import GridReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.robots.adapter import Feed, Limit
from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.nav2.discovery import discover
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.reading import FrameReader
from fleet_tui.text.errors import WireError
from tests.support.fleets import LINK, R0, T0, link_up, recording, reduced, tick

DRIVES = ("/navigate_to_pose", "/follow_waypoints")
"""Action servers of the site: its rosapi gave no list of them in time."""


def recorded_site() -> Listed:
    """What rosapi of the real site listed."""
    answers = [json.loads(line["text"]) for line in recording("nav2-rosapi-answers.jsonl.gz")]
    values = {
        one["service"]: one["values"]
        for one in answers
        if one["op"] == "service_response" and "service" in one
    }
    topics, services = values["/rosapi/topics"], values["/rosapi/services"]["services"]
    types = dict(zip(topics["topics"], topics["types"], strict=True))
    return Listed(types, dict.fromkeys(services, ""), DRIVES)


def recorded_config(**topics: str) -> Config:
    """The configuration of the real site, as discovery names everything."""
    found = discover(recorded_site())
    profile = Profile(
        kind="nav2", topics={**found.topics, **topics}, services=found.services, actions=found.actions
    )
    return Config(
        rosbridge=Link("ws://site:9090"),
        floors=[FloorEntry("floor_0")],
        robots=[RobotEntry(R0)],
        profile=profile,
    )


def replayed(name: str, **topics: str) -> Iterator[tuple[float, dict[str, Any], FleetState]]:
    """Each frame that the bridge of the real site sent, by its time, and the state after it."""
    config = recorded_config(**topics)
    adapters = adapters_of(config)
    reader = FrameReader(LINK, Limit(64.0, ""), adapters, feeds_of(config, adapters, LINK), _no_map, print)
    state, ticked = reduced(initial_state(config, T0), link_up(T0)), T0
    for line in recording(f"nav2-{name}.jsonl.gz"):
        at = T0 + line["t"]
        while ticked < at:
            state, ticked = reduced(state, tick(ticked)), ticked + 0.1
        if line["dir"] == "out":
            continue
        read = reader.read(line["text"].encode(), False, at)
        state = reduced(state, *(read if isinstance(read, tuple) else ()), tick(at))
        yield line["t"], json.loads(line["text"]), state


def _no_map(_profile: Profile, _feed: Feed, _payload: bytes) -> GridReceived:
    raise WireError("no map here")
