"""Checks of a well-formed configuration."""

from collections import Counter
from collections.abc import Iterator

from fleet_tui.adapters.discovery import NAME
from fleet_tui.config.check_links import check_links
from fleet_tui.config.check_profiles import check_profiles
from fleet_tui.config.entries import DEFAULT_LINK
from fleet_tui.config.programs import check_programs
from fleet_tui.config.schema import Alarms, Config, Notify
from fleet_tui.errors import did_you_mean
from fleet_tui.keymap import keymap
from fleet_tui.model.alarm import Priority
from fleet_tui.rules.alarms.classes import CLASSES

PRIORITIES = [priority.name.lower() for priority in Priority]


def checked(config: Config) -> list[str]:
    """Return one line for each problem that only the whole configuration shows."""
    return [
        *check_links(config),
        *_names("floors", [floor.name for floor in config.floors]),
        *_names("robots", [robot.name for robot in config.robots]),
        *_frames(config),
        *_references(config),
        *check_profiles(config),
        *keymap(config.keys)[1],
        *_alarms(config.alarms),
        *_notify(config.notify),
        *check_programs(config.programs),
    ]


EMPTY = ": empty: add "
"""The problem of a configuration without robots or floors."""


def missing_files(config: Config) -> list[str]:
    """Return one line for each missing file of a floor. The console starts without them, and reports it."""
    return [
        f"floors[{n}].{key}: file not found: {name}"
        for n, floor in enumerate(config.floors)
        for key, name in (("map", floor.map), ("graph", floor.graph))
        if name and not config.beside(name).is_file()
    ]


def _names(where: str, names: list[str]) -> Iterator[str]:
    if not names:
        yield f"{where}{EMPTY}[[{where}]] with a name"
    for n, name in enumerate(names):
        if not NAME.fullmatch(name):
            yield f"{where}[{n}].name: {name!r} is not a ROS name: use letters, digits and _ only"
    for name, count in Counter(names).items():
        if count > 1:
            yield f"{where}: name {name} used {count} times"


def _frames(config: Config) -> Iterator[str]:
    names_of: dict[str, dict[str, None]] = {}
    for floor in config.floors:
        names_of.setdefault(floor.frame, {})[floor.name] = None
    for frame, names in names_of.items():
        if len(names) > 1:
            yield f"floors: frame_id {frame} used by {' and '.join(names)}: poses would be ambiguous"


def _references(config: Config) -> Iterator[str]:
    floors = {floor.name for floor in config.floors}
    links = {DEFAULT_LINK, *config.links}
    for n, robot in enumerate(config.robots):
        for floor in robot.floors:
            if floor not in floors:
                yield f"robots[{n}].floors: unknown floor {floor!r}{did_you_mean(floor, floors)}"
        if robot.link not in links:
            yield f"robots[{n}].link: unknown link {robot.link!r}{did_you_mean(robot.link, links)}"


def _alarms(alarms: Alarms) -> Iterator[str]:
    if alarms.battery_critical > alarms.battery_low:
        yield "alarms.battery_critical: must not be above battery_low"
    if alarms.battery_low + alarms.battery_band > 100:
        yield "alarms.battery_band: battery_low and battery_band together must not be above 100"
    for name in alarms.latched:
        if name not in CLASSES:
            near = did_you_mean(name, CLASSES) or f", there are {', '.join(CLASSES)}"
            yield f"alarms.latched: no class {name!r}{near}"
    for key, given in (("bell", alarms.bell), ("notify", alarms.notify)):
        for name in given:
            if name not in PRIORITIES:
                near = did_you_mean(name, PRIORITIES) or f", use {', '.join(PRIORITIES)}"
                yield f"alarms.{key}: unknown priority {name!r}{near}"


def _notify(notify: Notify) -> Iterator[str]:
    known = [*PRIORITIES, *CLASSES]
    for name in notify.classes:
        if name not in known:
            near = did_you_mean(name, known) or f", use {', '.join(known)}"
            yield f"notify.classes: no priority or class {name!r}{near}"
    if notify.command and not notify.command[0]:
        yield "notify.command: begins with the name of a program"
