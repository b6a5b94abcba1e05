"""Checks of a well-formed configuration."""

import math
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from urllib.parse import urlsplit

import msgspec

from fleet_tui.config.entries import DEFAULT_LINK
from fleet_tui.config.fleet import OF_BROKERS, adapters_of, profile_of, shared_steering, shared_topics
from fleet_tui.config.programs import check_programs
from fleet_tui.config.schema import SECRETS, Alarms, Config, Link, Notify, link_key
from fleet_tui.keys.keymap import keymap
from fleet_tui.model.alarm import Priority
from fleet_tui.robots.discovery import NAME
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS, kind_of
from fleet_tui.robots.ros.names import Vocabulary
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.situation.alarms.classes import CLASSES
from fleet_tui.text.errors import did_you_mean

PRIORITIES = [priority.name.lower() for priority in Priority]


FOR_WEB_SOCKETS = ("authorization", "rosauth"), "authorization_file to a file with `Basic ...`"
FOR_BROKERS = ("user", "password"), "user_file and password_file to private files"
OF_SCHEMES = {"ws": FOR_WEB_SOCKETS, "wss": FOR_WEB_SOCKETS, "mqtt": FOR_BROKERS, "mqtts": FOR_BROKERS}
"""Secrets that a server of each scheme takes, and the remedy for others."""
TLS_OF = {"ws": "wss", "mqtt": "mqtts"}


TAKE_FIELDS = ("std_srvs/SetBool", "nav2_msgs/ManageLifecycleNodes", "lifecycle_msgs/ChangeState")
"""Types of services on which `{}`, all that a pause sends, is a command of its own: to start, to resume."""


EMPTY = ": empty: add "
"""The problem of a configuration without robots or floors."""


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


def check_links(config: Config) -> Iterator[str]:
    """Yield one line for each problem of a link."""
    if DEFAULT_LINK in config.links:
        yield f"links.{DEFAULT_LINK}: name reserved for [rosbridge], choose another"
    for name, link in {**config.links, DEFAULT_LINK: config.rosbridge}.items():
        for problem in _link(link):
            yield f"{link_key(name)}.{problem}"


_HOST = re.compile(r"[\w.-]+|[0-9a-fA-F:.]+")
"""A name, also one with umlauts, or an address; no `${HOST}`, which nothing here replaces, and no zone."""


def _link(link: Link) -> Iterator[str]:
    try:
        parts = urlsplit(link.url)
        host = parts.hostname or ""
        fine = parts.scheme in OF_SCHEMES and bool(_HOST.fullmatch(host)) and parts.port != 0
    except ValueError:
        fine = False
    if not fine or parts.fragment:
        yield f"url: {link.shown!r} is not an address, expected e.g. ws://HOST:9090 or mqtt://HOST"
        return
    if "@" in parts.netloc:
        yield f"url: user and password not allowed: set {OF_SCHEMES[link.scheme][1]}"
    if link.is_broker and parts.path.strip("/") + parts.query:
        yield f"url: {link.shown!r} has a path: a broker has none, remove it"
    if link.role != "watch" and not link.is_broker:
        yield f"role: {link.scheme}:// has no roles, only a broker has them"
    yield from _tls(link)
    yield from _secrets(link)


def _tls(link: Link) -> Iterator[str]:
    if not link.is_secure:
        for key in ("ca_file", "client_cert", "client_key"):
            if getattr(link, key):
                yield f"{key}: {link.scheme}:// has no TLS, use {TLS_OF[link.scheme]}:// in the url"
    if link.client_key and not link.client_cert:
        yield "client_key: needs client_cert"


def _secrets(link: Link) -> Iterator[str]:
    own, remedy = OF_SCHEMES[link.scheme]
    for key in SECRETS:
        given = [name for name in (f"{key}_env", f"{key}_file") if getattr(link, name)]
        if len(given) > 1:
            yield f"{key}_file: use {key}_file or {key}_env, not both"
        elif given and key not in own:
            yield f"{given[0]}: not for {link.scheme}://, set {remedy}"
    if (link.password_file or link.password_env) and not (link.user_file or link.user_env):
        yield "password_file: needs user_file or user_env"


def check_profiles(config: Config) -> Iterator[str]:
    """Yield one line for each problem of a profile, or of a reference to one."""
    problems = [*_named(config), *_profile("profile", config.profile)]
    for name, profile in config.profiles.items():
        problems += _profile(f"profiles.{name}", profile)
    yield from problems
    if not problems:
        known = {DEFAULT_LINK, *config.links}
        robots = [
            robot for robot in config.robots if robot.link in known and _is_known(config, robot.profile)
        ]
        config = msgspec.structs.replace(config, robots=robots)
        adapters = adapters_of(config)
        yield from shared_topics(config, adapters)
        yield from shared_steering(config, adapters)


def _is_known(config: Config, name: str) -> bool:
    return not name or name in config.profiles or name in KINDS


def _named(config: Config) -> Iterator[str]:
    links = {DEFAULT_LINK: config.rosbridge, **config.links}
    named = [(f"{link_key(name)}.profile", link.profile) for name, link in links.items()]
    named += [(f"robots[{n}].profile", robot.profile) for n, robot in enumerate(config.robots)]
    yield from _transports(config, links)
    for where, name in named:
        if not _is_known(config, name):
            yield f"{where}: unknown kind or profile {name!r}{did_you_mean(name, [*config.profiles, *KINDS])}"


