"""`fleet-tui config init`: a configuration to start from, made of what a bridge has."""

import asyncio
import time
from collections.abc import Callable
from pathlib import Path

import msgspec

from fleet_tui.adapters.discovery import Listed
from fleet_tui.adapters.profile import Profile
from fleet_tui.config.check import checked
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.load import shipped
from fleet_tui.config.schema import DEFAULT_LINK, Config, Link, RobotEntry
from fleet_tui.discovery.approach import Approach
from fleet_tui.discovery.config_text import render
from fleet_tui.discovery.facts import Rosapi
from fleet_tui.discovery.finding import Verdict
from fleet_tui.discovery.recognition import Found, discover
from fleet_tui.discovery.rosapi import ask_publishers, ask_services, look_around
from fleet_tui.discovery.tools import rosapi_remedy
from fleet_tui.discovery.wire import Wire
from fleet_tui.errors import ConfigError, FleetError, LinkError
from fleet_tui.headless.doctor.listening import listen
from fleet_tui.model.events import PoseReported
from fleet_tui.transports.loop import network_loop

OURS = ("/rosapi/", "/rosbridge_")


def example() -> str:
    """The configuration that comes with the program."""
    return shipped().read_text(encoding="utf-8")


def from_live(known: Config, url: str, timeout: float) -> str:
    """A configuration for what is behind the bridge at `url`, which is reached as `known` says.

    Raises ConfigError for an address that is none, LinkError where there is no way, FleetError
    where rosapi does not tell.
    """
    bridge = msgspec.structs.replace(known.rosbridge, url=url)
    config = Config(rosbridge=bridge, robots=[RobotEntry("robot")], path=known.path)
    wrong = [line for line in checked(config) if line.startswith(DEFAULT_LINK)]
    if wrong:
        raise ConfigError(wrong)
    work = asyncio.run_coroutine_threadsafe(_ask(config, time.monotonic() + timeout), network_loop())
    found, frames = work.result()
    return render(config.bridge(DEFAULT_LINK), found, frames)


async def _ask(config: Config, until: float) -> tuple[Found, dict[str, str]]:
    wire = Wire(config.bridge(DEFAULT_LINK))
    try:
        async for finding in Approach(DEFAULT_LINK, config.bridge(DEFAULT_LINK), wire).walk():
            if finding.verdict is Verdict.FAIL:
                raise LinkError(f"{finding.check}: {finding.measured} -> {finding.remedy}")
        rosapi = await look_around(wire)
        if rosapi.problem:
            remedy = f"{rosapi_remedy(rosapi)}; or edit an example (fleet-tui config init)"
            raise FleetError(f"it is rosapi that tells what is there: {rosapi.problem}: {remedy}")
        services = [name for name in rosapi.services if not name.startswith(OURS)]
        rosapi = await ask_publishers(wire, rosapi, rosapi.topics, until)
        rosapi = await ask_services(wire, rosapi, services, until)
    finally:
        wire.close()
    published = {name: type_ for name, type_ in rosapi.topics.items() if rosapi.has(name)}
    typed = {name: rosapi.services[name] or "" for name in services}
    found = discover(Listed(published, typed, rosapi.actions))
    return found, await _frames(config.bridge(DEFAULT_LINK), found, rosapi, until)


async def _frames(bridge: Link, found: Found, rosapi: Rosapi, until: float) -> dict[str, str]:
    """The frame_id of each robot's poses, of those that speak and whose frames mean floors."""
    profiles = {kind: Profile(kind=kind, topics=one.topics) for kind, one in found.items()}
    robots = [RobotEntry(robot, profile=kind) for kind, one in found.items() for robot in one.robots]
    config = Config(robots=robots, profiles=profiles)
    adapters = adapters_of(config)
    poses = [
        one
        for one in feeds_of(config, adapters, DEFAULT_LINK)
        if one.fast and adapters[one.robot].kind.frames_are_floors
    ]
    heard = await listen(bridge, adapters, poses, rosapi, until)
    events = [facts.event for facts in heard.topics]
    return {one.robot: one.frame_id.lstrip("/") for one in events if isinstance(one, PoseReported)}


def write(text: str, output: str, force: bool, say: Callable[[str], None]) -> None:
    """Print it, or write it to a file that is not there yet. Raises FleetError."""
    if not output:
        say(text.rstrip("\n"))
        return
    try:
        with Path(output).expanduser().open("w" if force else "x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError:
        raise FleetError(f"{output} is there already: --force writes over it") from None
    except OSError as problem:
        raise FleetError(f"{output}: {problem.strerror}") from None
