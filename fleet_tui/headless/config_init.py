"""`fleet-tui config init`: a configuration to start from, made of what a bridge has."""

import asyncio
import json
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import msgspec

from fleet_tui.adapters.profile import Profile
from fleet_tui.config.check import NAME, checked
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.load import shipped
from fleet_tui.config.schema import DEFAULT_LINK, Config, Link, RobotEntry
from fleet_tui.errors import ConfigError, FleetError, LinkError
from fleet_tui.headless.doctor.approach import Approach
from fleet_tui.headless.doctor.causes import rosapi_remedy
from fleet_tui.headless.doctor.facts import Rosapi
from fleet_tui.headless.doctor.finding import Verdict
from fleet_tui.headless.doctor.listening import listen
from fleet_tui.headless.doctor.rosapi import ask_publishers, ask_services, look_around
from fleet_tui.headless.doctor.wire import Wire
from fleet_tui.headless.site import Site, site_of
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
    site, frames = work.result()
    return render(config.bridge(DEFAULT_LINK), site, frames)


async def _ask(config: Config, until: float) -> tuple[Site, dict[str, str]]:
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
    site = site_of(published, {name: rosapi.services[name] or "" for name in services})
    return site, await _frames(config.bridge(DEFAULT_LINK), site, rosapi, until)


async def _frames(bridge: Link, site: Site, rosapi: Rosapi, until: float) -> dict[str, str]:
    """The frame_id of each robot's poses, of those that speak."""
    config = Config(robots=[RobotEntry(robot) for robot in site.robots], profile=Profile(topics=site.topics))
    adapters = adapters_of(config)
    poses = [one for one in feeds_of(config, adapters, DEFAULT_LINK) if one.fast]
    heard = await listen(bridge, adapters, poses, rosapi, until)
    events = [facts.event for facts in heard.topics]
    return {one.robot: one.frame_id.lstrip("/") for one in events if isinstance(one, PoseReported)}


def render(bridge: Link, site: Site, frames: dict[str, str]) -> str:
    """The configuration as text, ready to edit."""
    lines = [
        "# fleet-tui: what was found behind this bridge. `fleet-tui check` says what is wrong with it.",
        "",
    ]
    lines += ["[rosbridge]", *_differing(bridge)]
    lines += ["", *_floors(site, frames)]
    for robot, floors in site.robots.items():
        lines += ["[[robots]]", f"name = {_text(robot)}"]
        lines += [f"floors = {_text(floors)}"] if floors and floors != site.floors else []
        lines += ["# size = [0.9, 0.6]           # length, width in metres", ""]
    if not site.robots:
        lines += [
            "# No topic looks like a robot's. Give their names, and in [profile.topics] how theirs are named."
        ]
        lines += ["[[robots]]", 'name = "robot_0"', ""]
    tables = {"topics": site.topics, "types": site.types, "services": site.services}
    tables["service_types"] = site.service_types
    for table, entries in tables.items():
        notes = site.notes.get(table, []) if site.robots else []
        if entries or notes:
            lines += [f"[profile.{table}]", *_table(entries), *(f"# {note}" for note in notes), ""]
    return "\n".join(lines).rstrip() + "\n"


def _text(value: object) -> str:
    """A string or a list of them, as TOML: JSON's are TOML's too, but for DEL."""
    return json.dumps(value).replace("\x7f", "\\u007f")


def _table(entries: dict[str, str]) -> Iterator[str]:
    return (f"{key} = {_text(value)}" for key, value in entries.items())


def _differing(bridge: Link) -> Iterator[str]:
    """What of a bridge is not as by default, the address always."""
    usual = Link()
    for name in bridge.__struct_fields__:
        value = getattr(bridge, name)
        if name == "url" or value != getattr(usual, name):
            yield f"{name} = {_text(value)}"


def _floors(site: Site, frames: dict[str, str]) -> Iterable[str]:
    """Each floor, with the frame in which poses on it come, as far as that can be told."""
    floors, lines = site.floors, list[str]()
    strange = sorted(set(frames.values()) - set(floors) - {""})
    if not floors:
        lines.append("# No topic is a floor's: these are named after the frames of the poses.")
        floors, strange = [one for one in strange if NAME.fullmatch(one)] or ["floor_0"], []
    for floor in floors:
        lines += ["[[floors]]", f"name = {_text(floor)}"]
        if len(floors) == 1 and len(strange) == 1:
            lines.append(f"frame_id = {_text(strange[0])}")
        live = "the live map is shown; a file is" if floor in site.live_maps else "no live map is there:"
        lines += [f'# map = "maps/{floor}.yaml"   # {live} map_server YAML, or a plain PNG/PGM', ""]
    if strange and len(floors) > 1:
        lines += [
            f"# Poses come in frame {_text(one)} too: give it to its floor as frame_id." for one in strange
        ]
        lines.append("")
    return lines


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