def _transports(config: Config, links: Mapping[str, Link]) -> Iterator[str]:
    """Check that the kind of each robot is one of its link's transport."""
    for n, robot in enumerate(config.robots):
        if robot.link not in links or not _is_known(config, robot.profile or links[robot.link].profile):
            continue
        kind = kind_of(profile_of(config, robot)[1])
        link = links[robot.link]
        if kind in KINDS and (kind == OF_BROKERS) != link.is_broker:
            where = f"{link_key(robot.link)}, which is {link.scheme}://"
            yield f"robots[{n}]: kind {kind} on {where}: correct the profile or the link"
        for key in ("manufacturer", "serial"):
            if set(getattr(robot, key)) & set("/+#\0"):
                yield f"robots[{n}].{key}: a level of a topic has no / + or #"


def _profile(where: str, profile: Profile) -> Iterator[str]:
    if profile.name and profile.kind and profile.name != profile.kind:
        yield f"{where}.name: {profile.name!r} and kind {profile.kind!r} are the same setting: remove one"
    kind = kind_of(profile)
    if kind not in KINDS:
        key = "kind" if profile.kind else "name"
        yield f"{where}.{key}: unknown kind {kind!r}{did_you_mean(kind, KINDS)}"
        return
    known = KINDS[kind].vocabulary
    yield from _unknown_keys(where, profile, known)
    yield from _numbers(where, profile)
    yield from _placeholders(where, profile, known.floor_topics)
    yield from _refusals(where, profile)
    yield from _pauses(where, profile)
    yield from _settings(where, profile, kind)


def _pauses(where: str, profile: Profile) -> Iterator[str]:
    for key in ("pause", "resume"):
        type_ = profile.service_types.get(key, "")
        if any(same_type(type_, other) for other in TAKE_FIELDS):
            remedy = "name a service of std_srvs/Trigger or std_srvs/Empty"
            yield f"{where}.service_types.{key}: a {key} can't fill the fields of {type_}: {remedy}"


def _unknown_keys(where: str, profile: Profile, known: Vocabulary) -> Iterator[str]:
    fields = {f"{message}.{field}" for message, names in known.fields.items() for field in names}
    tables: tuple[tuple[str, Mapping[str, object], object], ...] = (
        ("topics", profile.topics, known.topics),
        ("types", profile.types, known.topics),
        ("services", profile.services, known.services),
        ("service_types", profile.service_types, known.services),
        ("actions", profile.actions, known.actions),
        ("action_types", profile.action_types, known.actions),
        ("requests", profile.requests, known.requests),
        ("answers", profile.answers, known.answers),
        ("fields", profile.fields, fields),
        ("scales", profile.scales, known.scales),
        ("silence", profile.silence, set(known.topics) - known.floor_topics),
    )
    for table, given, names in tables:
        assert isinstance(names, Mapping | set | frozenset)
        for key in given:
            if key not in names:
                yield f"{where}.{table}.{key}: unknown key{did_you_mean(key, names)}"


def _numbers(where: str, profile: Profile) -> Iterator[str]:
    for key, scale in profile.scales.items():
        if not 0.0 < scale < math.inf:
            yield f"{where}.scales.{key}: {scale:g} is not a factor: use a number above 0"
    for key, seconds in profile.silence.items():
        if not seconds > 0.0:
            yield f"{where}.silence.{key}: {seconds:g} is not a duration: use seconds above 0"


def _refusals(where: str, profile: Profile) -> Iterator[str]:
    for n, pattern in enumerate(profile.refusals or ()):
        try:
            re.compile(pattern)
        except (re.error, OverflowError, RecursionError) as problem:
            yield f"{where}.refusals[{n}]: {pattern!r} is not a regular expression: {problem}"


def _placeholders(where: str, profile: Profile, floor_topics: frozenset[str]) -> Iterator[str]:
    tables = (("topics", profile.topics), ("services", profile.services), ("actions", profile.actions))
    for table, given in tables:
        for key, template in given.items():
            for name in re.findall(r"\{([^}]*)\}", template):
                if name not in (("robot", "floor") if key in floor_topics else ("robot",)):
                    yield f"{where}.{table}.{key}: {{{name}}} is not available here"
            if set(re.sub(r"\{[^{}]*\}", "", template)) & set("{}"):
                yield f"{where}.{table}.{key}: {template!r} has a brace without its other one"


def _settings(where: str, profile: Profile, kind: str) -> Iterator[str]:
    """Check the tables that belong to single kinds."""
    for name, table in profile.settings.items():
        struct = KINDS[name].settings if name in KINDS else None
        if name != kind or struct is None:
            yield f"{where}.{name}: not a table of kind {kind}"
            continue
        known = [field.name for field in msgspec.structs.fields(struct)]
        yield from (
            f"{where}.{name}.{key}: unknown key{did_you_mean(key, known)}"
            for key in table
            if key not in known
        )
        try:
            msgspec.convert(table, struct)
        except msgspec.ValidationError as problem:
            yield f"{where}.{name}: {problem}"
